// SPDX-License-Identifier: GPL-3.0-or-later
//
// The energy-based root search of the thesis's section 7.1.1.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "construct/jittered_grid.h"
#include "engines/engines.h"
#include "junction_foams.h"
#include "thesis/junction_equilibrator.h"

namespace foam {
namespace {

using namespace thesis;
using std::numbers::pi;

constexpr std::array kSearches{EnergyRootSearch{EnergyTarget::Zero},
                               EnergyRootSearch{EnergyTarget::Straight}};
constexpr DifferenceOptions kFine{1e-4, 1, 1e-5};

EquilibratorOptions options_with(RootSearch search, EnergyTarget target) {
  EquilibratorOptions options;
  options.kind = EquilibratorKind::Junction;
  options.junction.root_search = search;
  options.junction.energy_target = target;
  options.junction.energy_decay = false;
  return options;
}

JunctionStep step_of(const EnergyRootSearch& search, const Foam& foam, Junction j) {
  const JunctionStar star = junction_star(foam, j);
  return search.solve(star, junction_system(search, foam, j, star, kFine));
}

Foam random_periodic_foam(std::uint64_t seed) {
  BuildOptions build;
  build.boundary = Boundary::Periodic;
  return build_from_points(jittered_grid(64, 1, 1, seed), build);
}

/// Mean deviation from 120° of the angles between films, rad.
double mean_angle_error(const Foam& foam) {
  double sum = 0;
  for (const Junction j : foam.junction_slots()) {
    for (const Half h : foam.junction_half[j]) {
      const double angle =
          angle_from_to(foam.tangent(h), foam.tangent(foam.next_around_junction(h)));
      sum += std::abs(angle - 2 * pi / 3);
    }
  }
  return sum / (3 * foam.junction_count());
}

// Least squares.

TEST(LeastSquares, FitsALine) { // 5 − 3t has the least squares to (0, 6), (1, 0), (2, 0)
  const std::array<std::array<double, 2>, 3> a{{{1, 0}, {1, 1}, {1, 2}}};
  const auto z = least_squares(a, std::array<double, 3>{6, 0, 0}, {false, false});
  EXPECT_NEAR(z[0], 5, 1e-14);
  EXPECT_NEAR(z[1], -3, 1e-14);
  const auto constant = least_squares(a, std::array<double, 3>{6, 0, 0}, {false, true});
  EXPECT_NEAR(constant[0], 2, 1e-14);
  EXPECT_EQ(constant[1], 0);
}

TEST(LeastSquares, LeavesARemainderThatIsNormalToTheColumns) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (std::size_t left_out = 0; left_out <= 5; ++left_out) { // 5: none
    std::array<bool, 5> ignored{};
    std::array<std::array<double, 5>, 6> a{};
    std::array<double, 6> x{};
    for (std::size_t c = 0; c < 5; ++c) {
      ignored[c] = c == left_out;
    }
    for (std::size_t r = 0; r < 6; ++r) {
      std::ranges::generate(a[r], [&] { return uniform(generator); });
      x[r] = uniform(generator);
    }
    const auto z = least_squares(a, x, ignored);
    for (std::size_t c = 0; c < 5; ++c) {
      double product = 0;
      for (std::size_t r = 0; r < 6; ++r) {
        double remainder = x[r];
        for (std::size_t d = 0; d < 5; ++d) {
          remainder -= a[r][d] * z[d];
        }
        product += remainder * a[r][c];
      }
      if (ignored[c]) {
        EXPECT_EQ(z[c], 0);
        EXPECT_GT(std::abs(product), 1e-3);
      } else {
        EXPECT_NEAR(product, 0, 1e-14);
      }
    }
  }
}

TEST(LeastSquares, DependentColumnsAreNotFinite) {
  const std::array<double, 3> x{1, 2, 3};
  const std::array<std::array<double, 2>, 3> multiple{{{0.1, 0.3}, {0.2, 0.6}, {0.7, 2.1}}};
  const std::array<std::array<double, 2>, 3> nothing{{{1, 0}, {2, 0}, {7, 0}}};
  for (const auto& a : {multiple, nothing}) {
    const auto z = least_squares(a, x, {false, false});
    EXPECT_FALSE(std::isfinite(z[0] + z[1]));
    EXPECT_TRUE(std::isfinite(least_squares(a, x, {false, true})[0]));
  }
}

// The local minimum: straight films.

TEST(SteinerPoint, IsTheCentreOfAnEquilateralTriangle) {
  const double s = std::sqrt(0.75);
  const Vec2 shift{3, -7};
  const Vec2 p = steiner_point({shift + Vec2{0, 1}, shift + Vec2{-s, -0.5}, shift + Vec2{s, -0.5}});
  EXPECT_NEAR(p.x, shift.x, 1e-14);
  EXPECT_NEAR(p.y, shift.y, 1e-14);
}

TEST(SteinerPoint, IsTheCornerOf120DegreesOrMore) {
  const Vec2 corner{1, 2};
  for (const double angle : {2 * pi / 3 + 1e-9, 2.5, pi}) { // the last is a line
    for (const double sign : {1.0, -1.0}) {
      const Vec2 a = corner + Vec2{2, 0};
      const Vec2 b = corner + rotated({0.5, 0}, sign * angle);
      EXPECT_EQ(steiner_point({a, b, corner}), corner);
      EXPECT_EQ(steiner_point({corner, a, b}), corner);
    }
  }
  // It gets there without a jump.
  const Vec2 beside =
      steiner_point({corner, corner + Vec2{2, 0}, corner + rotated({0.5, 0}, 2 * pi / 3 - 1e-6)});
  EXPECT_LT(norm(beside - corner), 1e-5);
  EXPECT_NE(beside, corner);
}

TEST(SteinerPoint, IsThePlaceThatTwoCornersShare) {
  EXPECT_EQ(steiner_point({Vec2{1, 2}, Vec2{5, 5}, Vec2{1, 2}}), (Vec2{1, 2}));
  EXPECT_EQ(steiner_point({Vec2{1, 2}, Vec2{1, 2}, Vec2{1, 2}}), (Vec2{1, 2}));
}

TEST(SteinerPoint, SeesTheCornersUnder120DegreesAndHasTheLeastSum) {
  std::mt19937 generator(2);
  std::uniform_real_distribution<double> uniform(-1, 1);
  int acute = 0;
  while (acute < 20) {
    std::array<Vec2, 3> corner{};
    double largest = 0;
    double squares = 0;
    std::ranges::generate(corner, [&] { return Vec2{uniform(generator), uniform(generator)}; });
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 a = corner[after(k)] - corner[k];
      const Vec2 b = corner[before(k)] - corner[k];
      largest = std::max(largest, std::abs(angle_from_to(a, b)));
      squares += dot(a, a);
    }
    if (largest > 0.99 * 2 * pi / 3) {
      continue;
    }
    ++acute;
    const Vec2 p = steiner_point(corner);
    double sum = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      sum += norm(corner[k] - p);
      EXPECT_NEAR(std::abs(angle_from_to(corner[k] - p, corner[after(k)] - p)), 2 * pi / 3, 1e-10);
    }
    // (Σd)² = ½Σ(sides)² + 2√3·area
    const double twice_area = std::abs(cross(corner[1] - corner[0], corner[2] - corner[0]));
    EXPECT_NEAR(sum * sum, 0.5 * squares + std::sqrt(3) * twice_area, 1e-13);
  }
}

