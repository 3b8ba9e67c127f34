// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/thresholds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "hand_made.h"

namespace foam {
namespace {

TEST(Thresholds, AbsoluteOnesAreTaken) {
  const Thresholds t = thresholds(honeycomb(4, 2), {ThresholdKind::Absolute, 0.1, 0.2, 0.3});
  EXPECT_EQ(t.t1_length, 0.1);
  EXPECT_EQ(t.t2_area, 0.2);
}

TEST(Thresholds, RelativeOnesScaleWithTheMeanBubble) {
  // On a torus m = 2N, so that √(2·A_total/(π·m)) is the radius of a disc of the mean area.
  const Foam foam = honeycomb(4, 2);
  const double radius = std::sqrt(std::sqrt(0.75) / std::numbers::pi);
  const Thresholds t = thresholds(foam, {ThresholdKind::Relative, 0.1, 0.2, 0.05});
  EXPECT_NEAR(t.t1_length, 0.05 * radius, 1e-15);
  EXPECT_NEAR(t.t2_area, 0.0025 * radius * radius, 1e-15);
}

} // namespace
} // namespace foam
