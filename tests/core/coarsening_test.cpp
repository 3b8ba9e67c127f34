// SPDX-License-Identifier: GPL-3.0-or-later
// Coarsening against von Neumann's law and what follows from it exactly.
#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <numeric>
#include <thread>

#include "base/error.h"
#include "base/random.h"
#include "coarsening/coarsening.h"
#include "engines/engines.h"
#include "foams.h"
#include "physics/gas.h"

namespace foam::test {
namespace {

/// Thresholds so low that events happen within a millionth of the mean area of where they would be.
CoarseningOptions fine_options(double time_step) {
  CoarseningOptions options = thesis_options();
  options.time_step = time_step;
  options.thresholds.t1_length = 0.01;
  options.thresholds.t2_area = 0;
  return options;
}

double total_area(const Foam& foam) {
  return sum(foam, [&](Bubble b) { return foam.area(b); });
}

Field<Bubble, double> gas_transfers(const Foam& foam, double permeability) {
  Field<Bubble, double> rates;
  for (const Bubble b : foam.bubble_slots()) {
    rates.push_back(gas_transfer(foam, b, permeability));
  }
  return rates;
}

TEST(GasTransfer, IsVonNeumannsLawForEveryBubble) {
  const double permeability = 0.7;
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic}) {
    const Foam foam = random_foam(150, boundary, 2);
    expect_equilibrium(foam);
    const double constant = von_neumann_constant(foam.surface_tension, permeability);
    const auto rate = gas_transfers(foam, permeability);
    double worst = 0;
    for (const Bubble b : foam.bubble_slots()) {
      worst = std::max(worst, std::abs(rate[b] - constant * (foam.sides[b] - 6)));
    }
    EXPECT_LT(worst, 1e-8);
    std::cout << "largest |dA/dt - K(n - 6)| = " << worst << " cm2/s\n";
  }
}

TEST(GasTransfer, IsVonNeumannsLawAwayFromAWall) {
  const Foam foam = random_foam(150, Boundary::Fixed, 2);
  expect_equilibrium(foam);
  const auto rate = gas_transfers(foam, 1);
  EXPECT_NEAR(std::accumulate(rate.begin(), rate.end(), 0.0), 0, 1e-12);
  const double constant = von_neumann_constant(foam.surface_tension, 1);
  for (const Bubble b : foam.bubble_slots()) {
    if (!foam.bubble_on_outside(b)) {
      EXPECT_NEAR(rate[b], constant * (foam.sides[b] - 6), 1e-8);
    }
  }
}

TEST(GasTransfer, FreeClusterLosesGasAtItsOuterFilms) {
  const Foam foam = random_foam(80, Boundary::Free, 5);
  int outer = 0;
  for (const Film f : foam.film_slots()) {
    outer += foam.on_outside(f.half());
  }
  const auto rate = gas_transfers(foam, 1);
  const double constant = von_neumann_constant(foam.surface_tension, 1);
  EXPECT_NEAR(std::accumulate(rate.begin(), rate.end(), 0.0), -constant * (6 + outer), 1e-7);
}

TEST(Coarsening, DoubleBubbleLivesItsTime) {
  Foam foam = double_bubble(0.5, 1);
  equilibrate(foam);
  const double lifetime = 0.5 / (4 * von_neumann_constant(0.5, 1));
  auto coarsening = make_coarsening(fine_options(lifetime / 100));
  coarsening->restart(foam);
  int frames = 0;
  while (coarsening->advance({})) {
    ++frames;
    ASSERT_LT(frames, 101);
    expect_equilibrium(coarsening->foam());
    expect_valid(coarsening->foam());
    EXPECT_NEAR(coarsening->foam().area(Bubble(0)), 0.5 * (1 - frames / 100.0), 1e-9);
    EXPECT_NEAR(coarsening->foam().area(Bubble(1)), 0.5 + 0.5 * (1 - frames / 100.0), 1e-9);
  }
  EXPECT_EQ(frames, 99); // the hundredth would leave one bubble
  ASSERT_TRUE(coarsening->foam().ended);
  EXPECT_EQ(coarsening->foam().ended->cause, End::Cause::LastTwo);
  EXPECT_EQ(coarsening->foam().ended->bubble, 0);
  EXPECT_NEAR(coarsening->foam().ended->area, 0.005, 1e-9);
  EXPECT_EQ(coarsening->foam().bubble_count(), 2); // the last foam is kept
  EXPECT_NEAR(coarsening->foam().time, 0.99 * lifetime, 1e-12);
}

