// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "mesh/foam.h"
#include "physics/thresholds.h"

namespace foam {

/// What a frame cannot get over.
struct Obstacle {
  End::Cause cause = End::Cause::NoEquilibrium;
  Bubble bubble = kNone; ///< that is in the way; if none is known the smallest is, or the largest
                         ///< if all vanish
  double area_ahead = 0; ///< that it would have in the frame if it is turned inside out, cm²
};

/// The end of a run at its last foam. \param limit in force \param asked what was asked for; both
/// in the foam's units
End end_at(const Foam& last, const Obstacle& obstacle, const Thresholds& limit,
           const ThresholdOptions& asked);

/// An end in words: what stands in the way, with its figures, and what would help.
std::string reason(const End& end);

} // namespace foam
