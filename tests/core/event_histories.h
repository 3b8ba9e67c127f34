// SPDX-License-Identifier: GPL-3.0-or-later
// What becomes of a foam by events, to compare one way through time with another.
#pragma once

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "foams.h"

namespace foam::test {

/// A foam at one of the times at which it is looked at.
struct Snapshot {
  std::int64_t t1_count = 0;
  std::int64_t t2_count = 0;
  std::map<Index, Index> sides;  ///< by bubble
  std::map<Index, double> areas; ///< by bubble, cm²
};

inline Snapshot snapshot(const Foam& foam) {
  Snapshot now{.t1_count = foam.t1_count, .t2_count = foam.t2_count, .sides = {}, .areas = {}};
  for (const Bubble b : foam.bubble_slots()) {
    if (foam.has_bubble(b)) {
      now.sides[b.index()] = foam.sides[b];
      now.areas[b.index()] = foam.area(b);
    }
  }
  return now;
}

/// Frames of a duration (s), and thresholds in cm and cm².
inline CoarseningOptions frames_of(double time_step, double t1_length = 0.025,
                                   double t2_area = 0.05) {
  CoarseningOptions options;
  options.time_step = time_step;
  options.thresholds = {
      .kind = ThresholdKind::Absolute, .t1_length = t1_length, .t2_area = t2_area};
  return options;
}

/// A foam coarsens for so many seconds, in equilibrium after every frame, and is looked at every so
/// many.
inline std::vector<Snapshot> history(const Foam& foam, const CoarseningOptions& options,
                                     double seconds, double every) {
  auto coarsening = make_coarsening(options);
  coarsening->restart(foam);
  const auto frames = std::lround(seconds / options.time_step);
  const auto between = std::lround(every / options.time_step);
  std::vector<Snapshot> seen;
  for (long frame = 1; frame <= frames; ++frame) {
    EXPECT_TRUE(coarsening->advance({})) << "at " << coarsening->foam().time << " s";
    expect_equilibrium(coarsening->foam());
    if (frame % between == 0) {
      expect_valid(coarsening->foam());
      seen.push_back(snapshot(coarsening->foam()));
    }
  }
  return seen;
}

/// Of the bubbles that are in both, cm².
inline double largest_difference(const Snapshot& a, const Snapshot& b) {
  double largest = 0;
  for (const auto& [bubble, area] : a.areas) {
    if (const auto other = b.areas.find(bubble); other != b.areas.end()) {
      largest = std::max(largest, std::abs(area - other->second));
    }
  }
  return largest;
}

/// The same events have happened, and, as areas grow by von Neumann's law from one to the next, at
/// the same times.
inline void expect_same_events(const std::vector<Snapshot>& a, const std::vector<Snapshot>& b,
                               double tolerance) {
  ASSERT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    EXPECT_EQ(a[i].t1_count, b[i].t1_count) << i;
    EXPECT_EQ(a[i].t2_count, b[i].t2_count) << i;
    EXPECT_EQ(a[i].sides, b[i].sides) << i;
    EXPECT_LT(largest_difference(a[i], b[i]), tolerance) << i;
  }
}

} // namespace foam::test
