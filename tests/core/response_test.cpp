// SPDX-License-Identifier: GPL-3.0-or-later
//
// How an equilibrium moves while areas change (newton::FactorisingSolver::response).
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "containers.h"
#include "equilibrium/factorising_solver.h"
#include "foams.h"
#include "physics/gas.h"

namespace foam::test {
namespace {

constexpr double kPermeability = 1;

/// A step of the whole foam, by element.
struct WholeRates {
  WholeRates(const Foam& foam, const Region& region, const newton::StepView& step)
      : junctions(foam.position.size()), angles(foam.film_angle.size()),
        pressures(foam.pressure.size()) {
    for (const Junction j : region.junctions) {
      junctions[j] = step.junction[j];
    }
    for (const Film f : region.films) {
      angles[f] = step.angle[f];
    }
    for (const Bubble b : region.bubbles) {
      pressures[b] = step.pressure[b];
    }
  }
  Rates view() const { return {junctions, angles, pressures}; }

  Field<Junction, Vec2> junctions;
  Field<Film, double> angles;
  Field<Bubble, double> pressures;
};

/// Without a factorisation to begin with, the matrix at hand is factorised and solved once.
WholeRates whole_response(const Foam& foam, const Field<Bubble, double>& area_rate) {
  newton::FactorisingSolver solver;
  solver.set_up(foam, whole_foam(foam));
  const newton::StepView* step = solver.response(foam, area_rate, {}, 0);
  EXPECT_NE(step, nullptr);
  return {foam, solver.region(), *step};
}

class Response : public testing::TestWithParam<Boundary> {};

/// Fails unless the response is the central difference of equilibria.
void expect_derivative(Foam foam, const std::string& where = {}) {
  equilibrate(foam, 1e-13);
  const Field<Bubble, double> area_rate = area_rates(foam, kPermeability);
  const WholeRates rates = whole_response(foam, area_rate);
  const double dt = 1e-5;
  const auto later = [&](double time) {
    Foam moved = foam;
    for (const Bubble b : moved.bubble_slots()) {
      moved.target_area[b] += time * area_rate[b];
    }
    equilibrate(moved, 1e-13);
    EXPECT_EQ(moved.topology, foam.topology) << where;
    return moved;
  };
  const Foam after = later(dt);
  const Foam before = later(-dt);
  double largest = 0;
  double difference = 0;
  for (const Film f : foam.film_slots()) {
    const Half h = f.half();
    if (foam.wall(h)) {
      continue;
    }
    const double found = (norm(after.chord(h)) - norm(before.chord(h))) / (2 * dt);
    const Vec2 along = (1 / norm(foam.chord(h))) * foam.chord(h);
    const double expected =
        dot(along, rates.junctions[foam.end(h)] - rates.junctions[foam.start(h)]);
    largest = std::max(largest, std::abs(found));
    difference = std::max(difference, std::abs(found - expected));
    const double turned = (after.half_angle(h) - before.half_angle(h)) / (2 * dt);
    EXPECT_NEAR(rates.angles[f], turned, 1e-4 * (1 + std::abs(turned))) << where;
  }
  EXPECT_GT(largest, 0) << where;
  EXPECT_LT(difference, 1e-4 * largest) << where;
}

TEST_P(Response, IsTheEquilibriumsDerivative) {
  expect_derivative(random_foam(40, GetParam()));
}

TEST(ResponseBetweenWalls, IsTheEquilibriumsDerivative) {
  for (const auto& [name, container] : containers()) {
    expect_derivative(random_foam_in(container, 40, 3), name);
  }
}

/// Nothing holds a foam in a disc or an annulus that turns, or one that moves along a channel.
TEST(ResponseBetweenWalls, HasNoMotionOfTheWhole) {
  for (const auto& [name, container] : containers()) {
    const Foam foam = random_foam_in(container, 40, 3);
    const Surroundings& around = foam.surroundings;
    EXPECT_EQ(around.translates_along_x(), name == "channel") << name;
    EXPECT_FALSE(around.translates_along_y()) << name;
    EXPECT_EQ(around.rotates(), name == "disc" || name == "annulus") << name;
    const WholeRates rates = whole_response(foam, area_rates(foam, kPermeability));
    double along = 0;
    double round = 0;
    double all = 0;
    for (const Junction j : foam.junction_slots()) {
      const Vec2 rate = rates.junctions[j];
      along += rate.x;
      round += cross(foam.position[j], rate);
      all += norm(rate) * (1 + norm(foam.position[j]));
    }
    EXPECT_LT(around.translates_along_x() ? std::abs(along) : 0, 1e-9 * all) << name;
    EXPECT_LT(around.rotates() ? std::abs(round) : 0, 1e-9 * all) << name;
  }
}

/// Central differences of rates. Those of a foam of one tension, away from walls, stay.
TEST_P(Response, ChangesAreaRates) {
  for (const double unevenness : {0.0, 0.2}) {
    Foam foam = random_foam(40, GetParam());
    if (unevenness > 0) {
      pull_unevenly(foam, unevenness, 1);
    }
    equilibrate(foam, 1e-13);
    const Field<Bubble, double> rate = area_rates(foam, kPermeability);
    const Field<Bubble, double> change =
        area_rate_changes(foam, kPermeability, whole_response(foam, rate).angles);
    const double dt = 1e-5;
    const auto rates_at = [&](double time) {
      Foam moved = foam;
      for (const Bubble b : moved.bubble_slots()) {
        moved.target_area[b] += time * rate[b];
      }
      equilibrate(moved, 1e-13);
      EXPECT_EQ(moved.topology, foam.topology);
      return area_rates(moved, kPermeability);
    };
    const Field<Bubble, double> after = rates_at(dt);
    const Field<Bubble, double> before = rates_at(-dt);
    double largest = 0;
    for (const Bubble b : foam.bubble_slots()) {
      const double found = (after[b] - before[b]) / (2 * dt);
      EXPECT_NEAR(change[b], found, 1e-5 * (1 + std::abs(found)));
      largest = std::max(largest, std::abs(change[b]));
    }
    EXPECT_EQ(area_rates_change(foam), largest > 0);
    EXPECT_EQ(area_rates_change(foam), unevenness > 0 || GetParam() == Boundary::Fixed);
  }
}

/// A patch whose surroundings move with the whole foam moves with it; one whose surroundings are
/// taken to be at rest does not.
TEST_P(Response, OfAPatchIsThatOfItsSurroundings) {
  const Foam foam = random_foam(200, GetParam());
  const Field<Bubble, double> area_rate = area_rates(foam, kPermeability);
  const WholeRates rates = whole_response(foam, area_rate);
  newton::FactorisingSolver solver;
  solver.set_up(foam, patch(foam, std::array{Bubble(100)}, 2));
  const Region& region = solver.region();
  ASSERT_LT(region.bubbles.size(), 100U);
  const auto differences = [&](const Rates& around) {
    const newton::StepView* step = solver.response(foam, area_rate, around, 1e-12);
    double junctions = 0;
    for (const Junction j : region.junctions) {
      junctions = std::max(junctions, norm(step->junction[j] - rates.junctions[j]));
    }
    double angles = 0;
    for (const Film f : region.films) {
      angles = std::max(angles, std::abs(step->angle[f] - rates.angles[f]));
    }
    double pressures = 0;
    for (const Bubble b : region.bubbles) {
      pressures = std::max(pressures, std::abs(step->pressure[b] - rates.pressures[b]));
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
  const Field<Bubble, double> area_rate = area_rates(foam, kPermeability);
  const WholeRates rates = whole_response(foam, area_rate);
  WholeRates wrong = rates;
  for (double& angle : wrong.angles) {
    angle *= 0.7;
  }
  for (Vec2& junction : wrong.junctions) {
    junction = 1.3 * junction;
  }
  newton::FactorisingSolver solver;
  solver.set_up(foam, whole_foam(foam));
  ASSERT_NE(solver.response(foam, area_rate, {}, 0), nullptr); // which leaves a factorisation
  const double drift = 1e-9;
  const newton::StepView* step = solver.response(foam, area_rate, wrong.view(), drift);
  ASSERT_NE(step, nullptr);
  double largest = 0;
  double difference = 0;
  for (const Film f : solver.region().films) {
    largest = std::max(largest, std::abs(rates.angles[f]));
    difference = std::max(difference, std::abs(step->angle[f] - rates.angles[f]));
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