// The system.

TEST(EnergyRootSearch, EnergiesAreTheFilms) {
  Foam foam = honeycomb(6, 3);
  disturb(foam, 0.1, 1);
  set_half_angles(foam);
  for (const Junction j : foam.junction_slots()) {
    const auto energy = EnergyRootSearch::values(junction_star(foam, j));
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(energy[k], 2 * 0.25 * foam.length(foam.junction_half[j][k]), 1e-14);
    }
  }
}

TEST(EnergyRootSearch, TargetsAreNothingOrTheStraightFilms) {
  const double s = std::sqrt(0.75);
  JunctionStar star;
  star.tension = 2 * 0.25;
  star.chord = {Vec2{0.3, 1.2}, Vec2{0.3 - s, -0.3}, Vec2{0.3 + s, -0.3}}; // equilateral, side √3
  EXPECT_EQ(kSearches[0].targets(star), (std::array{0.0, 0.0, 0.0}));
  for (const double energy : kSearches[1].targets(star)) {
    EXPECT_NEAR(energy, 2 * 0.25, 1e-14);
  }
  star.chord = {Vec2{}, Vec2{2, 0}, rotated({3, 0}, 2.2)}; // more than 120° in the first corner
  EXPECT_EQ(kSearches[1].targets(star), (std::array{0.0, 1.0, 1.5}));
}

