// SPDX-License-Identifier: GPL-3.0-or-later
// Many random foams in containers, coarsened to their end.
#include <gtest/gtest.h>

#include <cmath>

#include "coarsening/end.h"
#include "containers.h"

namespace foam::test {
namespace {

/// Every frame keeps the gas and the container's area, nearly every one is in equilibrium, and of
/// the runs few end for want of one.
TEST(Walls, RandomContainersKeepTheirGasToTheEnd) {
  constexpr int kRuns = 6; // of each shape and stepping
  constexpr int kFrames = 400;
  for (const auto& [name, container] : containers()) {
    int unconverged = 0;
    int without_equilibrium = 0;
    double lost = 0;
    std::int64_t frames = 0;
    for (int run = 1; run <= 2 * kRuns; ++run) {
      const auto seed = static_cast<std::uint64_t>(run);
      const std::string where = name + ", run " + std::to_string(run) + ": ";
      Random random(seed);
      const auto bubbles = static_cast<Index>(6 * std::pow(50, random.uniform()));
      const Foam start = random_foam_in(container, bubbles, seed);
      if (!start.report.converged) {
        ++without_equilibrium;
        continue;
      }
      CoarseningOptions options;
      options.stepping = run % 2 == 0 ? Stepping::Events : Stepping::FixedSteps;
      options.time_step = std::pow(10, -2.5 + 2 * random.uniform()) * start.mean_area();
      const auto coarsening = make_coarsening(options);
      coarsening->restart(start);
      const double gas = sum(start, [&](Bubble b) { return start.target_area[b]; });
      for (int frame = 0; frame < kFrames && coarsening->advance({}); ++frame) {
        const Foam& foam = coarsening->foam();
        ++frames;
        unconverged += foam.report.converged ? 0 : 1;
        lost = std::max(
            lost, std::abs(sum(foam, [&](Bubble b) { return foam.target_area[b]; }) / gas - 1));
        lost =
            std::max(lost, std::abs(sum(foam, [&](Bubble b) { return foam.area(b); }) / gas - 1));
        if (frame % 20 == 0) {
          expect_valid(foam, where);
        }
      }
      without_equilibrium +=
          coarsening->foam().ended && coarsening->foam().ended->cause == End::Cause::NoEquilibrium
              ? 1
              : 0;
    }
    std::cout << name << ": " << frames << " frames, " << unconverged << " unconverged, gas lost "
              << lost << ", " << without_equilibrium << " of " << 2 * kRuns
              << " runs ended for want of an equilibrium\n";
    EXPECT_LE(unconverged, frames / 500) << name;
    EXPECT_LT(lost, 1e-12) << name;
    EXPECT_LE(without_equilibrium, kRuns / 2) << name;
  }
}

} // namespace
} // namespace foam::test