TEST(Coarsening, TripleBubbleLivesItsTime) {
  // A1/(3K) with three bubbles, then (A2 − A1)/(4K) with two.
  BuildOptions options;
  options.target_areas = TargetAreas::Array;
  options.target_area_array = {0.6, 0.8, 1.0};
  Foam foam = build_from_points(std::vector<Vec2>{{0, 0}, {1, 0}, {0.5, 0.9}}, options);
  equilibrate(foam);
  const double constant = von_neumann_constant(0.25, 1);
  const double first = 0.6 / (3 * constant);
  const double second = 0.2 / (4 * constant);
  auto coarsening = make_coarsening(fine_options(first / 50));
  coarsening->restart(foam);
  double two_since = 0;
  while (coarsening->advance({})) {
    expect_equilibrium(coarsening->foam());
    if (coarsening->foam().bubble_count() == 3) {
      two_since = coarsening->foam().time;
    }
  }
  EXPECT_NEAR(two_since, first, 1.001 * first / 50);
  EXPECT_NEAR(coarsening->foam().time, first + second, 1.01 * first / 50);
}

TEST(Coarsening, SecondMomentOfAreasOnATorus) {
  // d(ΣA²)/dt = 2K·A_total·(⟨⟨n⟩⟩ − 6) exactly while topology stands still.
  Foam foam = random_foam(100, Boundary::Periodic, 3);
  const double step = 1e-4;
  CoarseningOptions options = fine_options(step);
  options.thresholds.t1_length = 0;
  auto coarsening = make_coarsening(options);
  coarsening->restart(foam);
  const auto second_moment = [](const Foam& f) {
    double sum = 0;
    for (const Bubble b : f.bubble_slots()) {
      sum += f.area(b) * f.area(b);
    }
    return sum;
  };
  double weighted_sides = 0;
  for (const Bubble b : foam.bubble_slots()) {
    weighted_sides += foam.area(b) * foam.sides[b];
  }
  const double total = total_area(foam);
  const double before = second_moment(foam);
  ASSERT_TRUE(coarsening->advance({}));
  ASSERT_EQ(coarsening->foam().topology, foam.topology);
  const double constant = von_neumann_constant(foam.surface_tension, 1);
  const double rate = (second_moment(coarsening->foam()) - before) / step;
  const double expected = 2 * constant * total * (weighted_sides / total - 6);
  // The rate is linear in t: half a step of its change, K²·Σ(n − 6)², is the difference's own.
  double curvature = 0;
  for (const Index n : foam.sides) {
    curvature += constant * constant * (n - 6) * (n - 6);
  }
  EXPECT_NEAR(rate, expected + curvature * step, 1e-5);
}

TEST(Coarsening, FortyFreeBubblesToTheLastTwo) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    CoarseningOptions options = thesis_options();
    options.time_step = 1.0 / 120; // so short that no two of the last four vanish in one frame
    auto coarsening = make_coarsening(options);
    coarsening->restart(random_foam(40, Boundary::Free, seed));
    expect_equilibrium(coarsening->foam());
    int three = 0;
    int frame = 0;
    while (coarsening->advance({})) {
      const std::string where =
          "seed " + std::to_string(seed) + " frame " + std::to_string(++frame) + ": ";
      expect_valid(coarsening->foam(), where);
      expect_equilibrium(coarsening->foam(), where);
      three += coarsening->foam().bubble_count() == 3;
      ASSERT_LT(frame, 3000);
    }
    EXPECT_GT(three, 0);
    EXPECT_EQ(coarsening->foam().bubble_count(), 2);
  }
}

