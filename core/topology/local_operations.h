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

#include "mesh/mesh_access.h"
#include "topology/gas_ledger.h"
#include "topology/prolongation.h"

namespace foam {
namespace detail {

/// Whether the loop on the left of h, a bubble's or the world's, has at least n films.
template <class Mesh> FOAM_HOST_DEVICE bool has_sides(const Mesh& mesh, Index h, int n) {
  int count = 1;
  for (Index k = mesh.next_in_bubble(h); k != h && count < n; k = mesh.next_in_bubble(k)) {
    ++count;
  }
  return count >= n;
}

template <class Mesh> FOAM_HOST_DEVICE void add_sides(Mesh& mesh, Index bubble, Index n) {
  if (bubble != kWorld) {
    mesh.sides[Mesh::size(bubble)] += n;
  }
}

/// Makes h the half-film by which the bubble on its left is found.
template <class Mesh> FOAM_HOST_DEVICE void represent(Mesh& mesh, Index h) {
  if (mesh.left(h) != kWorld) {
    mesh.bubble_half[Mesh::size(mesh.left(h))] = h;
  }
}

template <class Mesh> FOAM_HOST_DEVICE void remove_film(Mesh& mesh, Index film) {
  mesh.half_junction[Mesh::size(2 * film)] = kNone;
  mesh.half_junction[Mesh::size(2 * film + 1)] = kNone;
}

template <class Mesh> FOAM_HOST_DEVICE void remove_junction(Mesh& mesh, Index j) {
  mesh.junction_half[Mesh::size(j)] = {kNone, kNone, kNone};
}

template <class Mesh> FOAM_HOST_DEVICE void remove_bubble(Mesh& mesh, Index b) {
  mesh.bubble_half[Mesh::size(b)] = kNone;
}

} // namespace detail

/// Whether the film can be swapped: the two bubbles that lose a side keep two, the two that gain
/// one differ, and the film is no piece of a container's wall.
template <class Mesh> FOAM_HOST_DEVICE bool can_perform_t1(const Mesh& mesh, Index film) {
  const Index h = 2 * film;
  if (!mesh.has_film(film) || mesh.wall(h)) {
    return false;
  }
  const Index at_start = mesh.left(mesh.next_around_junction(h));
  const Index at_end = mesh.left(mesh.next_around_junction(Mesh::twin(h)));
  return at_start != at_end && detail::has_sides(mesh, h, 3) &&
         detail::has_sides(mesh, Mesh::twin(h), 3);
}

/// Swaps a film (thesis Figure 3.3): the two bubbles at its ends become neighbours, the two along
/// it part. The new film lies across the old one, has its chord's length, and takes the curvature
/// of its bubbles' pressures; beside a container's wall it becomes a piece of the wall. \returns
/// the two bubbles that lost a side (the world among them as kWorld).
template <class Mesh> FOAM_HOST_DEVICE std::array<Index, 2> swap_film(Mesh& mesh, Index film) {
  const Index h = 2 * film;
  const Index t = h + 1;
  const Index a = mesh.start(h);
  const Index b = mesh.start(t);
  const Index h1 = mesh.next_around_junction(h);
  const Index h2 = mesh.previous_around_junction(h);
  const Index t1 = mesh.next_around_junction(t);
  const Index t2 = mesh.previous_around_junction(t);
  const std::array parted{mesh.left(h), mesh.right(h)};
  const Index at_start = mesh.left(h1);
  const Index at_end = mesh.left(t1);
  const Vec2 chord = mesh.chord(h);
  const Vec2 at_a = mesh.position[Mesh::size(a)];
  const Vec2 to_b = mesh.position[Mesh::size(b)] - (at_a + chord); // a period, on a torus
  Vec2 new_a = at_a + 0.5 * chord + 0.5 * left_normal(chord);
  Vec2 new_b = new_a - left_normal(chord);
  const auto along_wall = [&](Index wall) {
    const Vec2 way = mesh.chord(wall);
    return std::min(norm(chord) / norm(way), 0.5) * way;
  };
  if (mesh.boundary == Boundary::Fixed && at_start == kWorld) {
    new_a = at_a;
    new_b = at_a + along_wall(h2);
  } else if (mesh.boundary == Boundary::Fixed && at_end == kWorld) {
    new_b = at_a + chord;
    new_a = new_b + along_wall(t2);
  }

  const Wrap along = mesh.wrap(h);
  mesh.half_bubble[Mesh::size(h)] = at_end;
  mesh.half_bubble[Mesh::size(t)] = at_start;
  mesh.set_wrap(t2, mesh.wrap(t2) + along);
  mesh.set_wrap(h2, mesh.wrap(h2) - along);
  mesh.half_junction[Mesh::size(t2)] = a;
  mesh.half_junction[Mesh::size(h2)] = b;
  mesh.junction_half[Mesh::size(a)] = {h, t2, h1};
  mesh.junction_half[Mesh::size(b)] = {t, h2, t1};
  detail::represent(mesh, t2);
  detail::represent(mesh, h2);
  detail::add_sides(mesh, parted[0], -1);
  detail::add_sides(mesh, parted[1], -1);
  detail::add_sides(mesh, at_start, 1);
  detail::add_sides(mesh, at_end, 1);

  mesh.position[Mesh::size(a)] = new_a;
  mesh.position[Mesh::size(b)] = new_b + to_b;
  const double q = mesh.pressure_of(at_end) - mesh.pressure_of(at_start);
  const double sine = q * norm(chord) / (4 * mesh.surface_tension);
  mesh.set_half_angle(h, mesh.wall(h) ? 0 : std::asin(std::clamp(sine, -0.5, 0.5)));
  return parted;
}

/// Whether the bubble has three sides and its neighbours can spare one each.
template <class Mesh> FOAM_HOST_DEVICE bool can_perform_t2(const Mesh& mesh, Index bubble) {
  if (!mesh.has_bubble(bubble) || mesh.sides[Mesh::size(bubble)] != 3) {
    return false;
  }
  bool possible = true;
  for_each_half(mesh, bubble, [&](Index h) {
    possible = possible && mesh.right(h) != bubble && detail::has_sides(mesh, Mesh::twin(h), 3);
  });
  return possible;
}

/// What is new after a T2: the three films that were prolonged and the bubbles between them.
struct T2Result {
  std::array<Index, 3> films;
  std::array<Index, 3> bubbles;
};

/// Removes a three-sided bubble (thesis Figure 3.4). Its three outer films are prolonged along
/// their arcs until they meet, which in equilibrium they do in one point and at 120° (decoration
/// theorem: D. Weaire, Phil. Mag. Lett. 79 (1999) 491); the rest of the foam stays in equilibrium
/// when the neighbours' target areas grow by what they gain, and so they do here: no gas is lost
/// but to the world. Where the arcs do not meet, the new junction is the mean of the three.
template <class Mesh>
FOAM_HOST_DEVICE T2Result remove_three_sided_bubble(Mesh& mesh, Index bubble) {
  std::array<Index, 3> inner{};  // the bubble's half-films
  std::array<Index, 3> outer{};  // the film that leaves each one's start
  std::array<Index, 3> corner{}; // its start
  T2Result result{};
  {
    std::size_t k = 0;
    for_each_half(mesh, bubble, [&](Index h) {
      inner[k] = h;
      outer[k] = mesh.previous_around_junction(h);
      corner[k] = mesh.start(h);
      result.films[k] = Mesh::film_of(outer[k]);
      result.bubbles[k] = mesh.right(h);
      ++k;
    });
  }
  const detail::GasLedger<3> gas(mesh, bubble, result.bubbles);

  const Vec2 origin = mesh.position[Mesh::size(corner[0])];
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

  Vec2 meeting = detail::common_point(circles, mean, size);
  for (std::size_t k = 0; k < 3; ++k) {
    if (mesh.boundary == Boundary::Fixed && result.bubbles[k] == kWorld) {
      const std::size_t next = (k + 1) % 3;
      const Vec2 begin = origin + offset[k];
      const Vec2 end = origin + offset[next];
      meeting = detail::merged_contact({begin + chord[k], begin, end, end + chord[next]});
    }
  }

  const std::array<Wrap, 3> to_corner{Wrap{}, mesh.wrap(inner[0]), -mesh.wrap(inner[2])};
  for (std::size_t k = 1; k < 3; ++k) {
    mesh.set_wrap(outer[k], mesh.wrap(outer[k]) + to_corner[k]);
    mesh.half_junction[Mesh::size(outer[k])] = corner[0];
    detail::remove_junction(mesh, corner[k]);
  }
  mesh.junction_half[Mesh::size(corner[0])] = outer;
  mesh.position[Mesh::size(corner[0])] = meeting;
  for (std::size_t k = 0; k < 3; ++k) {
    detail::remove_film(mesh, Mesh::film_of(inner[k]));
    detail::represent(mesh, outer[k]);
    detail::add_sides(mesh, result.bubbles[k], -1);
    const Vec2 new_chord = origin + offset[k] + chord[k] - meeting;
    mesh.set_half_angle(outer[k], mesh.wall(outer[k])
                                      ? 0
                                      : detail::prolonged_half_angle(mesh.half_angle(outer[k]),
                                                                     chord[k], new_chord));
  }
  detail::remove_bubble(mesh, bubble);
  gas.share_out(mesh);
  return result;
}

/// Whether the bubble has two sides and is not one of a double bubble.
template <class Mesh> FOAM_HOST_DEVICE bool can_perform_t3(const Mesh& mesh, Index bubble) {
  if (!mesh.has_bubble(bubble) || mesh.sides[Mesh::size(bubble)] != 2) {
    return false;
  }
  const Index h = mesh.bubble_half[Mesh::size(bubble)];
  return detail::has_sides(mesh, Mesh::twin(h), 4) &&
         detail::has_sides(mesh, Mesh::twin(mesh.next_in_bubble(h)), 4);
}

/// Removes a two-sided bubble: the film that it floats on closes behind it, an arc of one circle in
/// equilibrium. Its two neighbours' target areas grow by what they gain. Beside a container's wall
/// the wall is straightened, which may cost a sliver of the container's area.
/// \returns the two neighbours.
template <class Mesh>
FOAM_HOST_DEVICE std::array<Index, 2> remove_two_sided_bubble(Mesh& mesh, Index bubble) {
  const Index e0 = mesh.bubble_half[Mesh::size(bubble)];
  const Index e1 = mesh.next_in_bubble(e0);
  const std::array neighbours{mesh.right(e0), mesh.right(e1)};
  const Index j0 = mesh.start(e0);
  const Index j1 = mesh.start(e1);
  const Index o0 = mesh.previous_around_junction(e0);
  const Index o1 = mesh.previous_around_junction(e1);
  const detail::GasLedger<2> gas(mesh, bubble, neighbours);

  const Index end = mesh.end(o1);
  const Vec2 old_chord = mesh.chord(o0);
  const Vec2 chord = old_chord - mesh.chord(e0) - mesh.chord(o1);
  mesh.set_wrap(o0, mesh.wrap(o0) - mesh.wrap(e0) - mesh.wrap(o1));
  mesh.half_junction[Mesh::size(o0)] = end;
  for (Index& half : mesh.junction_half[Mesh::size(end)]) {
    half = half == Mesh::twin(o1) ? o0 : half;
  }
  mesh.set_half_angle(
      o0, mesh.wall(o0) ? 0 : detail::prolonged_half_angle(mesh.half_angle(o0), old_chord, chord));

  for (const Index h : {e0, e1, o1}) {
    detail::remove_film(mesh, Mesh::film_of(h));
  }
  detail::remove_junction(mesh, j0);
  detail::remove_junction(mesh, j1);
  detail::remove_bubble(mesh, bubble);
  detail::represent(mesh, o0);
  detail::represent(mesh, Mesh::twin(o0));
  for (const Index neighbour : neighbours) {
    detail::add_sides(mesh, neighbour, -2);
  }
  gas.share_out(mesh);
  return neighbours;
}

/// Slides a two-sided bubble along the shorter of the two films that end in it, until that film is
/// `distance` (cm) long (thesis 3.6.1). Does nothing if it is that short already.
template <class Mesh>
FOAM_HOST_DEVICE void slide_two_sided_bubble(Mesh& mesh, Index bubble, double distance) {
  const Index e0 = mesh.bubble_half[Mesh::size(bubble)];
  const Index e1 = mesh.next_in_bubble(e0);
  Index ahead = mesh.previous_around_junction(e0);
  Index behind = mesh.previous_around_junction(e1);
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
  const Index front = mesh.start(ahead);
  const Index back = mesh.start(behind);
  const Vec2 across = mesh.chord(front == mesh.start(e0) ? e0 : e1);
  const Vec2 back_chord = mesh.chord(behind);
  const Vec2 back_move = move + rotated(across, turn) - across;
  mesh.position[Mesh::size(front)] += move;
  mesh.position[Mesh::size(back)] += back_move;
  mesh.set_half_angle(ahead, alpha - 0.5 * turn);
  mesh.set_half_angle(behind, detail::prolonged_half_angle(mesh.half_angle(behind), back_chord,
                                                           back_chord - back_move));
}

} // namespace foam
