// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "construct/containers.h"
#include "mesh/foam.h"

namespace foam {

/// The foam of the Voronoi cells of points in a container: a bubble per point, with its index as
/// id, straight films, pressures and target areas 0. Not in equilibrium. \param points cm, at least
/// 2, distinct. What walls cut off of a cell goes to the neighbour with which it has the longest
/// film. \throws FoamError for a point that is not inside, and for a wall that no film touches
Foam fill_container(std::span<const Vec2> points, const Container& container);

} // namespace foam
