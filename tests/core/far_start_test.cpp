// SPDX-License-Identifier: GPL-3.0-or-later
//
// Foams that begin far from equilibrium: random points, as disordered as points can be.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "../newton_on_host.h"
#include "construct/from_points.h"
#include "engines/engines.h"
#include "equilibrium/compressible_relaxation.h"
#include "equilibrium/equilibrator.h"
#include "far_starts.h"
#include "physics/measured_targets.h"
#include "physics/obstacle.h"

namespace foam::test {
namespace {

/// Uniformly random points on a torus, a bubble of mean area 1 per point; target areas half-way
/// between those of the initial mesh and 1.
Foam poisson_foam(Index bubbles, std::uint64_t seed) {
  const double side = std::sqrt(bubbles);
  std::mt19937_64 generator(seed);
  std::vector<Vec2> points(place_of(bubbles));
  for (Vec2& p : points) {
    p.x = side * static_cast<double>(generator() >> 11) * 0x1p-53;
    p.y = side * static_cast<double>(generator() >> 11) * 0x1p-53;
  }
  BuildOptions options;
  options.boundary = Boundary::Periodic;
  options.torus = Lattice::rectangle(0, side, 0, side);
  Foam foam = build_from_points(points, options);
  for (double& area : foam.target_area) {
    area = 0.5 * (area + 1);
  }
  return foam;
}

TEST(FarStart, RandomPointsReachEquilibrium) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Foam foam = poisson_foam(400, seed);
    const EquilibriumReport report = make_equilibrator({})->equilibrate(foam, 0.1, {});
    expect_valid(foam);
    EXPECT_TRUE(report.converged) << seed;
    EXPECT_LT(max_angle_error(foam), 1e-8) << seed;
    EXPECT_LT(max_area_error(foam), 1e-8) << seed;
  }
}

TEST(FarStart, EqualAreasOnRandomPointsReachEquilibrium) {
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    expect_equilibrium_from({Points::Poisson, Boundary::Periodic, 196, 0, seed});
    expect_equilibrium_from({Points::Poisson, Boundary::Free, 100, 0, seed});
    expect_equilibrium_from({Points::Poisson, Boundary::Fixed, 100, 0, seed});
  }
}

TEST(FarStart, LognormalAreasReachEquilibrium) {
  for (const double variation : {0.5, 1.0, 1.5}) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      expect_equilibrium_from({Points::Jittered, Boundary::Periodic, 196, variation, seed});
      expect_equilibrium_from({Points::Poisson, Boundary::Free, 50, variation, seed});
      expect_equilibrium_from({Points::Poisson, Boundary::Periodic, 50, variation, seed});
      expect_equilibrium_from({Points::Jittered, Boundary::Fixed, 60, variation, seed});
    }
  }
}

// Their initial bubbles are n/2π times longer than wide.
TEST(FarStart, RingsReachEquilibrium) {
  for (Index n = 3; n <= 32; ++n) {
    expect_equilibrium_from({Points::Ring, Boundary::Free, n, 0, 0});
    expect_equilibrium_from({Points::RingRound, Boundary::Free, n + 1, 0, 0});
  }
}

TEST(FarStart, LongRingsReachEquilibrium) {
  expect_equilibrium_from({Points::RingRound, Boundary::Fixed, 151, 0, 0});
  expect_equilibrium_from({Points::Ring, Boundary::Fixed, 200, 0, 0});
}

TEST(FarStart, ClustersReachEquilibrium) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic, Boundary::Fixed}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      expect_equilibrium_from({Points::Clusters, boundary, 99, 0, seed});
    }
  }
}

// Bubbles of a thousandth of the mean area among such of twenty times that.
TEST(FarStart, WidelySpreadAreasReachEquilibrium) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic, Boundary::Fixed}) {
    for (std::uint64_t seed = 1; seed <= 3; ++seed) {
      expect_equilibrium_from({Points::Poisson, boundary, 50, 3, seed});
    }
  }
}

// A swap is asked for of films that are short beside their bubbles, whatever the mean is.
TEST(FarStart, TwoDensitiesReachEquilibrium) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic, Boundary::Fixed}) {
    Random random(1);
    std::vector<Vec2> points(100);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double side = i < 50 ? 1 : 100;
      points[i].x = side * random.uniform();
      points[i].y = side * random.uniform();
    }
    BuildOptions options;
    options.boundary = boundary;
    Foam foam = build_from_points(points, options);
    equilibrate(foam);
    expect_valid(foam);
    expect_equilibrium(foam);
  }
}

TEST(FarStart, NewtonsMethodWithoutAMatrixGetsThereToo) {
  for (std::uint64_t seed = 1; seed <= 3; ++seed) {
    Foam foam = FarStart{Points::Jittered, Boundary::Periodic, 100, 1, seed}.foam();
    KrylovEquilibrator({}).equilibrate(foam, 0.05, {});
    expect_valid(foam);
    expect_equilibrium(foam);
  }
}

// Blown up or shrunk as a whole it is the same foam at the same place, whatever presses on it from
// around: the world's pressure is given, and only what bubbles have more of it goes with their
// size.
TEST(FarStart, AFreeFoamOfAnotherSizeIsTheSame) {
  Foam before = FarStart{Points::Jittered, Boundary::Free, 60, 0.3, 1}.foam();
  equilibrate(before);
  const Vec2 middle{3, 5};
  for (const double world : {0.0, 10.0}) {
    for (const double size : {1e-4, 1e-3, 0.4, 3.0, 300.0, 1000.0, 1e4}) {
      Foam foam = before;
      for (Vec2& x : foam.position) {
        x = middle + size * (x - middle);
      }
      foam.exterior[kWorld.outside()].pressure = world;
      for (double& pressure : foam.pressure) {
        pressure += world;
      }
      equilibrate(foam);
      expect_valid(foam);
      expect_equilibrium(foam);
      EXPECT_EQ(foam.exterior[kWorld.outside()].pressure, world);
      EXPECT_EQ(foam.t1_count, before.t1_count) << size;
      EXPECT_NEAR(foam.energy(), before.energy(), 1e-10 * before.energy()) << size;
      for (const Bubble b : foam.bubble_slots()) {
        EXPECT_NEAR(foam.pressure[b] - world, before.pressure[b], 1e-9);
      }
      EXPECT_LE(foam.report.iterations, 10);
    }
  }
}

