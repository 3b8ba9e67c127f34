// SPDX-License-Identifier: GPL-3.0-or-later
// Foams in containers, on whose walls films are pinned.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "containers.h"
#include "engines/engines.h"
#include "foams.h"
#include "physics/gas.h"

namespace foam::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// containers(), with films that are pinned.
std::vector<std::pair<std::string, Container>> pinned_containers() {
  auto all = containers();
  for (auto& [name, container] : all) {
    for (Wall& wall : container.walls) {
      wall.contact = WallContact::Pinned;
    }
  }
  return all;
}

std::vector<Vec2> ends_on_walls(const Foam& foam) {
  std::vector<Vec2> ends;
  for (const Junction j : foam.junction_slots()) {
    if (foam.has_junction(j) && foam.on_wall(j)) {
      ends.push_back(foam.position[j]);
    }
  }
  return ends;
}

/// The film that two bubbles in a rectangle share bulges between its ends as their areas ask.
TEST(PinnedWalls, OneFilmAcrossARectangleIsAnArc) {
  for (const double half_angle : {0.25, 0.5 * kPi, 2.0}) {
    const double height = 1;
    const double bulge = segment_area(height, half_angle);
    Foam foam = filled(rectangle({0, 6, 0, height}, WallContact::Pinned), {{2, 0.5}, {4, 0.5}});
    for (const Junction j : foam.junction_slots()) {
      foam.put_on_wall(j, wall_place(foam, Outside(0), {3, std::round(foam.position[j].y)}));
    }
    foam.target_area = {3 + bulge, 3 - bulge};
    equilibrate(foam, 1e-12);
    expect_equilibrium(foam);
    EXPECT_NEAR(foam.energy(), height * half_angle / std::sin(half_angle), 1e-10);
    EXPECT_NEAR(foam.pressure[Bubble(0)] - foam.pressure[Bubble(1)],
                2 * std::sin(half_angle) / height, 1e-10);
  }
}

TEST(PinnedWalls, FilmsStayWhereTheyEnd) {
  int compared = 0;
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    for (const auto& [name, container] : pinned_containers()) {
      BuildOptions options;
      options.boundary = Boundary::Container;
      options.container = container;
      Foam foam = build_from_points(points_in(container, 40, seed), options);
      const std::vector<Vec2> before = ends_on_walls(foam);
      EXPECT_FALSE(before.empty());
      equilibrate(foam);
      expect_equilibrium(foam, name);
      if (foam.t1_count == 0) {
        EXPECT_EQ(ends_on_walls(foam), before) << name << ' ' << seed;
        ++compared;
      }
    }
  }
  EXPECT_GT(compared, 5);
}

/// That dE = Σ p·dA at fixed ends.
TEST(PinnedWalls, PressuresAreWhatGasCosts) {
  for (const auto& [name, container] : pinned_containers()) {
    const Foam foam = random_foam_in(container, 20, 1);
    expect_equilibrium(foam, name);
    const double gas = 1e-4 * foam.mean_area();
    for (Index b = 1; b < 20; ++b) {
      const auto energy_with = [&](double moved) {
        Foam other = foam;
        other.target_area[Bubble(0)] -= moved;
        other.target_area[Bubble(b)] += moved;
        equilibrate(other, 1e-12);
        EXPECT_EQ(other.t1_count, foam.t1_count) << name;
        return other.energy();
      };
      EXPECT_NEAR((energy_with(gas) - energy_with(-gas)) / (2 * gas),
                  foam.pressure[Bubble(b)] - foam.pressure[Bubble(0)], 1e-5)
          << name << ' ' << b;
    }
  }
}

/// Films let through κT for each radian by which they turn, and what they turn by is what is left
/// of 2π by walls and corners: π/3 where three films meet, and at a wall what the angle there is
/// short of π.
double growth_by_turning(const Foam& foam, Bubble bubble, double kappa) {
  double turn = 0;
  for_each_half(foam, bubble, [&](Half h) {
    turn += foam.wall(h) ? foam.stretch(h).turn : 0;
    const Junction j = foam.start(h);
    if (!foam.on_wall(j)) {
      turn += kPi / 3;
      return;
    }
    const Half off = foam.off_wall(j);
    const Vec2 along = tangent_of(foam, foam.place_on_wall(j));
    const double angle = angle_from_to(along, foam.tangent(off)); // of what lies ahead on the wall
    turn += off == h ? angle : kPi - angle;
  });
  return kappa * foam.reference_tension() * (turn - 2 * kPi);
}

TEST(PinnedWalls, GrowthIsWhatTurningLeavesAndSumsToZero) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    for (const auto& [name, container] : pinned_containers()) {
      const Foam foam = random_foam_in(container, 30, seed);
      expect_equilibrium(foam, name);
      const AreaRate rate = area_rate(view_of(foam), 1);
      double total = 0;
      for (const Bubble b : foam.bubble_slots()) {
        EXPECT_NEAR(rate(b), growth_by_turning(foam, b, 1), 1e-8) << name << ' ' << seed;
        total += rate(b);
      }
      EXPECT_NEAR(total, 0, 1e-10) << name << ' ' << seed;
    }
  }
}

/// Where nothing is pinned the same account leads to von Neumann's law.
TEST(PinnedWalls, TurningGivesVonNeumannsLawWhereFilmsSlip) {
  for (const auto& [name, container] : containers()) {
    const Foam foam = random_foam_in(container, 30, 1);
    for (const Bubble b : foam.bubble_slots()) {
      bool held = false; // by an edge
      for_each_half(foam, b, [&](Half h) { held = held || !foam.freedom(foam.start(h)).any(); });
      if (!held) {
        EXPECT_NEAR(growth_by_turning(foam, b, 1),
                    von_neumann_constant(foam.surface_tension, 1) * growth_on_walls(foam, b), 1e-8)
            << name;
      }
    }
  }
}

TEST(PinnedWalls, CoarseningKeepsGasAndShape) {
  for (const Stepping stepping : {Stepping::Events, Stepping::FixedSteps}) {
    for (const auto& [name, container] : pinned_containers()) {
      const Foam start = random_foam_in(container, 30, 2);
      CoarseningOptions options;
      options.stepping = stepping;
      options.time_step = 0.04 * start.mean_area();
      const auto coarsening = make_coarsening(options);
      coarsening->restart(start);
      const double before = gas(start);
      for (int frame = 0; frame < 40; ++frame) {
        ASSERT_TRUE(coarsening->advance({})) << name;
        const Foam& foam = coarsening->foam();
        expect_equilibrium(foam, name);
        EXPECT_NEAR(gas(foam), before, 1e-12 * before) << name;
        EXPECT_NEAR(sum(foam, [&](Bubble b) { return foam.area(b); }), before, 1e-12 * before)
            << name;
      }
      expect_valid(coarsening->foam(), name);
      EXPECT_LT(coarsening->foam().bubble_count(), 30) << name;
    }
  }
}

} // namespace
} // namespace foam::test
