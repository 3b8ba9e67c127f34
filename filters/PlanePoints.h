// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "geometry/vec2.h"

class vtkPointSet;

namespace foam::filters {

/// The points of a data set without their z, cm. \throws FoamError unless they lie in a plane of
/// constant z
std::vector<Vec2> plane_points(vtkPointSet* input);

} // namespace foam::filters