/// ∂l/∂d = 1/cos α and ∂l/∂q = (d/cos α − l)/q of an arc with the chord d over pressure q.
TEST(EnergyRootSearch, JacobianIsTheDerivativeOfArcs) {
  Foam foam = honeycomb(6, 3);
  disturb(foam, 0.1, 2);
  set_half_angles(foam);
  for (const Junction j : foam.junction_slots()) {
    const JunctionStar star = junction_star(foam, j);
    const auto jacobian = junction_jacobian(kSearches[0], foam, star, 1e-4);
    const auto angles = junction_jacobian(AngleRootSearch{}, foam, star, 1e-4);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_EQ(jacobian[k], angles[k]); // areas are areas
      const Half h = star.half[k];
      const double q = star.pressure[k] - star.pressure[before(k)];
      const double d = norm(star.chord[k]);
      const double by_chord = 1 / std::cos(foam.half_angle(h));
      const double by_pressure = (d * by_chord - foam.length(h)) / q;
      const auto& row = jacobian[3 + k];
      EXPECT_NEAR(row[k], 2 * 0.25 * by_pressure, 1e-6);
      EXPECT_NEAR(row[before(k)], -2 * 0.25 * by_pressure, 1e-6);
      EXPECT_EQ(row[after(k)], 0);
      EXPECT_NEAR(row[3], -2 * 0.25 * by_chord * star.chord[k].x / d, 1e-6);
      EXPECT_NEAR(row[4], -2 * 0.25 * by_chord * star.chord[k].y / d, 1e-6);
    }
  }
}

TEST(EnergyRootSearch, LeavesOutTheOutside) { // (3.4.1)
  Foam foam = triple();
  foam.pressure = {0.05, 0.06, 0.07};
  for (const auto& search : kSearches) {
    for (const Junction j : {Junction(1), Junction(2), Junction(3)}) {
      const JunctionStar star = junction_star(foam, j);
      const auto outside =
          static_cast<std::size_t>(std::ranges::find(star.bubble, kWorld) - star.bubble.begin());
      const auto system = junction_system(search, foam, j, star, kFine);
      EXPECT_TRUE(system.ignored[outside]);
      EXPECT_EQ(system.jacobian[outside], (std::array<double, 5>{}));
      for (std::size_t r = 0; r < 6; ++r) {
        EXPECT_EQ(system.jacobian[r][outside], 0);
        EXPECT_TRUE(r == outside || system.jacobian[r] != (std::array<double, 5>{})) << r;
      }
      const JunctionStep step = search.solve(star, system);
      EXPECT_TRUE(step.finite());
      EXPECT_EQ(step.pressure[outside], 0);
      EXPECT_NE(norm(step.position), 0);
    }
  }
}

