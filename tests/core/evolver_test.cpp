// SPDX-License-Identifier: GPL-3.0-or-later
// Against a periodic foam of 100 bubbles brought to equilibrium by Surface Evolver.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "engines/engines.h"
#include "mesh/validate.h"
#include "physics/equilibrium_measures.h"
#include "reference.h"

namespace foam::test {
namespace {

double mean_pressure(const Foam& foam) {
  double sum = 0;
  for (const double p : foam.pressure) {
    sum += p;
  }
  return sum / static_cast<double>(foam.pressure.size());
}

TEST(Evolver, ReferenceIsInEquilibriumByOurGeometry) {
  const Foam foam = foam_of(evolver_foam());
  EXPECT_TRUE(validate(foam).empty());
  EXPECT_TRUE(validate_geometry(foam).empty());
  EXPECT_NEAR(foam.energy(), 189.399110096385, 1e-9);
  EXPECT_LT(max_angle_error(foam), 5.3e-7 * std::numbers::pi / 180);
  EXPECT_LT(max_area_error(foam), 1e-12);
}

TEST(Evolver, SameEquilibriumFromDisturbedPositions) {
  const Foam reference = foam_of(evolver_foam());
  Foam foam = reference;
  std::mt19937 random(1);
  std::uniform_real_distribution<double> displacement(-0.02, 0.02);
  for (Vec2& x : foam.position) {
    x += Vec2{displacement(random), displacement(random)};
  }
  std::ranges::fill(foam.pressure, 0.0);
  std::ranges::fill(foam.film_angle, 0.0);
  EquilibratorOptions options;
  options.tolerance = 1e-12;
  const auto report = make_equilibrator(options)->equilibrate(foam, 0, {});
  EXPECT_TRUE(report.converged);
  EXPECT_LT(report.max_angle_error, 1e-11);
  EXPECT_LT(report.max_area_error, 1e-12);
  EXPECT_NEAR(foam.energy(), reference.energy(), 1e-9);
  double largest = 0;
  for (const Bubble b : foam.bubble_slots()) {
    largest = std::max(largest, std::abs(foam.pressure[b] - mean_pressure(foam) -
                                         reference.pressure[b] + mean_pressure(reference)));
  }
  EXPECT_LT(largest, 1e-6);
  std::cout << "iterations " << report.iterations << ", residual " << report.residual
            << ", length error " << foam.energy() - reference.energy() << ", pressure error "
            << largest << '\n';
}

} // namespace
} // namespace foam::test
