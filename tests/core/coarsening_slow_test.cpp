// SPDX-License-Identifier: GPL-3.0-or-later
// Long runs: the scaling state of a periodic foam, and the thesis's constants on a free one.
#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <iostream>
#include <map>

#include "evolution/coarsening.h"
#include "foams.h"
#include "statistics/statistics.h"

namespace foam::test {
namespace {

void expect_frame(const Foam& foam, int frame) {
  const std::string where = "frame " + std::to_string(frame) + ": ";
  expect_valid(foam, where);
  expect_equilibrium(foam, where);
}

TEST(LongRun, TwoThousandPeriodicBubblesReachTheScalingState) {
  // One foam passes through a few hundred independent bubbles on its way from 600 to 100, too few
  // to tell p(n) to 0.02: three are pooled.
  std::map<Index, double> bubbles_with; // pooled over the scaling state, evenly in ln N
  double pooled = 0;
  double second_moment = 0;
  double growth = 0;
  int samples = 0;
  constexpr int kFoams = 3;
  for (std::uint64_t seed = 1; seed <= kFoams; ++seed) {
    auto coarsening = make_coarsening({});
    coarsening->restart(random_foam(2000, Boundary::Periodic, seed));
    const double constant = von_neumann_constant(coarsening->foam().surface_tension, 1);
    const double total_area = coarsening->foam().box.width() * coarsening->foam().box.height();
    double begin_time = 0;
    double begin_area = 0;
    Index next_sample = 600;
    for (int frame = 1; coarsening->foam().bubble_count() > 100; ++frame) {
      ASSERT_TRUE(coarsening->advance({}));
      const Foam& foam = coarsening->foam();
      expect_frame(foam, frame);
      ASSERT_FALSE(HasFailure()) << "seed " << seed << " at " << foam.bubble_count() << " bubbles";
      if (foam.bubble_count() <= next_sample) {
        if (next_sample == 600) {
          begin_time = foam.time;
          begin_area = total_area / foam.bubble_count();
        }
        next_sample = static_cast<Index>(0.95 * foam.bubble_count());
        const FoamStatistics s = statistics(foam, true);
        for (const auto& n : s.by_sides) {
          bubbles_with[n.sides] += n.count;
          pooled += n.count;
        }
        second_moment += s.area_second_moment;
        ++samples;
      }
    }
    const Foam& end = coarsening->foam();
    growth += (total_area / end.bubble_count() - begin_area) / (end.time - begin_time) / constant /
              kFoams;
  }
  double mu2 = 0;
  for (const auto& [n, count] : bubbles_with) {
    mu2 += count / pooled * (n - 6) * (n - 6);
  }
  const auto p = [&](Index n) { return bubbles_with[n] / pooled; };
  std::cout << "mu2 " << mu2 << ", <A2>/<A>2 " << second_moment / samples << ", d<A>/dt " << growth
            << " K, p(5) " << p(5) << ", p(6) " << p(6) << ", p(7) " << p(7) << '\n';
  EXPECT_GT(mu2, 1.2);
  EXPECT_LT(mu2, 1.6);
  EXPECT_GT(second_moment / samples, 1.5);
  EXPECT_LT(second_moment / samples, 1.7);
  EXPECT_GT(growth, 0.85);
  EXPECT_LT(growth, 1.0);
  EXPECT_GT(p(5), 0.29);
  EXPECT_LT(p(5), 0.32);
  EXPECT_GT(p(6), 0.31);
  EXPECT_LT(p(6), 0.35);
  EXPECT_GT(p(7), 0.17);
  EXPECT_LT(p(7), 0.20);
}

TEST(LongRun, TwoThousandFreeBubblesAThousandFrames) {
  auto coarsening = make_coarsening({});
  coarsening->restart(random_foam(2000, Boundary::Free, 1));
  const auto begin = std::chrono::steady_clock::now();
  for (int frame = 1; frame <= 1000; ++frame) {
    ASSERT_TRUE(coarsening->advance({}));
    expect_frame(coarsening->foam(), frame);
  }
  const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
  std::cout << coarsening->foam().bubble_count() << " bubbles left, T1 "
            << coarsening->foam().t1_count << ", T2 " << coarsening->foam().t2_count << ", "
            << took.count() << " s with all checks\n";
}

TEST(LongRun, AHundredThousandPoints) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic}) {
    const auto begin = std::chrono::steady_clock::now();
    const Foam foam = random_foam(100000, boundary, 1);
    const std::chrono::duration<double> took = std::chrono::steady_clock::now() - begin;
    expect_valid(foam);
    expect_equilibrium(foam);
    EXPECT_EQ(foam.bubble_count(), 100000);
    std::cout << "built and equilibrated in " << took.count() << " s, " << foam.report.iterations
              << " iterations, " << foam.t1_count << " T1\n";
  }
}

} // namespace
} // namespace foam::test