TEST(EnergyRootSearch, PinnedJunctionsAnswerForTheirAreasAlone) {
  BuildOptions build;
  build.boundary = Boundary::Fixed;
  Foam foam = build_from_points(jittered_grid(25, 1, 0.5, 1), build);
  for (double& area : foam.target_area) {
    area *= 1.1;
  }
  int pinned = 0;
  for (const Junction j : foam.junction_slots()) {
    if (!foam.has_junction(j) || foam.freedom(j).any()) {
      continue;
    }
    ++pinned;
    const JunctionStar star = junction_star(foam, j);
    const auto system = junction_system(kSearches[1], foam, j, star, kFine);
    const JunctionStep step = kSearches[1].solve(star, system);
    EXPECT_EQ(step.position, Vec2{});
    for (std::size_t k = 0; k < 3; ++k) {
      if (!star.bubble[k].is_outside()) {
        EXPECT_GT(step.pressure[k], 0);
        EXPECT_NEAR(step.pressure[k], 0.1 / 1.1 * star.target_area[k] / system.jacobian[k][k],
                    1e-9);
      }
    }
  }
  EXPECT_GT(pinned, 0);
}

// What its steps are.

/// With Zero, too, where the energies have to stay what they are; there it is the finite
/// differences that leave something, of second order.
TEST(EnergyRootSearch, RestsInASymmetricStar) {
  const Foam foam = honeycomb(6, 3);
  for (const auto& search : kSearches) {
    const double least = search.target == EnergyTarget::Zero ? kFine.step * kFine.step : 1e-11;
    const JunctionStep step = step_of(search, foam, Junction(5));
    EXPECT_LT(norm(step.position), least);
    for (const double dp : step.pressure) {
      EXPECT_NEAR(dp, 0, least);
    }
  }
}

/// Three straight films of lengths 1, 1.5 and 2 at 120°: in equilibrium. Straight leaves it there.
/// With Zero, linear least squares ask for (Σ uuᵀ)·Δx = Σ l·u with Σ uuᵀ = 3/2 for the films'
/// directions u, which is twice as far as the centroid of the neighbours.
TEST(EnergyRootSearch, ZeroPullsTowardsTheNeighboursCentroid) {
  const double s = std::sqrt(0.75);
  const Foam foam = foam_of_polygons({{0, 0}, {0, 1}, {-1.5 * s, -0.75}, {2 * s, -1}},
                                     {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}});
  const Vec2 centroid = (1.0 / 3) * (foam.position[Junction(1)] + foam.position[Junction(2)] +
                                     foam.position[Junction(3)]);
  const JunctionStep zero = step_of(kSearches[0], foam, Junction(0));
  EXPECT_NEAR(zero.position.x, 2 * centroid.x, 1e-7);
  EXPECT_NEAR(zero.position.y, 2 * centroid.y, 1e-7);
  EXPECT_LT(norm(step_of(kSearches[1], foam, Junction(0)).position), 1e-11);
}

TEST(EnergyRootSearch, UnitsDoNotMatter) {
  const auto scaled_step = [](const EnergyRootSearch& search, double length, double tension) {
    Foam foam = random_periodic_foam(3);
    disturb(foam, 0.05, 4);
    for (Vec2& x : foam.position) {
      x = length * x;
    }
    Lattice& torus = foam.surroundings.lattice;
    torus = {length * torus.origin, length * torus.first, length * torus.second};
    for (double& area : foam.target_area) {
      area *= length * length;
    }
    for (double& p : foam.pressure) {
      p *= tension / length;
    }
    foam.surface_tension *= tension;
    return step_of(search, foam, Junction(9));
  };
  for (const auto& search : kSearches) {
    const JunctionStep one = scaled_step(search, 1, 1);
    const JunctionStep other = scaled_step(search, 4.4, 3);
    EXPECT_NEAR(other.position.x / 4.4, one.position.x, 1e-5);
    EXPECT_NEAR(other.position.y / 4.4, one.position.y, 1e-5);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(other.pressure[k] * 4.4 / 3, one.pressure[k], 1e-5);
    }
  }
}

// What becomes of foams.

/// A honeycomb whose every twentieth junction was moved beyond one of its neighbours.
Foam honeycomb_with_inverted_junctions() {
  Foam foam = honeycomb(10, 5);
  for (Index i = 0; i < foam.junction_slots().size(); i += 20) {
    const Junction j(i);
    const auto k = place_of(i / 20 % 3);
    foam.position[j] += 1.4 * foam.chord(foam.junction_half[j][k]);
  }
  return foam;
}