TEST(Coarsening, ConservesTheContainersArea) {
  for (const Boundary boundary : {Boundary::Periodic, Boundary::Fixed}) {
    const Foam start = random_foam(100, boundary, 7);
    const double total = total_area(start);
    auto coarsening = make_coarsening(thesis_options());
    coarsening->restart(start);
    for (int frame = 0; frame < 100; ++frame) {
      ASSERT_TRUE(coarsening->advance({}));
      const std::string where = "frame " + std::to_string(frame) + ": ";
      expect_valid(coarsening->foam(), where);
      expect_equilibrium(coarsening->foam(), where);
      // Where the last bubble between two contacts goes, the wall is straightened.
      const bool wall_kept = boundary == Boundary::Periodic || coarsening->foam().t3_count == 0;
      EXPECT_NEAR(total_area(coarsening->foam()) / total, 1, wall_kept ? 1e-10 : 1e-3) << where;
    }
    EXPECT_GT(coarsening->foam().t2_count, 10);
  }
}

TEST(Coarsening, PinnedContactsDoNotStopIt) {
  auto coarsening = make_coarsening(thesis_options());
  coarsening->restart(random_foam(150, Boundary::Fixed, 1));
  for (int frame = 0; frame < 300; ++frame) {
    ASSERT_TRUE(coarsening->advance({}));
    const std::string where = "frame " + std::to_string(frame) + ": ";
    expect_valid(coarsening->foam(), where);
    expect_equilibrium(coarsening->foam(), where);
  }
  EXPECT_GT(coarsening->foam().t2_count, 90);
}

TEST(Coarsening, SlidesTwoSidedBubbles) {
  CoarseningOptions options = thesis_options();
  options.two_sided_bubbles = TwoSidedBubbles::Slide;
  auto coarsening = make_coarsening(options);
  coarsening->restart(random_foam(60, Boundary::Free, 6));
  for (int frame = 0; frame < 200 && coarsening->advance({}); ++frame) {
    expect_valid(coarsening->foam());
    expect_equilibrium(coarsening->foam());
  }
}

TEST(Coarsening, RelativeThresholds) {
  CoarseningOptions options = thesis_options();
  options.thresholds.kind = ThresholdKind::Relative;
  auto coarsening = make_coarsening(options);
  coarsening->restart(random_foam(100, Boundary::Periodic, 8));
  for (int frame = 0; frame < 60; ++frame) {
    ASSERT_TRUE(coarsening->advance({}));
    expect_valid(coarsening->foam());
    expect_equilibrium(coarsening->foam());
  }
}

TEST(Coarsening, GoesOnWithThresholdsOfNothing) {
  for (const std::uint64_t seed : {1, 2}) {
    CoarseningOptions options = thesis_options();
    options.thresholds.t1_length = 0;
    options.thresholds.t2_area = 0;
    auto coarsening = make_coarsening(options);
    coarsening->restart(random_foam(30, Boundary::Free, seed));
    while (coarsening->advance({})) {
      expect_valid(coarsening->foam());
      expect_equilibrium(coarsening->foam());
    }
    EXPECT_LE(coarsening->foam().bubble_count(), 3);
  }
}

TEST(Coarsening, EndsWhereThresholdsLeaveNothing) {
  CoarseningOptions options = thesis_options();
  options.thresholds.t2_area = 1; // the mean area
  auto coarsening = make_coarsening(options);
  coarsening->restart(random_foam(10, Boundary::Free, 1));
  int frames = 0;
  while (coarsening->advance({})) {
    ASSERT_LT(++frames, 1000);
  }
  expect_valid(coarsening->foam());
}

bool same_bits(const Foam& a, const Foam& b) {
  return a.position == b.position && a.film_angle == b.film_angle && a.pressure == b.pressure &&
         a.target_area == b.target_area && a.half_junction == b.half_junction &&
         a.half_bubble == b.half_bubble && a.t1_count == b.t1_count;
}

TEST(Coarsening, SameInputSameBitsAlsoBesideOtherThreads) {
  const auto run = [](Foam* result) {
    auto coarsening = make_coarsening(thesis_options());
    coarsening->restart(random_foam(100, Boundary::Free, 9));
    for (int frame = 0; frame < 20; ++frame) {
      coarsening->advance({});
    }
    *result = coarsening->foam();
  };
  Foam alone;
  run(&alone);
  std::array<Foam, 3> beside;
  {
    std::vector<std::jthread> threads;
    for (Foam& foam : beside) {
      threads.emplace_back(run, &foam);
    }
  }
  for (const Foam& foam : beside) {
    EXPECT_TRUE(same_bits(foam, alone));
  }
}