// Pressures of another size go with the arcs again, the world's being what it was.
TEST(FarStart, PressuresAreFittedAboveTheWorlds) {
  Foam foam = FarStart{Points::Jittered, Boundary::Free, 60, 0.3, 1}.foam();
  equilibrate(foam);
  constexpr double kSize = 3;
  constexpr double kAround = 10;
  const Foam before = foam;
  for (Vec2& x : foam.position) {
    x = kSize * x;
  }
  foam.exterior[kWorld.outside()].pressure = kAround;
  for (double& pressure : foam.pressure) {
    pressure += kAround;
  }
  EXPECT_GT(max_curvature_error(foam), 0.1);
  EXPECT_NEAR(fit_bubble_pressures(foam), 1 / kSize, 1e-9);
  EXPECT_LT(max_curvature_error(foam), 1e-8);
  EXPECT_EQ(foam.exterior[kWorld.outside()].pressure, kAround);
  for (const Bubble b : foam.bubble_slots()) {
    EXPECT_NEAR(foam.pressure[b], kAround + before.pressure[b] / kSize, 1e-8);
  }
}

// The iterations reported are those it takes: no fewer do.
TEST(FarStart, MaximumIterationsIsWhatItSays) {
  const FarStart start{Points::Poisson, Boundary::Periodic, 100, 1, 1};
  Foam foam = start.foam();
  equilibrate(foam);
  ASSERT_TRUE(foam.report.converged);
  EquilibratorOptions options;
  options.maximum_iterations = foam.report.iterations;
  Foam enough = start.foam();
  make_equilibrator(options)->equilibrate(enough, 0.05 * enough.mean_spacing(), {});
  EXPECT_TRUE(enough.report.converged);
  EXPECT_EQ(enough.position, foam.position);
  --options.maximum_iterations;
  Foam short_of_one = start.foam();
  make_equilibrator(options)->equilibrate(short_of_one, 0.05 * short_of_one.mean_spacing(), {});
  EXPECT_FALSE(short_of_one.report.converged);
  EXPECT_EQ(short_of_one.report.iterations, options.maximum_iterations);
}

// A foam in the units of another is relaxed to the same one.
TEST(FarStart, SoftGasFeelsNoUnits) {
  const Foam start = FarStart{Points::Poisson, Boundary::Free, 100, 1, 1}.foam();
  Foam here = start;
  EXPECT_TRUE(relax_compressible(here, 0.05, 0.1, {}));
  constexpr double kLength = 0x1p-20;
  constexpr double kTension = 0x1p7;
  Foam there = start;
  there.surface_tension *= kTension;
  for (Vec2& x : there.position) {
    x = kLength * x;
  }
  for (double& area : there.target_area) {
    area *= kLength * kLength;
  }
  EXPECT_TRUE(relax_compressible(there, 0.05, 0.1, {}));
  EXPECT_EQ(there.t1_count, here.t1_count);
  for (const Junction j : here.junction_slots()) {
    EXPECT_EQ(there.position[j], kLength * here.position[j]);
  }
  for (const Bubble b : here.bubble_slots()) {
    EXPECT_EQ(there.pressure[b], kTension / kLength * here.pressure[b]);
  }
}

TEST(FarStart, SoftGasLeavesAFoamNearEquilibrium) {
  Foam foam = poisson_foam(400, 1);
  const double angle_error = max_angle_error(foam);
  const double area_error = max_area_error(foam);
  EXPECT_TRUE(relax_compressible(foam, 0.1, 0.1, {}));
  expect_valid(foam);
  EXPECT_GT(angle_error, 1.0);
  EXPECT_GT(area_error, 0.5);
  EXPECT_LT(max_area_error(foam), 0.1);
  Index unbalanced = 0;
  for (const Junction j : foam.junction_slots()) {
    Vec2 pull;
    for (const Half h : foam.junction_half[j]) {
      pull += foam.tangent(h);
    }
    unbalanced += norm(pull) > 0.1 ? 1 : 0;
  }
  EXPECT_LT(unbalanced, foam.junction_count() / 100);
}

TEST(Obstacle, IsTheJunctionFilmOrBubbleThatIsFurthestOff) {
  const auto contains = [](const Foam& foam, const std::string& part) {
    return obstacle(foam).find(part) != std::string::npos;
  };
  const Foam straight =
      jittered_foam(Boundary::Periodic, 16, 1); // with the areas that it is to have
  EXPECT_TRUE(contains(straight, "is pulled by its films with")) << obstacle(straight);
  Foam foam = double_bubble(1, 1);
  equilibrate(foam);
  const Foam balanced = foam;
  foam.target_area[Bubble(1)] = 4;
  EXPECT_TRUE(contains(foam, "bubble 1 of 2 sides has the area 0.9999")) << obstacle(foam);
  foam = balanced;
  foam.pressure[Bubble(0)] += 100;
  EXPECT_TRUE(contains(foam, "the film between bubble")) << obstacle(foam);
}

} // namespace
} // namespace foam::test
