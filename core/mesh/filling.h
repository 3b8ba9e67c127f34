// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "mesh/foam.h"

namespace foam {

/// Part of their sum that target areas may be off by if they were measured.
inline constexpr double kMeasuredAreas = 0.01;

/// The area that the bubbles of a closed foam fill together, cm²: its torus's, or its container's.
double space_of(const Foam& foam);

/// Scales the target areas of a closed foam, on a torus or in a container, so that they fill its
/// space; those of a free foam have none to fill. \param slack part of the space that they may be
/// off by \param remedy what to do about more, for the message. \returns by what they were scaled.
/// \throws FoamError naming both sums, if they are off by more.
double fill_space(Foam& foam, double slack, const std::string& remedy);

} // namespace foam