TEST(Coarsening, RestartFromTheFilmsGivesTheSameBits) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic, Boundary::Fixed}) {
    auto first = make_coarsening(thesis_options());
    first->restart(random_foam(80, boundary, 10));
    for (int frame = 0; frame < 10; ++frame) {
      first->advance({});
    }
    const FilmSet written = film_set(first->foam());
    first->restart(foam_of(written));
    auto second = make_coarsening(thesis_options());
    second->restart(foam_of(written));
    for (int frame = 0; frame < 10; ++frame) {
      first->advance({});
      second->advance({});
      EXPECT_TRUE(same_bits(first->foam(), second->foam()));
    }
  }
}

TEST(Coarsening, AbortLeavesTheFoamAsItWas) {
  auto coarsening = make_coarsening(thesis_options());
  coarsening->restart(random_foam(100, Boundary::Free, 11));
  coarsening->advance({});
  const Foam before = coarsening->foam();
  int asked = 0;
  EXPECT_THROW(coarsening->advance([&] { return ++asked == 3; }), Aborted);
  EXPECT_TRUE(same_bits(coarsening->foam(), before));
  EXPECT_TRUE(coarsening->advance({}));
}

TEST(Coarsening, WallsStayStraight) {
  for (const std::uint64_t seed : {1, 4}) {
    auto coarsening = make_coarsening(thesis_options());
    coarsening->restart(random_foam(150, Boundary::Fixed, seed));
    for (int frame = 0; frame < 200; ++frame) {
      ASSERT_TRUE(coarsening->advance({}));
      const Foam& foam = coarsening->foam();
      for (const Film f : foam.film_slots()) {
        if (foam.has_film(f) && foam.wall(f.half())) {
          ASSERT_EQ(foam.film_angle[f], 0) << "seed " << seed << ", frame " << frame;
        }
      }
    }
  }
}

/// Also where events at the walls upset the balance of gas there.
TEST(Coarsening, InteriorBubblesOfAContainerFollowVonNeumannsLaw) {
  auto coarsening = make_coarsening(thesis_options());
  coarsening->restart(random_foam(100, Boundary::Fixed, 1));
  const Foam& foam = coarsening->foam();
  const double constant = von_neumann_constant(foam.surface_tension, 1);
  int frames_with_events = 0;
  for (int frame = 1; frame <= 60; ++frame) {
    const Foam before = foam;
    ASSERT_TRUE(coarsening->advance({}));
    if (foam.t2_count != before.t2_count || foam.t3_count != before.t3_count) {
      continue; // what was left of a bubble has gone to its neighbours
    }
    frames_with_events += foam.t1_count != before.t1_count ? 1 : 0;
    for (const Bubble b : foam.bubble_slots()) {
      if (foam.has_bubble(b) && foam.sides[b] == before.sides[b] && !foam.bubble_on_outside(b) &&
          !before.bubble_on_outside(b)) {
        const double gain = constant * (foam.sides[b] - 6) * (foam.time - before.time);
        EXPECT_NEAR(foam.target_area[b] - before.target_area[b], gain,
                    1e-10 * before.target_area[b])
            << "frame " << frame << ", bubble " << b.index();
      }
    }
  }
  EXPECT_GT(frames_with_events, 0);
}

/// A foam on a torus whose films have tensions of their own, by up to 15 % from 2γ, in equilibrium.
Foam foam_of_own_tensions(Index bubbles, std::uint64_t seed) {
  Foam foam = random_foam(bubbles, Boundary::Periodic, seed);
  Random random(seed);
  for (std::size_t f = 0; f < foam.film_angle.size(); ++f) {
    foam.film_tension.push_back(foam.reference_tension() * (0.85 + 0.3 * random.uniform()));
  }
  equilibrate(foam);
  return foam;
}

class OwnTensions : public testing::TestWithParam<Stepping> {
protected:
  static std::unique_ptr<Evolution> coarsening_of(const Foam& foam, double time_step) {
    CoarseningOptions options = thesis_options();
    options.stepping = GetParam();
    options.time_step = time_step;
    auto coarsening = make_coarsening(options);
    coarsening->restart(foam);
    return coarsening;
  }
};
INSTANTIATE_TEST_SUITE_P(Coarsening, OwnTensions,
                         testing::Values(Stepping::Events, Stepping::FixedSteps));

