// SPDX-License-Identifier: GPL-3.0-or-later
// Long runs: the scaling state of a periodic foam, and the thesis's constants on a free one.
#include <gtest/gtest.h>

#include <algorithm>
#include <chrono>
#include <iostream>
#include <iterator>
#include <map>
#include <vector>

#include "coarsening/coarsening.h"
#include "engines/engines.h"
#include "foams.h"
#include "physics/gas.h"
#include "statistics/ensemble.h"
#include "statistics/statistics.h"

namespace foam::test {
namespace {

void expect_frame(const Foam& foam, int frame) {
  const std::string where = "frame " + std::to_string(frame) + ": ";
  expect_valid(foam, where);
  expect_equilibrium(foam, where);
}

/// What the scaling state is judged by, of one foam on its way from 600 bubbles to 100.
struct ScalingState {
  std::map<Index, double> fraction; ///< p(n), over samples evenly in ln N
  double second_moment = 0;         ///< ⟨A²⟩/⟨A⟩², likewise
  double growth = 0;                ///< d⟨A⟩/dt, in von Neumann's constants

  double mu2() const {
    double sum = 0;
    for (const auto& [n, p] : fraction) {
      sum += p * (n - 6) * (n - 6);
    }
    return sum;
  }
};

ScalingState coarsen_to_scaling_state(std::uint64_t seed) {
  ScalingState state;
  CoarseningOptions options = thesis_options();
  options.time_step = 0.1;
  auto coarsening = make_coarsening(options);
  coarsening->restart(random_foam(2000, Boundary::Periodic, seed));
  const Foam& foam = coarsening->foam();
  const auto mean_area = [&] { return foam.surroundings.lattice.area() / foam.bubble_count(); };
  double begin_time = 0;
  double begin_area = 0;
  double counted = 0;
  int samples = 0;
  Index next_sample = 600;
  for (int frame = 1; foam.bubble_count() > 100 && !testing::Test::HasFailure(); ++frame) {
    EXPECT_TRUE(coarsening->advance({}));
    expect_frame(foam, frame);
    if (foam.bubble_count() > next_sample) {
      continue;
    }
    if (samples++ == 0) {
      begin_time = foam.time;
      begin_area = mean_area();
    }
    next_sample = static_cast<Index>(0.95 * foam.bubble_count());
    const FoamStatistics s = statistics(foam, true);
    for (const auto& n : s.by_sides) {
      state.fraction[n.sides] += n.count;
      counted += n.count;
    }
    state.second_moment += s.area_second_moment;
  }
  for (auto& [n, fraction] : state.fraction) {
    fraction /= counted;
  }
  state.second_moment /= samples;
  state.growth = (mean_area() - begin_area) / (foam.time - begin_time) /
                 von_neumann_constant(foam.surface_tension, 1);
  return state;
}

TEST(LongRun, TwoThousandPeriodicBubblesReachTheScalingState) {
  std::vector<ScalingState> states;
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    states.push_back(coarsen_to_scaling_state(seed));
    ASSERT_FALSE(HasFailure()) << "seed " << seed;
  }
  // A foam of so few bubbles scatters by a third of p(6)'s range: what the sample says of the mean
  // must agree with the range, and must be precise enough to disagree with it.
  const auto expect_mean = [&](const char* name, double low, double high, auto&& value) {
    std::vector<double> values;
    std::ranges::transform(states, std::back_inserter(values), value);
    const MeanEstimate estimate = estimate_mean(values);
    std::cout << name << ' ' << estimate.mean << " +- " << estimate.half_width << '\n';
    EXPECT_GT(estimate.mean + estimate.half_width, low) << name;
    EXPECT_LT(estimate.mean - estimate.half_width, high) << name;
    EXPECT_LT(estimate.half_width, (high - low) / 4) << name;
  };
  const auto fraction = [](Index n) {
    return [n](const ScalingState& state) { return state.fraction.at(n); };
  };
  expect_mean("mu2", 1.2, 1.6, &ScalingState::mu2);
  expect_mean("<A2>/<A>2", 1.5, 1.7, &ScalingState::second_moment);
  expect_mean("d<A>/dt in K", 0.85, 1.0, &ScalingState::growth);
  expect_mean("p(5)", 0.29, 0.32, fraction(5));
  expect_mean("p(6)", 0.31, 0.35, fraction(6));
  expect_mean("p(7)", 0.17, 0.20, fraction(7));
}

TEST(LongRun, TwoThousandFreeBubblesAThousandFrames) {
  auto coarsening = make_coarsening(thesis_options());
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
