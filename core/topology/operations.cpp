// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/operations.h"

#include <algorithm>
#include <cassert>
#include <cmath>
#include <optional>

#include "mesh/validate.h"

namespace foam {
namespace {

/// Whether the loop on the left of h, a bubble's or the world's, has at least n films.
bool has_sides(const Foam& foam, Index h, int n) {
  int count = 1;
  for (Index k = foam.next_in_bubble(h); k != h && count < n; k = foam.next_in_bubble(k)) {
    ++count;
  }
  return count >= n;
}

void add_sides(Foam& foam, Index bubble, Index n) {
  if (bubble != kWorld) {
    foam.sides[Foam::size(bubble)] += n;
  }
}

/// Makes h the half-film by which the bubble on its left is found.
void represent(Foam& foam, Index h) {
  if (foam.left(h) != kWorld) {
    foam.bubble_half[Foam::size(foam.left(h))] = h;
  }
}

void remove_film(Foam& foam, Index film) {
  foam.half_junction[Foam::size(2 * film)] = kNone;
  foam.half_junction[Foam::size(2 * film + 1)] = kNone;
}

void remove_junction(Foam& foam, Index j) {
  foam.junction_half[Foam::size(j)] = {kNone, kNone, kNone};
}

void remove_bubble(Foam& foam, Index b) {
  foam.bubble_half[Foam::size(b)] = kNone;
}

/// The half-angle of a film after its start has moved while its end, and its direction there,
/// stayed. Straight where that is no prolongation: the start has moved past the end, or all around.
double prolonged_half_angle(double half_angle, Vec2 old_chord, Vec2 new_chord) {
  constexpr double kWidest = 3;
  const double prolonged = half_angle - angle_from_to(old_chord, new_chord);
  return dot(old_chord, new_chord) > 0 && std::abs(prolonged) < kWidest ? prolonged : 0;
}

/// Shares out the gas of a bubble that is removed: each neighbour's target area grows by what the
/// neighbour itself gains, and by an equal share of what the bubble's area lacked of its target.
template <std::size_t N> class GasLedger {
public:
  GasLedger(const Foam& foam, Index removed, const std::array<Index, N>& neighbours)
      : neighbours_(neighbours),
        share_((foam.target_area[Foam::size(removed)] - foam.area(removed)) /
               (N - static_cast<double>(std::ranges::count(neighbours, kWorld)))) {
    for (std::size_t i = 0; i < N; ++i) {
      before_[i] = neighbours[i] == kWorld ? 0 : foam.area(neighbours[i]);
    }
  }
  void share_out(Foam& foam) const {
    for (std::size_t i = 0; i < N; ++i) {
      const Index b = neighbours_[i];
      if (b != kWorld) {
        const bool seen =
            std::find(neighbours_.begin(), neighbours_.begin() + i, b) != neighbours_.begin() + i;
        foam.target_area[Foam::size(b)] += share_ + (seen ? 0 : foam.area(b) - before_[i]);
      }
    }
  }

private:
  std::array<Index, N> neighbours_;
  double share_;
  std::array<double, N> before_{};
};

/// A circle (or line) through a point, by tangent and curvature; > 0 bends to the left.
struct Circle {
  Vec2 point, tangent;
  double curvature = 0;

