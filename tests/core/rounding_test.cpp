// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tolerances that rounding does not let any foam reach.
#include <gtest/gtest.h>

#include <cmath>
#include <limits>

#include "../newton_on_host.h"
#include "foams.h"

namespace foam::test {
namespace {

constexpr double kBelowRounding = 1e-16;

/// What rounding of coordinates leaves of balanced forces is the change of a film's direction: as
/// many units in a coordinate's last place as the coordinate is longer than the film.
double rounding(const Foam& foam) {
  constexpr double kShortFilm = 0.1; // spacings
  return 4 * std::numeric_limits<double>::epsilon() * std::sqrt(foam.bubble_count()) / kShortFilm;
}

class BelowRounding : public testing::TestWithParam<Boundary> {};
INSTANTIATE_TEST_SUITE_P(Boundaries, BelowRounding,
                         testing::Values(Boundary::Free, Boundary::Periodic, Boundary::Fixed));

TEST_P(BelowRounding, NewtonsMethodEndsWhereItGetsNoNearer) {
  for (const Index bubbles : {12, 100, 1000}) {
    Foam foam = random_foam(bubbles, GetParam());
    equilibrate(foam, 1e-9);
    ASSERT_TRUE(foam.report.converged);
    const Foam before = foam;
    equilibrate(foam, kBelowRounding);
    EXPECT_TRUE(foam.report.converged);
    EXPECT_LT(foam.report.residual, rounding(foam));
    EXPECT_LE(foam.report.iterations, 12);
    EXPECT_NEAR(foam.energy() / before.energy(), 1, 1e-9);

    Foam on_host = before;
    EquilibratorOptions options;
    options.tolerance = kBelowRounding;
    KrylovEquilibrator(options).equilibrate(on_host, 0.05, {});
    EXPECT_TRUE(on_host.report.converged);
    EXPECT_LT(on_host.report.residual, 4 * rounding(foam));
    EXPECT_LE(on_host.report.iterations, 12);
  }
}

TEST_P(BelowRounding, FramesAreThoseOfATolerance) {
  for (const Stepping stepping : {Stepping::Events, Stepping::FixedSteps}) {
    const auto coarsened = [&](double tolerance, int& iterations) {
      Foam start = random_foam(60, GetParam());
      equilibrate(start);
      CoarseningOptions options;
      options.time_step = 0.02;
      options.stepping = stepping;
      options.equilibrator.tolerance = tolerance;
      const auto coarsening = make_coarsening(options);
      coarsening->restart(start);
      for (int frame = 0; frame < 20; ++frame) {
        EXPECT_TRUE(coarsening->advance({}));
        EXPECT_TRUE(coarsening->foam().report.converged) << coarsening->foam().report.residual;
        iterations += coarsening->foam().report.iterations;
      }
      return coarsening->foam();
    };
    int expected_iterations = 0;
    int iterations = 0;
    const Foam expected = coarsened(1e-11, expected_iterations);
    const Foam foam = coarsened(kBelowRounding, iterations);
    EXPECT_EQ(foam.t1_count, expected.t1_count);
    EXPECT_EQ(foam.t2_count, expected.t2_count);
    EXPECT_NEAR(foam.energy() / expected.energy(), 1, 1e-9);
    EXPECT_LT(foam.report.residual, rounding(foam));
    EXPECT_LT(iterations, 4 * expected_iterations);
  }
}

} // namespace
} // namespace foam::test
