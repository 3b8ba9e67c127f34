// SPDX-License-Identifier: GPL-3.0-or-later
//
// How an equilibrium moves while areas change (LagrangianSystem::response).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "coarsening/diffusion.h"
#include "equilibrium/lagrangian_system.h"
#include "foams.h"

namespace foam::test {
namespace {

constexpr double kPermeability = 1;

/// A step of the whole foam, by element.
struct WholeRates {
  WholeRates(const Foam& foam, const Region& region, const Step& step)
      : junctions(foam.position.size()), angles(foam.film_angle.size()),
        pressures(foam.pressure.size()) {
    for (std::size_t i = 0; i < region.junctions.size(); ++i) {
      junctions[Foam::size(region.junctions[i])] = step.junctions[i];
    }
    for (std::size_t i = 0; i < region.films.size(); ++i) {
      angles[Foam::size(region.films[i])] = step.angles[i];
    }
    for (std::size_t i = 0; i < region.bubbles.size(); ++i) {
      pressures[Foam::size(region.bubbles[i])] = step.pressures[i];
    }
  }
  Rates view() const { return {junctions, angles, pressures}; }

  std::vector<Vec2> junctions;
  std::vector<double> angles;
  std::vector<double> pressures;
};

WholeRates whole_response(const Foam& foam, const std::vector<double>& area_rate) {
  LagrangianSystem system;
  system.set_up(foam, whole_foam(foam));
  system.evaluate(foam);
  EXPECT_TRUE(system.factorise(foam, foam.bubble_capacity()));
  const Step* step = system.response(foam, area_rate, {}, LagrangianSystem::kAnyDrift);
  EXPECT_NE(step, nullptr);
  return {foam, system.region(), *step};
}

class Response : public testing::TestWithParam<Boundary> {};

/// Central differences of equilibria.
TEST_P(Response, IsTheEquilibriumsDerivative) {
  Foam foam = random_foam(40, GetParam());
  equilibrate(foam, 1e-13);
  const std::vector<double> area_rate = area_rates(foam, kPermeability);
  const WholeRates rates = whole_response(foam, area_rate);
  const double dt = 1e-5;
  const auto later = [&](double time) {
    Foam moved = foam;
    for (std::size_t b = 0; b < area_rate.size(); ++b) {
      moved.target_area[b] += time * area_rate[b];
    }
    equilibrate(moved, 1e-13);
    EXPECT_EQ(moved.topology, foam.topology);
    return moved;
  };
  const Foam after = later(dt);
  const Foam before = later(-dt);
  double largest = 0;
  double difference = 0;
  for (Index f = 0; f < foam.film_capacity(); ++f) {
    if (foam.wall(2 * f)) {
      continue;
    }
    const double found = (norm(after.chord(2 * f)) - norm(before.chord(2 * f))) / (2 * dt);
    const Vec2 along = (1 / norm(foam.chord(2 * f))) * foam.chord(2 * f);
    const double expected = dot(along, rates.junctions[Foam::size(foam.end(2 * f))] -
                                           rates.junctions[Foam::size(foam.start(2 * f))]);
    largest = std::max(largest, std::abs(found));
    difference = std::max(difference, std::abs(found - expected));
    const double turned = (after.half_angle(2 * f) - before.half_angle(2 * f)) / (2 * dt);
    EXPECT_NEAR(rates.angles[Foam::size(f)], turned, 1e-4 * (1 + std::abs(turned)));
  }
  EXPECT_GT(largest, 0);
  EXPECT_LT(difference, 1e-4 * largest);
}

/// A patch whose surroundings move with the whole foam moves with it; one whose surroundings are
/// taken to be at rest does not.
TEST_P(Response, OfAPatchIsThatOfItsSurroundings) {
  const Foam foam = random_foam(200, GetParam());
  const std::vector<double> area_rate = area_rates(foam, kPermeability);
  const WholeRates rates = whole_response(foam, area_rate);
  LagrangianSystem system;
  system.set_up(foam, patch(foam, std::vector<Index>{100}, 2));
  system.evaluate(foam);
  ASSERT_TRUE(system.factorise(foam, foam.bubble_capacity()));
  const Region& region = system.region();
  ASSERT_LT(region.bubbles.size(), 100U);
  const auto differences = [&](const Rates& around) {
    const Step* step = system.response(foam, area_rate, around, LagrangianSystem::kAnyDrift);
    double junctions = 0;
    for (std::size_t i = 0; i < region.junctions.size(); ++i) {
      const Vec2 other = rates.junctions[Foam::size(region.junctions[i])];
      junctions = std::max(junctions, norm(step->junctions[i] - other));
    }
    double angles = 0;
    for (std::size_t i = 0; i < region.films.size(); ++i) {
      const double other = rates.angles[Foam::size(region.films[i])];
      angles = std::max(angles, std::abs(step->angles[i] - other));
    }
    double pressures = 0;
    for (std::size_t i = 0; i < region.bubbles.size(); ++i) {
      const double other = rates.pressures[Foam::size(region.bubbles[i])];
      pressures = std::max(pressures, std::abs(step->pressures[i] - other));
    }
    return std::max({junctions, angles, pressures});
  };
  const double at_rest = differences({});
  EXPECT_GT(at_rest, 0);
  EXPECT_LT(differences(rates.view()), 1e-5 * at_rest);
}

/// With what the iteration begins does not matter.
TEST_P(Response, IsTheSameFromWhateverIsExpected) {
  const Foam foam = random_foam(60, GetParam());
  const std::vector<double> area_rate = area_rates(foam, kPermeability);
  const WholeRates rates = whole_response(foam, area_rate);
  WholeRates wrong = rates;
  for (std::size_t f = 0; f < wrong.angles.size(); ++f) {
    wrong.angles[f] *= 0.7;
  }
  for (std::size_t j = 0; j < wrong.junctions.size(); ++j) {
    wrong.junctions[j] = 1.3 * wrong.junctions[j];
  }
  LagrangianSystem system;
  system.set_up(foam, whole_foam(foam));
  system.evaluate(foam);
  ASSERT_TRUE(system.factorise(foam, foam.bubble_capacity()));
  const double drift = 1e-9;
  const Step* step = system.response(foam, area_rate, wrong.view(), drift);
  ASSERT_NE(step, nullptr);
  double largest = 0;
  double difference = 0;
  for (std::size_t i = 0; i < system.region().films.size(); ++i) {
    const double expected = rates.angles[Foam::size(system.region().films[i])];
    largest = std::max(largest, std::abs(expected));
    difference = std::max(difference, std::abs(step->angles[i] - expected));
  }
  EXPECT_GT(largest, 0);
  EXPECT_LT(difference, 1e-6 * largest);
}

INSTANTIATE_TEST_SUITE_P(Everywhere, Response,
                         testing::Values(Boundary::Free, Boundary::Fixed, Boundary::Periodic),
                         [](const auto& tested) {
                           return std::string(tested.param == Boundary::Free    ? "Free"
                                              : tested.param == Boundary::Fixed ? "Fixed"
                                                                                : "Periodic");
                         });

} // namespace
} // namespace foam::test
