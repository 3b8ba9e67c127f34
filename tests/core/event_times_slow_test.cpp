// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include "event_histories.h"

namespace foam::test {
namespace {

class ManyFoams : public testing::TestWithParam<Boundary> {};

TEST_P(ManyFoams, HaveEventsThatDoNotDependOnTheFrame) {
  for (std::uint64_t seed = 3; seed < 23; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Foam foam = random_foam(150, GetParam(), seed);
    expect_same_events(history(foam, frames_of(0.1), 1, 0.1),
                       history(foam, frames_of(0.00125), 1, 0.1), 1e-6);
  }
}

// With thresholds of a ten-thousandth a T1 in a foam or two still goes another way.
TEST_P(ManyFoams, ConvergeAsThresholdsShrink) {
  int same = 0;
  for (std::uint64_t seed = 3; seed < 13; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    const Foam foam = random_foam(200, GetParam(), seed);
    const auto with_thresholds = [&](double part) {
      return history(foam, frames_of(0.025, part, part), 2, 0.5);
    };
    const std::vector<Snapshot> none = with_thresholds(0);
    same += with_thresholds(1e-4).back().sides == none.back().sides ? 1 : 0;
    expect_same_events(with_thresholds(1e-6), none, 1e-6);
  }
  EXPECT_GE(same, 8);
}

/// Rates change all the time where there are walls, or tensions of films' own.
class ManyFoamsOfChangingRates : public testing::TestWithParam<std::pair<Boundary, double>> {};

TEST_P(ManyFoamsOfChangingRates, HaveEventsThatDoNotDependOnTheFrame) {
  const auto [boundary, unevenness] = GetParam();
  for (std::uint64_t seed = 3; seed < 23; ++seed) {
    SCOPED_TRACE(testing::Message() << "seed " << seed);
    Foam foam = random_foam(
        static_cast<Index>(20 * std::pow(10, static_cast<double>(seed - 3) / 19)), boundary, seed);
    if (unevenness > 0) {
      pull_unevenly(foam, unevenness, seed);
      equilibrate(foam);
    }
    expect_same_events(history(foam, frames_of(0.1), 1, 0.1),
                       history(foam, frames_of(0.00125), 1, 0.1), 1e-6);
  }
}

INSTANTIATE_TEST_SUITE_P(Everywhere, ManyFoamsOfChangingRates,
                         testing::Values(std::pair{Boundary::Fixed, 0.0},
                                         std::pair{Boundary::Periodic, 0.1},
                                         std::pair{Boundary::Fixed, 0.1}));

INSTANTIATE_TEST_SUITE_P(Everywhere, ManyFoams,
                         testing::Values(Boundary::Periodic, Boundary::Free));

/// Thresholds that are small beside the bubbles are nearer the truth, and no reason to end.
TEST(SmallThresholds, DoNotEndALargeFoam) {
  for (std::uint64_t seed = 1; seed < 7; ++seed) {
    Foam foam = jittered_foam(Boundary::Periodic, 500, seed);
    make_equilibrator({})->equilibrate(foam, 0.001, {});
    auto coarsening = make_coarsening(frames_of(1.0 / 30, 0.001, 0.001));
    coarsening->restart(foam);
    for (int frame = 0; frame < 150; ++frame) {
      ASSERT_TRUE(coarsening->advance({})) << "seed " << seed << " frame " << frame;
      expect_equilibrium(coarsening->foam());
    }
    EXPECT_NEAR(coarsening->foam().bubble_count(), 175, 25) << "seed " << seed;
  }
}

} // namespace
} // namespace foam::test
