// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "construct/division.h"

namespace foam {

struct Polygon {
  std::int64_t cell = 0;     ///< its number, which its bubble has as its id
  std::vector<Index> points; ///< walked either way
};

/// The foam of polygons that share their points: a bubble each. Points
/// in which two polygons alone meet lie on one film. Points in the same place, to a 1e-9th
/// of the extent of all, are one.
///
/// \param points cm \param polygons in ascending order of their numbers
/// \throws FoamError naming the polygons that overlap, leave a gap or a hole, meet a side with a
/// corner, touch in a single point of the outline, or do not hang together, as cells
DivisionFoam build_from_polygons(std::span<const Vec2> points, std::span<const Polygon> polygons,
                                 DivisionOutline outline, double surface_tension);

} // namespace foam
