// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/thresholds.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "base/error.h"

namespace foam {

void check(const ThresholdOptions& options) {
  require(options.t1_length >= 0, "T1Length", "at least 0", options.t1_length);
  require(options.t2_area >= 0, "T2Area", "at least 0", options.t2_area);
  require(options.alpha > 0, "Alpha", "positive", options.alpha);
}

Thresholds thresholds(double total_area, Index bubbles, Index junctions,
                      const ThresholdOptions& options) {
  switch (options.kind) {
  case ThresholdKind::Relative: {
    const double t1_length =
        options.alpha * std::sqrt(2 * total_area / (std::numbers::pi * junctions));
    return {t1_length, t1_length * t1_length};
  }
  case ThresholdKind::Automatic: {
    const double mean_area = total_area / std::max(bubbles, Index{1});
    return {kAutomatic * std::sqrt(mean_area), kAutomatic * mean_area};
  }
  case ThresholdKind::Absolute:
    break;
  }
  return {options.t1_length, options.t2_area};
}

Thresholds thresholds(const Foam& foam, const ThresholdOptions& options) {
  double total_area = 0;
  for (const Bubble b : foam.bubble_slots()) {
    if (foam.has_bubble(b)) {
      total_area += foam.target_area[b];
    }
  }
  return thresholds(total_area, foam.bubble_count(), foam.junction_count(), options);
}

} // namespace foam
