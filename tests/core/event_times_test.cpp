// SPDX-License-Identifier: GPL-3.0-or-later
// Events happen when the foam has them happen, whatever frames and thresholds are.
#include <gtest/gtest.h>

#include "event_histories.h"

namespace foam::test {
namespace {

struct Case {
  Boundary boundary;
  std::uint64_t seed;
  double unevenness = 0; ///< of films' tensions, a part of 2γ
};

class Frames : public testing::TestWithParam<Case> {
protected:
  static Foam foam_of(Index bubbles) {
    Foam foam = random_foam(bubbles, GetParam().boundary, GetParam().seed);
    if (GetParam().unevenness > 0) {
      pull_unevenly(foam, GetParam().unevenness, GetParam().seed);
      equilibrate(foam);
    }
    return foam;
  }
};

TEST_P(Frames, AreOfNoAccountToEvents) {
  const Foam foam = foam_of(150);
  const auto in_frames_of = [&](double time_step) {
    return history(foam, frames_of(time_step), 1, 0.1);
  };
  const std::vector<Snapshot> fine = in_frames_of(0.00125);
  EXPECT_GT(fine.back().t1_count - foam.t1_count, 20);
  EXPECT_GT(fine.back().t2_count - foam.t2_count, 10);
  expect_same_events(in_frames_of(0.1), fine, 1e-6);
  expect_same_events(in_frames_of(0.05), fine, 1e-6);
}

TEST_P(Frames, AreOfNoAccountWhereThresholdsGrowWithTheFoam) {
  const Foam foam = foam_of(60);
  const auto in_frames_of = [&](double time_step) {
    CoarseningOptions options;
    options.time_step = time_step;
    return history(foam, options, 1, 0.1);
  };
  expect_same_events(in_frames_of(0.1), in_frames_of(0.0025), 1e-6);
}

// Rates change all the time in a container and with tensions of their own.
INSTANTIATE_TEST_SUITE_P(Random, Frames,
                         testing::Values(Case{Boundary::Periodic, 1}, Case{Boundary::Periodic, 2},
                                         Case{Boundary::Free, 1}, Case{Boundary::Fixed, 1},
                                         Case{Boundary::Fixed, 2},
                                         Case{Boundary::Periodic, 1, 0.1}));

class EventTimes : public testing::TestWithParam<Case> {};

TEST_P(EventTimes, ConvergeAsThresholdsShrink) {
  const Foam foam = random_foam(100, GetParam().boundary, GetParam().seed);
  const auto with_thresholds = [&](double part) {
    const double spacing = foam.mean_spacing();
    return history(foam, frames_of(0.05, part * spacing, part * spacing * spacing), 1, 0.25);
  };
  const std::vector<Snapshot> none = with_thresholds(0);
  EXPECT_GT(none.back().t1_count - foam.t1_count, 10);
  expect_same_events(with_thresholds(1e-3), none, 1e-2);
  expect_same_events(with_thresholds(1e-6), none, 1e-6);
  expect_same_events(with_thresholds(1e-9), none, 1e-6);
}

/// In equilibrium the films around a three-sided bubble are as if it were not there (the decoration
/// theorem), so it does not matter when it goes, if its gas goes where it would have gone.
TEST_P(EventTimes, OfAFoamDoNotDependOnWhenThreeSidedBubblesVanish) {
  const Foam foam = random_foam(100, GetParam().boundary, GetParam().seed);
  const auto with_area = [&](double area) {
    return history(foam, frames_of(0.05, 0.025, area), 1, 0.05);
  };
  const double large = 0.05; // cm², with a mean of 1
  const std::vector<Snapshot> early = with_area(large);
  const std::vector<Snapshot> late = with_area(1e-4);
  std::size_t compared = 0;
  for (std::size_t i = 0; i < late.size(); ++i) {
    for (const auto& [bubble, area] : late[i].areas) {
      if (!early[i].areas.contains(bubble)) {
        EXPECT_EQ(late[i].sides.at(bubble), 3);
        EXPECT_LT(area, large);
      }
    }
    if (early[i].areas.size() == late[i].areas.size()) {
      EXPECT_EQ(early[i].sides, late[i].sides);
      EXPECT_LT(largest_difference(early[i], late[i]), 1e-6);
      ++compared;
    }
  }
  EXPECT_GT(compared, late.size() / 4);
}

INSTANTIATE_TEST_SUITE_P(Random, EventTimes,
                         testing::Values(Case{Boundary::Periodic, 1}, Case{Boundary::Periodic, 2},
                                         Case{Boundary::Free, 1}));

} // namespace
} // namespace foam::test
