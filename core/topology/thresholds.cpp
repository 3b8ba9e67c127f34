// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/thresholds.h"

#include <cmath>
#include <numbers>

namespace foam {

Thresholds thresholds(const Foam& foam, const ThresholdOptions& options) {
  if (!options.relative) {
    return {options.t1_length, options.t2_area};
  }
  double total_area = 0;
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    if (foam.has_bubble(b)) {
      total_area += foam.target_area[Foam::size(b)];
    }
  }
  const double t1_length =
      options.alpha * std::sqrt(2 * total_area / (std::numbers::pi * foam.junction_count()));
  return {t1_length, t1_length * t1_length};
}

} // namespace foam
