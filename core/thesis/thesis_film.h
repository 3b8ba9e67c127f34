// SPDX-License-Identifier: GPL-3.0-or-later
//
// A film as the thesis sees it (3.3): its half-angle follows from the pressures beside it.
#pragma once

#include <algorithm>
#include <cmath>

#include "geometry/arc.h"

namespace foam::thesis {

/// α = sgn(r)·asin(d/(2|r|)) (3.3.2) with Laplace and Young's r = T/Δp, T = 2γ (2.2.1), rad; > 0
/// where the pressure on the left is the higher one. A radius too small for the chord is taken as
/// half the chord, so that angle, area and length are those of one arc, the half circle: the
/// thesis's clamp.
FOAM_HOST_DEVICE inline double thesis_half_angle(double chord, double pressure_difference,
                                                 double tension) {
  return std::asin(std::clamp(chord * pressure_difference / (2 * tension), -1.0, 1.0));
}

} // namespace foam::thesis
