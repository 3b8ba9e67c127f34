// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/thresholds.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "coarsening/options.h"
#include "foams.h"
#include "hand_made.h"
#include "physics/gas.h"

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

/// What a foam says is what the next frame goes by, floors and all.
TEST(Thresholds, InForceAreThoseOfTheFoamAsItIs) {
  for (const Stepping stepping : {Stepping::Events, Stepping::FixedSteps}) {
    const Foam start = test::random_foam(30, Boundary::Free, 3);
    const double spacing = start.mean_spacing();
    const auto in_force = [&](const ThresholdOptions& asked, int frames) {
      CoarseningOptions options;
      options.stepping = stepping;
      options.time_step = 0.01;
      options.thresholds = asked;
      const auto coarsening = make_coarsening(options);
      coarsening->restart(start);
      for (int frame = 0; frame < frames; ++frame) {
        EXPECT_TRUE(coarsening->advance({}));
      }
      Thresholds said = coarsening->foam().thresholds;
      coarsening->restart(coarsening->foam()); // which changes nothing
      EXPECT_EQ(coarsening->foam().thresholds, said);
      const double mean = coarsening->foam().mean_spacing();
      return Thresholds{said.t1_length / mean, said.t2_area / (mean * mean)};
    };
    for (const int frames : {0, 20}) {
      const Thresholds own = in_force({}, frames);
      EXPECT_NEAR(own.t1_length, kAutomatic, 1e-12);
      EXPECT_NEAR(own.t2_area, kAutomatic, 1e-12);
      // docs/mathematics.md
      const bool events = stepping == Stepping::Events;
      const Thresholds least = in_force({ThresholdKind::Absolute, 0, 0, 0.05}, frames);
      EXPECT_NEAR(least.t1_length, events ? 1e-5 : 1e-3, 1e-12);
      EXPECT_NEAR(least.t2_area, events ? 1e-4 : 1e-6, 1e-12);
    }
    const ThresholdOptions asked{ThresholdKind::Absolute, 0.03 * spacing, 0.02, 0.05};
    EXPECT_NEAR(in_force(asked, 0).t1_length, 0.03, 1e-12);
  }
}

TEST(AutomaticTimeStep, IsKeptWhileRatesAre) {
  Foam foam = test::random_foam(30, Boundary::Periodic, 3);
  CoarseningOptions options;
  const auto chosen = [&] {
    const auto coarsening = make_coarsening(options);
    coarsening->restart(foam);
    const double before = foam.time;
    EXPECT_TRUE(coarsening->advance({}));
    foam = coarsening->foam();
    EXPECT_NEAR(foam.time - before, foam.time_step, 1e-12);
    return foam.time_step;
  };
  const double first = chosen();
  EXPECT_EQ(chosen(), first);
  options.permeability = 1000;
  EXPECT_NEAR(chosen(), first / 1000, 1e-12 * first);
  EXPECT_EQ(foam.growth_constant, von_neumann_constant(foam.surface_tension, 1000));
  foam.surface_tension *= 2;
  EXPECT_NEAR(chosen(), first / 2000, 1e-12 * first);
}

} // namespace
} // namespace foam