TEST(GasTransfer, OnATorusLosesNothingWithOwnTensions) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Foam foam = foam_of_own_tensions(60, seed);
    expect_equilibrium(foam);
    for (const auto& rate : {gas_transfers(foam, 0.7), area_rates(foam, 0.7)}) {
      EXPECT_NEAR(std::accumulate(rate.begin(), rate.end(), 0.0), 0, 1e-13);
    }
    const double constant = von_neumann_constant(foam.surface_tension, 0.7);
    double off = 0; // von Neumann's law
    for (const Bubble b : foam.bubble_slots()) {
      off = std::max(off, std::abs(gas_transfer(foam, b, 0.7) - constant * (foam.sides[b] - 6)));
    }
    EXPECT_GT(off, 0.1 * constant);
  }
}

TEST_P(OwnTensions, BubblesGrowByTheGasThatTheirFilmsLetThrough) {
  const Foam before = foam_of_own_tensions(40, 1);
  const double time_step = 1e-3;
  const auto coarsening = coarsening_of(before, time_step);
  ASSERT_TRUE(coarsening->advance({}));
  const Foam& after = coarsening->foam();
  ASSERT_EQ(after.topology, before.topology);
  const auto inflow = [](const Foam& foam, Bubble b) {
    double sum = 0;
    for_each_half(foam, b, [&](Half h) {
      sum += foam.length(h) * (foam.pressure[foam.right(h)] - foam.pressure[b]);
    });
    return sum;
  };
  for (const Bubble b : before.bubble_slots()) {
    const double at_first = inflow(before, b);
    const double expected =
        GetParam() == Stepping::Events ? 0.5 * (at_first + inflow(after, b)) : at_first;
    EXPECT_NEAR((after.area(b) - before.area(b)) / time_step, expected, 1e-6) << b.index();
  }
}

TEST_P(OwnTensions, FramesAreEquilibriaThatKeepTheGas) {
  const auto coarsening = coarsening_of(foam_of_own_tensions(40, 2), 1.0 / 30);
  const double total = total_area(coarsening->foam());
  for (int frame = 1; frame <= 60; ++frame) {
    const std::string where = "frame " + std::to_string(frame) + ": ";
    ASSERT_TRUE(coarsening->advance({})) << where;
    const Foam& foam = coarsening->foam();
    expect_valid(foam, where);
    expect_equilibrium(foam, where);
    double gas = 0;
    for (const Bubble b : foam.bubble_slots()) {
      gas += foam.has_bubble(b) ? foam.target_area[b] : 0;
    }
    EXPECT_NEAR(gas / total, 1, 1e-12) << where;
    EXPECT_NEAR(total_area(foam) / total, 1, 1e-12) << where;
  }
  EXPECT_GT(coarsening->foam().t1_count, 5);
  EXPECT_GT(coarsening->foam().t2_count, 5);
}

TEST(Coarsening, NothingIsInEquilibriumThatIsNotANumber) {
  Foam foam = random_foam(30, Boundary::Periodic, 1);
  for (Vec2& p : foam.position) {
    p.x = std::nan("");
  }
  EXPECT_FALSE(make_equilibrator({})->equilibrate(foam, 0, {}).converged);
}

TEST(Coarsening, RejectsOptionsOutOfRange) {
  const auto message = [](const CoarseningOptions& options) {
    try {
      make_coarsening(options);
    } catch (const FoamError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  CoarseningOptions options = thesis_options();
  options.time_step = -0.5;
  EXPECT_NE(message(options).find("TimeStep must be at least 0, but is -0.5"), std::string::npos);
  options = {};
  options.permeability = -2;
  EXPECT_NE(message(options).find("-2"), std::string::npos);
  options = {};
  options.permeability = std::nan("");
  EXPECT_NE(message(options).find("nan"), std::string::npos);
  options = {};
  options.equilibrator.tolerance = 0;
  EXPECT_NE(message(options).find("Tolerance"), std::string::npos);
}

} // namespace
} // namespace foam::test