TEST(EnergyRootSearch, ZeroUnravelsInvertedJunctions) {
  Foam foam = honeycomb_with_inverted_junctions();
  ASSERT_FALSE(all_oriented(foam));
  EquilibratorOptions options = options_with(RootSearch::Energies, EnergyTarget::Zero);
  options.maximum_iterations = 2000;
  options.junction.finite_difference_step = kFine.step;
  options.junction.position_tolerance = options.junction.pressure_tolerance = 1e-9;
  const EquilibriumReport report = JunctionEquilibrator(options).equilibrate(foam, 0, {});
  EXPECT_TRUE(all_oriented(foam));
  EXPECT_TRUE(report.converged);
  EXPECT_LT(report.residual, 1e-4); // in a honeycomb it comes to rest in equilibrium
  EXPECT_NEAR(foam.energy(), honeycomb(10, 5).energy(), 1e-6);
}

TEST(EnergyRootSearch, AnglesDoNotUnravelInvertedJunctions) {
  Foam foam = honeycomb_with_inverted_junctions();
  EXPECT_FALSE(JunctionEquilibrator(options_with(RootSearch::Angles, EnergyTarget::Zero))
                   .equilibrate(foam, 0, {})
                   .converged);
  EXPECT_FALSE(all_oriented(foam));
}

TEST(EnergyRootSearch, ZeroStopsNearEquilibriumWithAnglesThatAreOff) {
  for (std::uint64_t seed = 1; seed <= 4; ++seed) {
    Foam foam = random_periodic_foam(seed);
    Foam equilibrium = foam;
    ASSERT_TRUE(make_equilibrator({})->equilibrate(equilibrium, 0.05, {}).converged);
    const EquilibriumReport report =
        JunctionEquilibrator(options_with(RootSearch::Energies, EnergyTarget::Zero))
            .equilibrate(foam, 0, {});
    EXPECT_TRUE(report.converged);
    EXPECT_LT(report.iterations, 100);
    EXPECT_TRUE(all_oriented(foam));
    EXPECT_LT(report.max_area_error, 0.5);
    EXPECT_NEAR(foam.energy() / equilibrium.energy(), 1, 0.03);
    EXPECT_GT(mean_angle_error(foam), 8 * pi / 180);
    EXPECT_LT(mean_angle_error(foam), 25 * pi / 180);
  }
}

TEST(EnergyRootSearch, EquilibriumIsNotItsRoot) {
  Foam equilibrium = random_periodic_foam(1);
  ASSERT_TRUE(make_equilibrator({})->equilibrate(equilibrium, 0.05, {}).converged);
  for (const EnergyTarget target : {EnergyTarget::Zero, EnergyTarget::Straight}) {
    Foam foam = equilibrium;
    EquilibratorOptions options = options_with(RootSearch::Energies, target);
    options.maximum_iterations = 10;
    EXPECT_GT(JunctionEquilibrator(options).equilibrate(foam, 0, {}).max_angle_error, 0.5);
  }
}

TEST(EnergyRootSearch, StraightFallsApartAndIsFlagged) {
  for (const bool constrained : {false, true}) {
    for (const Sweep sweep : {Sweep::Jacobi, Sweep::GaussSeidel}) {
      Foam foam = build_from_points(jittered_grid(60, 1, 1, 1), {});
      EquilibratorOptions options = options_with(RootSearch::Energies, EnergyTarget::Straight);
      options.junction.sweep = sweep;
      options.junction.energy_decay = options.junction.orientation_invariant = constrained;
      const EquilibriumReport report = JunctionEquilibrator(options).equilibrate(foam, 0, {});
      EXPECT_FALSE(report.converged);
      EXPECT_FALSE(foam.report.converged);
      EXPECT_LE(report.iterations, options.maximum_iterations);
      EXPECT_GT(report.max_angle_error, 1);
      EXPECT_TRUE(validate(foam).empty());
    }
  }
}

} // namespace
} // namespace foam