  /// Zero on the circle; its gradient has unit length there.
  double value(Vec2 x) const {
    const Vec2 r = x - point;
    return dot(left_normal(tangent), r) - 0.5 * curvature * dot(r, r);
  }
  Vec2 gradient(Vec2 x) const { return left_normal(tangent) - curvature * (x - point); }
};

/// The common point of three circles nearest to `start`, by Gauss–Newton on their equations.
std::optional<Vec2> common_point(const std::array<Circle, 3>& circles, Vec2 start, double size) {
  Vec2 x = start;
  for (int iteration = 0; iteration < 32; ++iteration) {
    double a = 0, b = 0, c = 0;
    Vec2 rhs;
    for (const Circle& circle : circles) {
      const Vec2 g = circle.gradient(x);
      a += g.x * g.x;
      b += g.x * g.y;
      c += g.y * g.y;
      rhs -= circle.value(x) * g;
    }
    const double determinant = a * c - b * b;
    if (!(determinant > 1e-6)) {
      return std::nullopt;
    }
    const Vec2 step{(c * rhs.x - b * rhs.y) / determinant, (a * rhs.y - b * rhs.x) / determinant};
    x += step;
    if (norm(x - start) > size) {
      return std::nullopt;
    }
    if (norm(step) < 1e-15 * size) {
      break;
    }
  }
  return x;
}

/// The one contact that replaces the middle two of four along a wall, so that the container keeps
/// its area.
Vec2 merged_contact(const std::array<Vec2, 4>& wall) {
  const Vec2 base = wall[3] - wall[0];
  const Vec2 middle = 0.5 * (wall[1] + wall[2]) - wall[0];
  const double twice_area =
      cross(wall[1] - wall[0], wall[2] - wall[0]) + cross(wall[2] - wall[0], base);
  const double rise = (cross(middle, base) - twice_area) / dot(base, base);
  return wall[0] + middle + rise * left_normal(base);
}

} // namespace

bool can_perform_t1(const Foam& foam, Index film) {
  const Index h = 2 * film;
  if (!foam.has_film(film) || foam.wall(h)) {
    return false;
  }
  const Index at_start = foam.left(foam.next_around_junction(h));
  const Index at_end = foam.left(foam.next_around_junction(Foam::twin(h)));
  return at_start != at_end && has_sides(foam, h, 3) && has_sides(foam, Foam::twin(h), 3);
}

std::array<Index, 2> perform_t1(Foam& foam, Index film) {
  const Index h = 2 * film;
  const Index t = h + 1;
  const Index a = foam.start(h);
  const Index b = foam.start(t);
  const Index h1 = foam.next_around_junction(h);
  const Index h2 = foam.previous_around_junction(h);
  const Index t1 = foam.next_around_junction(t);
  const Index t2 = foam.previous_around_junction(t);
  const std::array parted{foam.left(h), foam.right(h)};
  const Index at_start = foam.left(h1);
  const Index at_end = foam.left(t1);
  const Vec2 chord = foam.chord(h);
  const Vec2 at_a = foam.position[Foam::size(a)];
  const Vec2 to_b = foam.position[Foam::size(b)] - (at_a + chord); // a period, on a torus
  Vec2 new_a = at_a + 0.5 * chord + 0.5 * left_normal(chord);
  Vec2 new_b = new_a - left_normal(chord);
  const auto along_wall = [&](Index wall) {
    const Vec2 way = foam.chord(wall);
    return std::min(norm(chord) / norm(way), 0.5) * way;
  };
  if (foam.boundary == Boundary::Fixed && at_start == kWorld) {
    new_a = at_a;
    new_b = at_a + along_wall(h2);
  } else if (foam.boundary == Boundary::Fixed && at_end == kWorld) {
    new_b = at_a + chord;
    new_a = new_b + along_wall(t2);
  }

  const Wrap along = foam.wrap(h);
  foam.half_bubble[Foam::size(h)] = at_end;
  foam.half_bubble[Foam::size(t)] = at_start;
  foam.set_wrap(t2, foam.wrap(t2) + along);
  foam.set_wrap(h2, foam.wrap(h2) - along);
  foam.half_junction[Foam::size(t2)] = a;
  foam.half_junction[Foam::size(h2)] = b;
  foam.junction_half[Foam::size(a)] = {h, t2, h1};
  foam.junction_half[Foam::size(b)] = {t, h2, t1};
  represent(foam, t2);
  represent(foam, h2);
  add_sides(foam, parted[0], -1);
  add_sides(foam, parted[1], -1);
  add_sides(foam, at_start, 1);
  add_sides(foam, at_end, 1);

  foam.position[Foam::size(a)] = new_a;
  foam.position[Foam::size(b)] = new_b + to_b;
  const double q = foam.pressure_of(at_end) - foam.pressure_of(at_start);
  const double sine = q * norm(chord) / (4 * foam.surface_tension);
  foam.set_half_angle(h, foam.wall(h) ? 0 : std::asin(std::clamp(sine, -0.5, 0.5)));
  ++foam.t1_count;
  ++foam.topology;
  assert(validate(foam).empty());
  return parted;
}

bool can_perform_t2(const Foam& foam, Index bubble) {
  if (!foam.has_bubble(bubble) || foam.sides[Foam::size(bubble)] != 3) {
    return false;
  }
  bool possible = true;
  for_each_half(foam, bubble, [&](Index h) {
    possible = possible && foam.right(h) != bubble && has_sides(foam, Foam::twin(h), 3);
  });
  return possible;
}

T2Result perform_t2(Foam& foam, Index bubble) {
  std::array<Index, 3> inner{};  // the bubble's half-films
  std::array<Index, 3> outer{};  // the film that leaves each one's start
  std::array<Index, 3> corner{}; // its start
  T2Result result{};
  {
    std::size_t k = 0;
    for_each_half(foam, bubble, [&](Index h) {
      inner[k] = h;
      outer[k] = foam.previous_around_junction(h);
      corner[k] = foam.start(h);
      result.films[k] = Foam::film_of(outer[k]);
      result.bubbles[k] = foam.right(h);
      ++k;
    });
  }
  const GasLedger<3> gas(foam, bubble, result.bubbles);

  const Vec2 origin = foam.position[Foam::size(corner[0])];
  const std::array<Vec2, 3> offset{Vec2{}, foam.chord(inner[0]), -foam.chord(inner[2])};
  const Vec2 mean = origin + (1.0 / 3) * (offset[1] + offset[2]);
  std::array<Circle, 3> circles{};
  std::array<Vec2, 3> chord{};
  for (std::size_t k = 0; k < 3; ++k) {
    chord[k] = foam.chord(outer[k]);
    circles[k] = {origin + offset[k], foam.tangent(outer[k]),
                  arc_curvature(norm(chord[k]), foam.half_angle(outer[k]))};
  }
  const double size = norm(offset[1]) + norm(offset[2]) + norm(offset[2] - offset[1]);

  Vec2 meeting = common_point(circles, mean, size).value_or(mean);
  for (std::size_t k = 0; k < 3; ++k) {
    if (foam.boundary == Boundary::Fixed && result.bubbles[k] == kWorld) {
      const std::size_t next = (k + 1) % 3;
      const Vec2 begin = origin + offset[k];
      const Vec2 end = origin + offset[next];
      meeting = merged_contact({begin + chord[k], begin, end, end + chord[next]});
    }
  }

  const std::array<Wrap, 3> to_corner{Wrap{}, foam.wrap(inner[0]), -foam.wrap(inner[2])};
  for (std::size_t k = 1; k < 3; ++k) {
    foam.set_wrap(outer[k], foam.wrap(outer[k]) + to_corner[k]);
    foam.half_junction[Foam::size(outer[k])] = corner[0];
    remove_junction(foam, corner[k]);
  }
  foam.junction_half[Foam::size(corner[0])] = outer;
  foam.position[Foam::size(corner[0])] = meeting;
  for (std::size_t k = 0; k < 3; ++k) {
    remove_film(foam, Foam::film_of(inner[k]));
    represent(foam, outer[k]);
    add_sides(foam, result.bubbles[k], -1);
    const Vec2 new_chord = origin + offset[k] + chord[k] - meeting;
    foam.set_half_angle(outer[k],
                        foam.wall(outer[k])
                            ? 0
                            : prolonged_half_angle(foam.half_angle(outer[k]), chord[k], new_chord));
  }
  remove_bubble(foam, bubble);
  gas.share_out(foam);
  ++foam.t2_count;
  ++foam.topology;
  assert(validate(foam).empty());
  return result;
}

bool can_perform_t3(const Foam& foam, Index bubble) {
  if (!foam.has_bubble(bubble) || foam.sides[Foam::size(bubble)] != 2) {
    return false;
  }
  const Index h = foam.bubble_half[Foam::size(bubble)];
  return has_sides(foam, Foam::twin(h), 4) &&
         has_sides(foam, Foam::twin(foam.next_in_bubble(h)), 4);
}

std::array<Index, 2> perform_t3(Foam& foam, Index bubble) {
  const Index e0 = foam.bubble_half[Foam::size(bubble)];
  const Index e1 = foam.next_in_bubble(e0);
  const std::array neighbours{foam.right(e0), foam.right(e1)};
  const Index j0 = foam.start(e0);
  const Index j1 = foam.start(e1);
  const Index o0 = foam.previous_around_junction(e0);
  const Index o1 = foam.previous_around_junction(e1);
  const GasLedger<2> gas(foam, bubble, neighbours);

  const Index end = foam.end(o1);
  const Vec2 old_chord = foam.chord(o0);
  const Vec2 chord = old_chord - foam.chord(e0) - foam.chord(o1);
  foam.set_wrap(o0, foam.wrap(o0) - foam.wrap(e0) - foam.wrap(o1));
  foam.half_junction[Foam::size(o0)] = end;
  std::ranges::replace(foam.junction_half[Foam::size(end)], Foam::twin(o1), o0);
  foam.set_half_angle(
      o0, foam.wall(o0) ? 0 : prolonged_half_angle(foam.half_angle(o0), old_chord, chord));

  for (const Index h : {e0, e1, o1}) {
    remove_film(foam, Foam::film_of(h));
  }
  remove_junction(foam, j0);
  remove_junction(foam, j1);
  remove_bubble(foam, bubble);
  represent(foam, o0);
  represent(foam, Foam::twin(o0));
  for (const Index neighbour : neighbours) {
    add_sides(foam, neighbour, -2);
  }
  gas.share_out(foam);
  ++foam.t3_count;
  ++foam.topology;
  assert(validate(foam).empty());
  return neighbours;
}

void slide_two_sided_bubble(Foam& foam, Index bubble, double distance) {
  const Index e0 = foam.bubble_half[Foam::size(bubble)];
  const Index e1 = foam.next_in_bubble(e0);
  Index ahead = foam.previous_around_junction(e0);
  Index behind = foam.previous_around_junction(e1);
  if (foam.length(behind) < foam.length(ahead)) {
    std::swap(ahead, behind);
  }
  const double length = foam.length(ahead);
  const double way = length - distance;
  if (way <= 0 || foam.start(ahead) == foam.end(behind)) {
    return;
  }
  // The bubble's junctions turn about the centre of the circle that both films lie on (3.6.3); the
  // film ahead is shortened from its near end, the film behind prolonged.
  const double alpha = foam.half_angle(ahead);
  const double turn = 2 * alpha * way / length;
  const Vec2 move = arc_point({}, foam.chord(ahead), alpha, way / length);
  const Index front = foam.start(ahead);
  const Index back = foam.start(behind);
  const Vec2 across = foam.chord(front == foam.start(e0) ? e0 : e1);
  const Vec2 back_chord = foam.chord(behind);
  const Vec2 back_move = move + rotated(across, turn) - across;
  foam.position[Foam::size(front)] += move;
  foam.position[Foam::size(back)] += back_move;
  foam.set_half_angle(ahead, alpha - 0.5 * turn);
  foam.set_half_angle(
      behind, prolonged_half_angle(foam.half_angle(behind), back_chord, back_chord - back_move));
}

} // namespace foam
