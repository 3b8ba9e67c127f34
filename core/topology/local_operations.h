// SPDX-License-Identifier: GPL-3.0-or-later
//
// The three topological operations on the dual mesh (thesis 2.3, 3.2.2 and, for T3, 3.6), for
// whoever holds its arrays. Each is local, keeps the mesh valid, and is to be asked for only where
// it can be performed.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "mesh/element_measures.h"
#include "mesh/mesh_access.h"
#include "mesh/topological_event.h"
#include "topology/gas_ledger.h"
#include "topology/prolongation.h"

namespace foam {
namespace detail {

/// Whether the loop on the left of h, a bubble's or an outside's, has at least n films.
template <class Mesh> FOAM_HOST_DEVICE bool has_sides(const Mesh& mesh, Half h, int n) {
  int count = 1;
  for (Half k = mesh.next_in_bubble(h); k != h && count < n; k = mesh.next_in_bubble(k)) {
    ++count;
  }
  return count >= n;
}

/// How many films the loop on the left of h can do with: two, or one of a wall that goes from the
/// end of a film on to its image.
template <class Mesh> FOAM_HOST_DEVICE int fewest_sides(const Mesh& mesh, Half h) {
  const Bubble b = mesh.left(h);
  return mesh.solid(b) && is_line(mesh.exterior[b.outside()]) ? 1 : 2;
}

template <class Mesh> FOAM_HOST_DEVICE void add_sides(Mesh& mesh, Bubble bubble, Index n) {
  if (!bubble.is_outside()) {
    mesh.sides[bubble] += n;
  }
}

/// Makes h the half-film by which the bubble on its left is found.
template <class Mesh> FOAM_HOST_DEVICE void represent(Mesh& mesh, Half h) {
  if (!mesh.left(h).is_outside()) {
    mesh.bubble_half[mesh.left(h)] = h;
  }
}

template <class Mesh> FOAM_HOST_DEVICE void remove_film(Mesh& mesh, Film film) {
  mesh.half_junction[film.half()] = kNone;
  mesh.half_junction[film.half().twin()] = kNone;
}

template <class Mesh> FOAM_HOST_DEVICE void remove_junction(Mesh& mesh, Junction j) {
  mesh.junction_half[j] = {kNone, kNone, kNone};
  mesh.put_off_wall(j, mesh.position[j]);
}

template <class Mesh> FOAM_HOST_DEVICE void remove_bubble(Mesh& mesh, Bubble b) {
  mesh.bubble_half[b] = kNone;
}

/// Gives a film the curvature that its bubbles' pressures ask for, up to arcs of 60°.
template <class Mesh> FOAM_HOST_DEVICE void bend_by_pressure(Mesh& mesh, Half h) {
  const double sine =
      mesh.pressure_difference(h) * norm(mesh.chord(h)) / (2 * mesh.tension(h.film()));
  mesh.set_half_angle(h, mesh.wall(h) ? 0 : std::asin(std::clamp(sine, -0.5, 0.5)));
}

/// Whether a junction of three films can hold their tensions.
template <class Mesh>
FOAM_HOST_DEVICE bool can_meet(const Mesh& mesh, const std::array<Half, 3>& halves) {
  return mesh.has_uniform_tension() ||
         can_balance({mesh.tension(halves[0].film()), mesh.tension(halves[1].film()),
                      mesh.tension(halves[2].film())});
}

/// Whether the bubbles at the ends of h are one and the same, in one place: a film between them
/// would cut off what it encloses. On a torus a bubble may lie at both ends as two of its images,
/// which may touch.
template <class Mesh> FOAM_HOST_DEVICE bool encloses_between_ends(const Mesh& mesh, Half h) {
  const Half from = mesh.next_around_junction(h);
  const Half to = mesh.next_around_junction(h.twin());
  if (mesh.left(from) != mesh.left(to)) {
    return false;
  }
  if (!mesh.surroundings.has_images()) {
    return true;
  }
  Wrap along_bubble;
  for (Half k = from; k != to; k = mesh.next_in_bubble(k)) {
    along_bubble = along_bubble + mesh.wrap(k);
  }
  return along_bubble == mesh.wrap(h);
}

/// Whether a junction between these bubbles would lie on a wall, where one film ends.
template <class Mesh, std::size_t N>
FOAM_HOST_DEVICE bool beside_wall(const Mesh& mesh, const std::array<Bubble, N>& bubbles) {
  bool found = false;
  for (const Bubble b : bubbles) {
    found = found || mesh.solid(b);
  }
  return found;
}

/// Where an end of a swapped film comes to lie.
struct SwappedEnd {
  WallPlace place; ///< if it is on a wall
  Vec2 position;   ///< cm
  bool on_wall = false;
};

/// Of the end of h after it is swapped with what lies between two films that end on a wall, if h is
/// the stretch between them: one comes to lie in its middle, the other as far from the wall as it
/// was long.
template <class Mesh> FOAM_APART std::array<SwappedEnd, 2> ends_off_wall(const Mesh& mesh, Half h) {
  const double length = mesh.length(h);
  const WallPlace middle = mesh.place_on_stretch(h, 0.5 * length);
  const Vec2 foot = point_of(mesh, middle);
  const SwappedEnd on{middle, foot, true};
  const SwappedEnd off{{}, foot + length * left_normal(tangent_of(mesh, middle)), false};
  return mesh.solid(mesh.right(h)) ? std::array{off, on} : std::array{on, off};
}

template <class Mesh>
FOAM_HOST_DEVICE void put_end(Mesh& mesh, Junction junction, const SwappedEnd& end) {
  if (end.on_wall) {
    mesh.put_on_wall(junction, end.place);
    mesh.position[junction] = end.position; // or an image of it
  } else {
    mesh.put_off_wall(junction, end.position);
  }
}

/// Whether h is a stretch of an obstacle on which only two films end.
template <class Mesh> FOAM_HOST_DEVICE bool is_one_of_two_stretches(const Mesh& mesh, Half h) {
  if (!mesh.wall(h)) {
    return false;
  }
  const Half along = mesh.solid(mesh.left(h)) ? h : h.twin();
  const Outside wall = mesh.left(along).outside();
  return mesh.next_in_bubble(mesh.next_in_bubble(along)) == along &&
         !is_line(mesh.exterior[wall]) && mesh.area_of_wall(wall) < 0;
}

/// Whether the two films at the ends of h, one of two stretches of an obstacle, can leave it
/// together: they are two.
template <class Mesh> FOAM_HOST_DEVICE bool can_leave_wall(const Mesh& mesh, Half h) {
  const Half e0 = mesh.solid(mesh.left(h)) ? h : h.twin();
  const Half e1 = mesh.next_in_bubble(e0);
  const Half o0 = mesh.off_wall(mesh.start(e0));
  const Half o1 = mesh.off_wall(mesh.start(e1));
  return o0.film() != o1.film() && mesh.end(o0) != mesh.end(o1) && has_sides(mesh, e0.twin(), 4) &&
         has_sides(mesh, e1.twin(), 4);
}

/// Of a film that becomes a stretch of a wall, which its start is on: a half of its length away
/// from there. \param way a stretch from there
template <class Mesh> FOAM_APART SwappedEnd end_along_wall(const Mesh& mesh, Half film, Half way) {
  const double distance = 0.5 * std::min(mesh.length(film), mesh.length(way));
  const WallPlace place = mesh.place_on_stretch(way, distance);
  return {place, point_of(mesh, place), true};
}

} // namespace detail

/// Whether the film can be swapped: those that lose a side keep enough, the two bubbles that gain
/// one differ, or are two images of one, its ends may come together, and the new junctions can hold
/// the tensions of their films. Or whether a film can leave a wall with it (leave_wall).
template <class Mesh> FOAM_HOST_DEVICE bool can_perform_t1(const Mesh& mesh, Film film) {
  if (!mesh.may_close(film)) {
    return false;
  }
  const Half h = film.half();
  if (detail::is_one_of_two_stretches(mesh, h)) {
    return detail::can_leave_wall(mesh, h);
  }
  const Half t = h.twin();
  const Half h1 = mesh.next_around_junction(h);
  const Half t1 = mesh.next_around_junction(t);
  const Half h2 = mesh.previous_around_junction(h);
  const Half t2 = mesh.previous_around_junction(t);
  const Bubble at_start = mesh.left(h1);
  const Bubble at_end = mesh.left(t1);
  const int lost = mesh.left(h) == mesh.right(h) ? 2 : 1;
  const auto holds = [&](Bubble beside, const std::array<Half, 3>& halves) {
    return detail::beside_wall(mesh, std::array{at_start, at_end, beside}) ||
           detail::can_meet(mesh, halves);
  };
  return !detail::encloses_between_ends(mesh, h) &&
         detail::has_sides(mesh, h, detail::fewest_sides(mesh, h) + lost) &&
         detail::has_sides(mesh, t, detail::fewest_sides(mesh, t) + lost) &&
         holds(mesh.left(h), {h, t2, h1}) && holds(mesh.right(h), {t, h2, t1});
}

namespace detail {

/// Makes one film of two that end in a two-sided loop of films, a bubble's or a wall's: the one
/// that leaves the start of e0, the loop's half-film. \returns it
template <class Mesh> FOAM_APART Half join_across(Mesh& mesh, Half e0) {
  const Half e1 = mesh.next_in_bubble(e0);
  const std::array neighbours{mesh.right(e0), mesh.right(e1)};
  const Junction j0 = mesh.start(e0);
  const Junction j1 = mesh.start(e1);
  const Half o0 = mesh.previous_around_junction(e0);
  const Half o1 = mesh.previous_around_junction(e1);
  const Junction end = mesh.end(o1);
  mesh.set_wrap(o0, mesh.wrap(o0) - mesh.wrap(e0) - mesh.wrap(o1));
  mesh.half_junction[o0] = end;
  for (Half& half : mesh.junction_half[end]) {
    half = half == o1.twin() ? o0 : half;
  }
  for (const Half h : {e0, e1, o1}) {
    remove_film(mesh, h.film());
  }
  remove_junction(mesh, j0);
  remove_junction(mesh, j1);
  represent(mesh, o0);
  represent(mesh, o0.twin());
  for (const Bubble neighbour : neighbours) {
    add_sides(mesh, neighbour, -2);
  }
  return o0;
}

/// Lets the two films that end on an obstacle leave it as one, behind which it lies in the bubble
/// beside the other of its two stretches. \param h the one that has vanished \returns the two
/// bubbles along the film
template <class Mesh> FOAM_APART std::array<Bubble, 2> leave_wall(Mesh& mesh, Half h) {
  const Half e0 = mesh.solid(mesh.left(h)) ? h : h.twin();
  const Bubble wall = mesh.left(e0);
  const Bubble host = mesh.right(mesh.next_in_bubble(e0));
  const Half film = join_across(mesh, e0);
  mesh.exterior[wall.outside()].host = host;
  bend_by_pressure(mesh, film);
  return {mesh.left(film), mesh.right(film)};
}

} // namespace detail

/// What swap_film() is about to do.
template <class Mesh> FOAM_HOST_DEVICE TopologicalOperation swap_of(const Mesh& mesh, Film film) {
  const Half h = film.half();
  return {.kind = TopologicalOperation::Kind::T1,
          .place = mesh.position[mesh.start(h)] + 0.5 * mesh.chord(h),
          .bubbles = {mesh.left(h), mesh.right(h), mesh.left(mesh.next_around_junction(h)),
                      mesh.left(mesh.next_around_junction(h.twin()))}};
}

/// What the removal of a bubble of two or three sides is about to do.
template <class Mesh>
FOAM_HOST_DEVICE TopologicalOperation removal_of(const Mesh& mesh, Bubble bubble) {
  TopologicalOperation removal;
  const Half first = mesh.bubble_half[bubble];
  const Index sides = mesh.sides[bubble];
  removal.kind = sides == 3 ? TopologicalOperation::Kind::T2 : TopologicalOperation::Kind::T3;
  removal.bubbles[0] = bubble;
  Vec2 from_first; // of a corner
  Vec2 sum;
  Half h = first;
  for (Index side = 0; side < sides; ++side, h = mesh.next_in_bubble(h)) {
    removal.bubbles[1 + static_cast<std::size_t>(side)] = mesh.right(h);
    sum += from_first;
    from_first += mesh.chord(h);
  }
  removal.place = mesh.position[mesh.start(first)] + (1.0 / sides) * sum;
  return removal;
}

/// Swaps a film (thesis Figure 3.3): the two bubbles at its ends become neighbours, the two along
/// it part. The new film lies across the old one, has its chord's length and its tension, and takes
/// the curvature of its bubbles' pressures. A film that ends on a wall becomes a stretch of the
/// wall, and a stretch of a wall a film that ends there, but the last but one of an obstacle, with
/// which a film leaves it (leave_wall). \returns the two bubbles that lost a side, one of which may
/// be an outside.
template <class Mesh> FOAM_HOST_DEVICE std::array<Bubble, 2> swap_film(Mesh& mesh, Film film) {
  const Half h = film.half();
  if (detail::is_one_of_two_stretches(mesh, h)) {
    return detail::leave_wall(mesh, h);
  }
  const Half t = h.twin();
  const Junction a = mesh.start(h);
  const Junction b = mesh.start(t);
  const Half h1 = mesh.next_around_junction(h);
  const Half h2 = mesh.previous_around_junction(h);
  const Half t1 = mesh.next_around_junction(t);
  const Half t2 = mesh.previous_around_junction(t);
  const std::array parted{mesh.left(h), mesh.right(h)};
  const Bubble at_start = mesh.left(h1);
  const Bubble at_end = mesh.left(t1);
  const Vec2 chord = mesh.chord(h);
  const Vec2 at_a = mesh.position[a];
  const Vec2 to_b = mesh.position[b] - (at_a + chord); // a period, on a torus
  std::array<detail::SwappedEnd, 2> ends{};            // of h, in the frame of its start
  if (mesh.wall(h)) {
    ends = detail::ends_off_wall(mesh, h);
  } else if (mesh.solid(at_start)) {
    ends = {detail::end_along_wall(mesh, h, h1), detail::end_along_wall(mesh, h, h2)};
  } else if (mesh.solid(at_end)) {
    ends = {detail::end_along_wall(mesh, h, t2), detail::end_along_wall(mesh, h, t1)};
    ends[0].position -= to_b;
    ends[1].position -= to_b;
  } else {
    const Vec2 middle = at_a + 0.5 * chord;
    ends[0].position = middle + 0.5 * left_normal(chord);
    ends[1].position = ends[0].position - left_normal(chord);
  }

  const Wrap along = mesh.wrap(h);
  mesh.half_bubble[h] = at_end;
  mesh.half_bubble[t] = at_start;
  mesh.set_wrap(t2, mesh.wrap(t2) + along);
  mesh.set_wrap(h2, mesh.wrap(h2) - along);
  mesh.half_junction[t2] = a;
  mesh.half_junction[h2] = b;
  mesh.junction_half[a] = {h, t2, h1};
  mesh.junction_half[b] = {t, h2, t1};
  detail::represent(mesh, t2);
  detail::represent(mesh, h2);
  detail::add_sides(mesh, parted[0], -1);
  detail::add_sides(mesh, parted[1], -1);
  detail::add_sides(mesh, at_start, 1);
  detail::add_sides(mesh, at_end, 1);

  detail::put_end(mesh, a, ends[0]);
  ends[1].position += to_b;
  detail::put_end(mesh, b, ends[1]);
  detail::bend_by_pressure(mesh, h);
  return parted;
}

/// Whether the bubble has three sides, its neighbours can spare one each, and the three films that
/// are to meet are three and can hold each other's tensions.
template <class Mesh> FOAM_HOST_DEVICE bool can_perform_t2(const Mesh& mesh, Bubble bubble) {
  if (!mesh.has_bubble(bubble) || mesh.sides[bubble] != 3) {
    return false;
  }
  bool possible = !(mesh.surroundings.has_walls() && mesh.hosts_wall(bubble));
  std::array<Half, 3> outer{};
  std::array<Bubble, 3> neighbours{};
  std::size_t k = 0;
  for_each_half(mesh, bubble, [&](Half h) {
    outer[k] = mesh.previous_around_junction(h);
    neighbours[k] = mesh.right(h);
    ++k;
  });
  k = 0;
  for_each_half(mesh, bubble, [&](Half h) {
    int lost = 0;
    for (const Bubble neighbour : neighbours) {
      lost += neighbour == neighbours[k] ? 1 : 0;
    }
    possible = possible && neighbours[k] != bubble &&
               (outer[k].film() != outer[(k + 1) % 3].film() || mesh.wall(outer[k])) &&
               detail::has_sides(mesh, h.twin(), detail::fewest_sides(mesh, h.twin()) + lost);
    ++k;
  });
  return possible && (detail::beside_wall(mesh, neighbours) || detail::can_meet(mesh, outer));
}

/// What is new after a T2: the three films that were prolonged and the bubbles between them.
struct T2Result {
  std::array<Film, 3> films;
  std::array<Bubble, 3> bubbles;
};

/// Removes a three-sided bubble (thesis Figure 3.4). Its three outer films are prolonged along
/// their arcs until they meet, which in equilibrium, all tensions being equal, they do in one point
/// and at 120° (decoration theorem: D. Weaire, Phil. Mag. Lett. 79 (1999) 491); the rest of the
/// foam stays in equilibrium when the neighbours' target areas grow by what they gain, and so they
/// do here: no gas is lost but to an outside. Where the arcs do not meet, as with other tensions,
/// the new junction is the point nearest to all three, or else the mean of the bubble's corners. Of
/// a bubble on a wall the one film that leaves it is prolonged until it meets the wall: by mirror
/// symmetry that is a two-sided bubble that vanishes.
template <class Mesh>
FOAM_HOST_DEVICE T2Result remove_three_sided_bubble(Mesh& mesh, Bubble bubble) {
  std::array<Half, 3> inner{};      // the bubble's half-films
  std::array<Half, 3> outer{};      // the film that leaves each one's start
  std::array<Junction, 3> corner{}; // its start
  T2Result result{};
  {
    std::size_t k = 0;
    for_each_half(mesh, bubble, [&](Half h) {
      inner[k] = h;
      outer[k] = mesh.previous_around_junction(h);
      corner[k] = mesh.start(h);
      result.films[k] = outer[k].film();
      result.bubbles[k] = mesh.right(h);
      ++k;
    });
  }
  const detail::GasLedger<3> gas(mesh, bubble, result.bubbles);

  const Vec2 origin = mesh.position[corner[0]];
  const std::array<Vec2, 3> offset{Vec2{}, mesh.chord(inner[0]), -mesh.chord(inner[2])};
  const Vec2 mean = origin + (1.0 / 3) * (offset[1] + offset[2]);
  std::array<detail::Circle, 3> circles{};
  std::array<Vec2, 3> chord{};
  for (std::size_t k = 0; k < 3; ++k) {
    chord[k] = mesh.chord(outer[k]);
    circles[k] = {origin + offset[k], mesh.tangent(outer[k]),
                  arc_curvature(norm(chord[k]), mesh.half_angle(outer[k]))};
  }
  const double size = norm(offset[1]) + norm(offset[2]) + norm(offset[2] - offset[1]);

  detail::SwappedEnd meeting;
  meeting.position = detail::common_point(circles, mean, size);
  for (std::size_t k = 0; k < 3; ++k) {
    if (mesh.solid(result.bubbles[k])) {
      detail::Circle circle = circles[(k + 2) % 3];
      circle.point += mesh.position[corner[k]] - (origin + offset[k]); // a period, in a channel
      meeting.place = detail::cut_of_wall(mesh, circle, inner[k]);
      meeting.position =
          point_of(mesh, meeting.place) - mesh.position[corner[k]] + origin + offset[k];
      meeting.on_wall = true;
    }
  }

  const std::array<Wrap, 3> to_corner{Wrap{}, mesh.wrap(inner[0]), -mesh.wrap(inner[2])};
  for (std::size_t k = 1; k < 3; ++k) {
    mesh.set_wrap(outer[k], mesh.wrap(outer[k]) + to_corner[k]);
    mesh.half_junction[outer[k]] = corner[0];
    detail::remove_junction(mesh, corner[k]);
  }
  mesh.junction_half[corner[0]] = outer;
  detail::put_end(mesh, corner[0], meeting);
  for (std::size_t k = 0; k < 3; ++k) {
    detail::remove_film(mesh, inner[k].film());
    detail::represent(mesh, outer[k]);
    detail::add_sides(mesh, result.bubbles[k], -1);
    const Vec2 new_chord = origin + offset[k] + chord[k] - meeting.position;
    mesh.set_half_angle(outer[k], mesh.wall(outer[k])
                                      ? 0
                                      : detail::prolonged_half_angle(mesh.half_angle(outer[k]),
                                                                     chord[k], new_chord));
  }
  detail::remove_bubble(mesh, bubble);
  gas.share_out(mesh);
  return result;
}

/// Whether the bubble has two sides and is not one of a double bubble, and the film that remains
/// joins two junctions and can hold its tension where the other one ended.
template <class Mesh> FOAM_HOST_DEVICE bool can_perform_t3(const Mesh& mesh, Bubble bubble) {
  if (!mesh.has_bubble(bubble) || mesh.sides[bubble] != 2) {
    return false;
  }
  const Half e0 = mesh.bubble_half[bubble];
  const Half e1 = mesh.next_in_bubble(e0);
  const Half remaining = mesh.previous_around_junction(e0);
  const Half end = mesh.previous_around_junction(e1).twin();
  const int lost = mesh.right(e0) == mesh.right(e1) ? 4 : 2;
  const auto spares = [&](Half h) {
    return detail::has_sides(mesh, h, detail::fewest_sides(mesh, h) + lost);
  };
  return !(mesh.surroundings.has_walls() && mesh.hosts_wall(bubble)) && spares(e0.twin()) &&
         spares(e1.twin()) && (mesh.end(remaining) != mesh.start(end) || mesh.wall(remaining)) &&
         (mesh.on_wall(mesh.start(end)) ||
          detail::can_meet(mesh, {remaining, mesh.next_around_junction(end),
                                  mesh.previous_around_junction(end)}));
}

/// Removes a two-sided bubble: the film that it floats on closes behind it, an arc of one circle in
/// equilibrium. Of its two pieces the one remains that leaves the start of the bubble's half-film,
/// with its tension. The bubble's two neighbours' target areas grow by what they gain.
/// \returns the two neighbours.
template <class Mesh>
FOAM_HOST_DEVICE std::array<Bubble, 2> remove_two_sided_bubble(Mesh& mesh, Bubble bubble) {
  const Half e0 = mesh.bubble_half[bubble];
  const std::array neighbours{mesh.right(e0), mesh.right(mesh.next_in_bubble(e0))};
  const Half remaining = mesh.previous_around_junction(e0);
  const Vec2 old_chord = mesh.chord(remaining);
  const detail::GasLedger<2> gas(mesh, bubble, neighbours);

  detail::join_across(mesh, e0);
  mesh.set_half_angle(remaining, mesh.wall(remaining) ? 0
                                                      : detail::prolonged_half_angle(
                                                            mesh.half_angle(remaining), old_chord,
                                                            mesh.chord(remaining)));
  detail::remove_bubble(mesh, bubble);
  gas.share_out(mesh);
  return neighbours;
}

/// Slides a two-sided bubble along the shorter of the two films that end in it, until that film is
/// `distance` (cm) long (thesis 3.6.1). Does nothing if it is that short already.
template <class Mesh>
FOAM_HOST_DEVICE void slide_two_sided_bubble(Mesh& mesh, Bubble bubble, double distance) {
  const Half e0 = mesh.bubble_half[bubble];
  const Half e1 = mesh.next_in_bubble(e0);
  Half ahead = mesh.previous_around_junction(e0);
  Half behind = mesh.previous_around_junction(e1);
  if (mesh.length(behind) < mesh.length(ahead)) {
    std::swap(ahead, behind);
  }
  const double length = mesh.length(ahead);
  const double way = length - distance;
  if (way <= 0 || mesh.start(ahead) == mesh.end(behind)) {
    return;
  }
  // The bubble's junctions turn about the centre of the circle that both films lie on (3.6.3); the
  // film ahead is shortened from its near end, the film behind prolonged.
  const double alpha = mesh.half_angle(ahead);
  const double turn = 2 * alpha * way / length;
  const Vec2 move = arc_point({}, mesh.chord(ahead), alpha, way / length);
  const Junction front = mesh.start(ahead);
  const Junction back = mesh.start(behind);
  const Vec2 across = mesh.chord(front == mesh.start(e0) ? e0 : e1);
  const Vec2 back_chord = mesh.chord(behind);
  const Vec2 back_move = move + rotated(across, turn) - across;
  mesh.position[front] += move;
  mesh.position[back] += back_move;
  mesh.set_half_angle(ahead, alpha - 0.5 * turn);
  mesh.set_half_angle(behind, detail::prolonged_half_angle(mesh.half_angle(behind), back_chord,
                                                           back_chord - back_move));
}

} // namespace foam
