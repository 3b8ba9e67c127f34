// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/foam.h"

namespace foam {

/// A corner of a triangle: a point, or kWorld for the vertex at infinity, and on a torus how many
/// periods the corner lies from the point.
struct Corner {
  Index point = kNone;
  Wrap copy;
};

/// Corners counter-clockwise, the least point first.
using Triangle = std::array<Corner, 3>;

/// The Delaunay triangulation of distinct points of the plane, with a triangle to the world on each
/// edge of its outline: the hull, less triangles that lie flat on it. A function of the points
/// alone, ties included. Empty if all points lie on a line.
std::vector<Triangle> triangulate_plane(std::span<const Vec2> points);

/// Points moved into a torus's box, and the same on a lattice of numbers so coarse that a sum with
/// a period is exact.
struct TorusPoints {
  std::vector<Vec2> position; ///< in the box, cm
  std::vector<Vec2> snapped;  ///< from the box's corner, in units of 2⁻⁴⁸ of the box or more
  Vec2 snapped_period;
};
TorusPoints torus_points(std::span<const Vec2> points, const Box& box);

/// The Delaunay triangulation of distinct points of a torus: two triangles per point, the same ones
/// whichever copies of the points they are seen on.
std::vector<Triangle> triangulate_torus(const TorusPoints& points);

} // namespace foam
