// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/vec2.h"
#include "mesh/foam.h"

namespace foam {

/// The thesis's start (4.5.3): one point at a random place in each cell of a square grid, row by
/// row. The grid has ⌈√count⌉ columns. Where its last row would not be full, all rows share the
/// points, and their cells are stretched so that they fill the rectangle, each with the area of a
/// square one.
/// \param spacing side of a grid cell, cm, > 0.
/// \param jitter 0 = the centres of the grid cells, 1 = anywhere in the grid cell.
/// \param seed the same seed gives the same points on every platform.
/// \throws FoamError for a count < 1, a spacing ≤ 0 or a jitter outside [0, 1].
std::vector<Vec2> jittered_grid(Index count, double spacing, double jitter, std::uint64_t seed);

/// The rectangle that the cells of the grid fill, from the origin to this corner, cm.
Vec2 grid_corner(Index count, double spacing);

} // namespace foam
