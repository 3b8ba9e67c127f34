// SPDX-License-Identifier: GPL-3.0-or-later
//
// Films as polylines, whoever holds the mesh (mesh/mesh_access.h).
#pragma once

#include "mesh/mesh_access.h"

namespace foam {

/// Number of straight segments that keep a half-film's polyline within chord_error (cm) of its arc.
template <class Mesh>
FOAM_HOST_DEVICE Index film_segments(const Mesh& mesh, Half half, double chord_error) {
  return arc_segments(norm(mesh.chord(half)), mesh.half_angle(half), chord_error);
}

/// Calls visit(point) for the points between the ends of a half-film's polyline of so many
/// segments, at equal distances along the arc, which starts at `start` (cm).
template <class Mesh, class Visit>
FOAM_HOST_DEVICE void for_each_inner_point(const Mesh& mesh, Half half, Vec2 start, Index segments,
                                           Visit&& visit) {
  const Vec2 chord = mesh.chord(half);
  const double alpha = mesh.half_angle(half);
  for (Index i = 1; i < segments; ++i) {
    visit(arc_point(start, chord, alpha, static_cast<double>(i) / segments));
  }
}

} // namespace foam
