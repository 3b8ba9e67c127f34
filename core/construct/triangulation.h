// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "mesh/foam.h"

namespace foam {

/// A corner of a triangle: a point by the bubble that it becomes, or kWorld for the vertex at
/// infinity, and on a torus how many periods the corner lies from the point.
struct Corner {
  Bubble point;
  Wrap copy;
};

/// Corners counter-clockwise, the least point first.
using Triangle = std::array<Corner, 3>;

/// The Delaunay triangulation of distinct points of the plane, with a triangle to kWorld on each
/// edge of its outline: the hull, less triangles that lie flat on it. A function of the points
/// alone, ties included. Empty if all points lie on a line.
std::vector<Triangle> triangulate_plane(std::span<const Vec2> points);

/// Points moved into the cell of a torus's shortest periods, and the same on a grid of numbers so
/// coarse that a sum with periods is exact.
struct TorusPoints {
  ReducedLattice reduced;
  Field<Bubble, Vec2> position; ///< in the cell, cm
  /// From the lattice's origin, in units of 2⁻⁴⁸ of the longest period or more.
  Field<Bubble, Vec2> snapped;
  Lattice snapped_lattice; ///< its origin is 0
};
/// \throws FoamError if a point lies too many periods from the cell.
TorusPoints torus_points(std::span<const Vec2> points, const Lattice& lattice);

/// The Delaunay triangulation of distinct points of a torus: two triangles per point, the same ones
/// whichever copies of the points they are seen on. Copies are counted in the periods that
/// torus_points() was given.
std::vector<Triangle> triangulate_torus(const TorusPoints& points);

} // namespace foam
