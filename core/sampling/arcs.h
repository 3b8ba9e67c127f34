// SPDX-License-Identifier: GPL-3.0-or-later
//
// Films as polylines, whoever holds the mesh (mesh/mesh_access.h).
#pragma once

#include "mesh/mesh_access.h"

namespace foam {

/// Number of straight segments that keep a half-film's polyline within chord_error (cm) of its arc,
/// or of the wall.
template <class Mesh>
FOAM_HOST_DEVICE Index film_segments(const Mesh& mesh, Half half, double chord_error) {
  if (!mesh.wall(half)) {
    return arc_segments(norm(mesh.chord(half)), mesh.half_angle(half), chord_error);
  }
  Index segments = 0;
  mesh.for_each_wall_part(half, [&](const WallPiece& part, double /*corner*/) {
    segments += arc_segments(norm(part.chord), part.half_angle, chord_error);
  });
  return segments;
}

/// Calls visit(i, point) for the points between the ends of a film's polyline of so many segments,
/// of which i is the number; on an arc they lie at equal distances. The film starts at `start`
/// (cm).
template <class Mesh, class Visit>
FOAM_HOST_DEVICE void for_each_inner_point(const Mesh& mesh, Film film, Vec2 start, Index segments,
                                           double chord_error, Visit&& visit) {
  const Half half = film.half();
  const Vec2 chord = mesh.chord(half);
  if (!mesh.wall(half)) {
    const double alpha = mesh.half_angle(half);
    for (Index i = 1; i < segments; ++i) {
      visit(i, arc_point(start, chord, alpha, static_cast<double>(i) / segments));
    }
    return;
  }
  const bool forwards = mesh.solid(mesh.right(half));
  const Vec2 shift = forwards ? start - mesh.position[mesh.start(half)]
                              : start + chord - mesh.position[mesh.end(half)];
  Index i = 0;
  mesh.for_each_wall_part(half, [&](const WallPiece& part, double /*corner*/) {
    const Index count = arc_segments(norm(part.chord), part.half_angle, chord_error);
    for (Index k = 1; k <= count && ++i < segments; ++k) {
      visit(forwards ? i : segments - i, shift + arc_point(part.start, part.chord, part.half_angle,
                                                           static_cast<double>(k) / count));
    }
  });
}

} // namespace foam
