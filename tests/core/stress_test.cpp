// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stress of a foam, its texture and its shear modulus.
#include "statistics/stress.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <numbers>

#include "base/error.h"
#include "construct/honeycomb.h"
#include "deformation/moduli.h"
#include "foams.h"
#include "reference.h"

namespace foam::test {
namespace {

constexpr auto kSimple = DeformationKind::SimpleShear;
constexpr auto kPure = DeformationKind::PureShear;
/// Of hexagons, in T/√A.
constexpr double kHexagonalModulus = 0.465302429551;

Tensor rotation(double angle) {
  return {std::cos(angle), -std::sin(angle), std::sin(angle), std::cos(angle)};
}

Foam hexagons(double turned = 0) {
  Foam foam = honeycomb({.columns = 6, .rows = 4, .surface_tension = 0.5});
  strain(foam, rotation(turned));
  equilibrate(foam, 1e-13);
  return foam;
}

Foam evolver_in_equilibrium() {
  Foam foam = foam_of(evolver_foam());
  equilibrate(foam, 1e-13);
  return foam;
}

/// Strained and in equilibrium, of the same topology.
Foam strained(Foam foam, DeformationKind kind, double by) {
  strain(foam, exponential(by, velocity_gradient(kind)));
  EquilibratorOptions options;
  options.tolerance = 1e-13;
  EXPECT_TRUE(make_equilibrator(options)->equilibrate(foam, 0, {}).converged);
  return foam;
}

TEST(ArcTangents, AreTheIntegral) {
  for (const double alpha : {-2.5, -1.0, -1e-3, 0.0, 0.4, 1.6, 3.0}) {
    const Vec2 chord{0.7, -1.1};
    constexpr int kParts = 20000;
    SymmetricTensor sum;
    for (int i = 0; i < kParts; ++i) {
      const Vec2 from = arc_point({}, chord, alpha, static_cast<double>(i) / kParts);
      const Vec2 to = arc_point({}, chord, alpha, (i + 1.0) / kParts);
      sum += (1 / norm(to - from)) * square(to - from);
    }
    const SymmetricTensor exact = arc_tangents(chord, alpha);
    EXPECT_NEAR(exact.xx, sum.xx, 1e-6);
    EXPECT_NEAR(exact.yy, sum.yy, 1e-6);
    EXPECT_NEAR(exact.xy, sum.xy, 1e-6);
    EXPECT_NEAR(exact.xx + exact.yy, arc_length(norm(chord), alpha), 1e-12);
  }
}

TEST(ArcTangents, ChangeByTheirDerivative) {
  for (const double alpha : {-2.5, -1.0, 0.0, 0.3, 1.6}) {
    const Vec2 chord{0.7, -1.1};
    const Vec2 change{0.3, 0.2};
    const double turn = 0.6;
    const double dt = 1e-5;
    const SymmetricTensor found =
        (0.5 / dt) * (arc_tangents(chord + dt * change, alpha + dt * turn) -
                      arc_tangents(chord + -dt * change, alpha - dt * turn));
    const SymmetricTensor exact = arc_tangents_change(chord, change, alpha, turn);
    EXPECT_NEAR(exact.xx, found.xx, 1e-8);
    EXPECT_NEAR(exact.yy, found.yy, 1e-8);
    EXPECT_NEAR(exact.xy, found.xy, 1e-8);
  }
}

TEST(Stress, VanishesInFreeClusters) {
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    Foam foam = random_foam(30, Boundary::Free, seed);
    equilibrate(foam, 1e-13);
    const SymmetricTensor sigma = stress(foam);
    EXPECT_NEAR(sigma.xx, 0, 1e-12);
    EXPECT_NEAR(sigma.yy, 0, 1e-12);
    EXPECT_NEAR(sigma.xy, 0, 1e-12);
  }
}

TEST(Stress, IsThatOfFilmsAndGas) {
  Foam foam = random_foam(50, Boundary::Periodic);
  pull_unevenly(foam, 0.1, 1);
  equilibrate(foam, 1e-13);
  const SymmetricTensor sigma = stress(foam);
  const double gas = sum(foam, [&](Bubble b) { return foam.pressure[b] * foam.area(b); });
  const double area = foam.surroundings.lattice.area();
  EXPECT_NEAR(area * (sigma.xx + sigma.yy), foam.energy() - 2 * gas, 1e-10);
}

/// dE/dγ = A·σ:L, with other films' tensions than 2γ as well.
TEST(Stress, IsTheDerivativeOfEnergy) {
  for (const double unevenness : {0.0, 0.1}) {
    Foam foam = random_foam(40, Boundary::Periodic, 2);
    if (unevenness > 0) {
      pull_unevenly(foam, unevenness, 1);
    }
    equilibrate(foam, 1e-13);
    const SymmetricTensor sigma = stress(foam);
    const double area = foam.surroundings.lattice.area();
    const double step = 1e-4;
    for (const auto& [kind, expected] :
         {std::pair(kSimple, sigma.xy), std::pair(kPure, sigma.xx - sigma.yy)}) {
      const double slope =
          (strained(foam, kind, step).energy() - strained(foam, kind, -step).energy()) / (2 * step);
      EXPECT_NEAR(slope / area, expected, 1e-8);
    }
  }
}

TEST(Stress, OfTheEvolversFoam) {
  const Foam foam = evolver_in_equilibrium();
  const SymmetricTensor sigma = stress(foam);
  EXPECT_NEAR(sigma.xy, -0.004542219903, 2e-12);
  EXPECT_NEAR(normal_stress_difference(sigma), -0.014711561218, 2e-12);
}

/// The foam that is turned has the stress turned.
TEST(Stress, IsATensor) {
  const Foam foam = evolver_in_equilibrium();
  Foam turned = foam;
  const double angle = 0.3;
  strain(turned, rotation(angle));
  const SymmetricTensor a = stress(foam);
  const SymmetricTensor b = stress(turned);
  EXPECT_NEAR(b.xx + b.yy, a.xx + a.yy, 1e-13);
  const double c = std::cos(2 * angle);
  const double s = std::sin(2 * angle);
  EXPECT_NEAR(b.xx - b.yy, c * (a.xx - a.yy) - 2 * s * a.xy, 1e-13);
  EXPECT_NEAR(2 * b.xy, s * (a.xx - a.yy) + 2 * c * a.xy, 1e-13);
}

TEST(ShearModulus, OfHexagonsInAnyOrientation) {
  for (const double turned : {0.0, 0.2, std::numbers::pi / 6, 1.1}) {
    const Foam foam = hexagons(turned);
    EXPECT_NEAR(shear_modulus(foam, kSimple), kHexagonalModulus, 1e-11);
    EXPECT_NEAR(shear_modulus(foam, kPure), kHexagonalModulus, 1e-11);
  }
}

/// τ(γ), N₁ = γ·τ, lengths of films: closed forms (H. M. Princen, J. Colloid Interface Sci. 91
/// (1983) 160).
TEST(Shear, OfHexagons) {
  const double d = std::sqrt(2 / std::sqrt(3.0));
  for (const auto& row : read_csv("hex_foam_shear.csv")) {
    const double gamma = number(row, "gamma");
    for (const double turned : {0.0, 0.2}) {
      if (gamma > (turned == 0 ? 1.15 : 0.75)) {
        continue;
      }
      Foam foam = hexagons(turned);
      while (gamma > 0 && std::abs(foam.time - gamma) > 1e-12) { // which is not its business
        const double step = std::min(0.05, gamma - foam.time);
        const double at = foam.time + step;
        foam = strained(std::move(foam), kSimple, step);
        foam.time = at;
      }
      const SymmetricTensor sigma = stress(foam);
      EXPECT_NEAR(sigma.xy, number(row, "shear_stress_sqrtA_over_T"), 1e-11) << gamma;
      EXPECT_NEAR(sigma.xy, kHexagonalModulus * gamma / std::sqrt(1 + gamma * gamma / 4), 1e-11);
      EXPECT_NEAR(normal_stress_difference(sigma), gamma * sigma.xy, 1e-11);
      EXPECT_NEAR(foam.energy() / foam.bubble_count(),
                  number(row, "film_length_per_cell_over_sqrtA"), 1e-11);
      if (turned == 0) {
        const double shortest =
            (1 - std::sqrt(0.75) * gamma) * d / std::sqrt(3 + 0.75 * gamma * gamma);
        double found = 10;
        for (const Film f : foam.film_slots()) {
          found = std::min(found, foam.length(f.half()));
        }
        EXPECT_NEAR(found, shortest, 1e-11);
      }
    }
  }
}

TEST(ShearModulus, OfTheEvolversFoam) {
  EXPECT_NEAR(shear_modulus(evolver_in_equilibrium(), kSimple), 0.447203841782, 1e-11);
}

/// Central differences of stresses, isotropic part and all, at a strain and at rest.
TEST(ShearModulus, IsTheDerivativeOfStress) {
  for (const double unevenness : {0.0, 0.1}) {
    Foam foam = random_foam(40, Boundary::Periodic, 3);
    if (unevenness > 0) {
      pull_unevenly(foam, unevenness, 1);
    }
    equilibrate(foam, 1e-13);
    const double step = 1e-4;
    for (const auto kind : {kSimple, kPure}) {
      const SymmetricTensor found =
          (0.5 / step) * (stress(strained(foam, kind, step)) - stress(strained(foam, kind, -step)));
      const SymmetricTensor change = stress_change(foam, velocity_gradient(kind));
      EXPECT_NEAR(change.xx, found.xx, 1e-6);
      EXPECT_NEAR(change.yy, found.yy, 1e-6);
      EXPECT_NEAR(change.xy, found.xy, 1e-6);
    }
  }
}

TEST(ShearModulus, NeedsATorus) {
  EXPECT_THROW(shear_modulus(random_foam(20, Boundary::Free), kSimple), FoamError);
}

/// M = ½d²·I with the distance d of neighbours, and F·M·Fᵀ when strained.
TEST(Texture, OfHexagonsFollowsTheStrain) {
  Foam foam = hexagons();
  const double half = 1 / std::sqrt(3.0); // ½d², d² = 2/√3
  const SymmetricTensor rest = texture(foam);
  EXPECT_NEAR(rest.xx, half, 1e-12);
  EXPECT_NEAR(rest.yy, half, 1e-12);
  EXPECT_NEAR(rest.xy, 0, 1e-12);
  const double gamma = 0.2;
  const SymmetricTensor sheared = texture(strained(foam, kSimple, gamma));
  EXPECT_NEAR(sheared.xx, half * (1 + gamma * gamma), 1e-11);
  EXPECT_NEAR(sheared.yy, half, 1e-11);
  EXPECT_NEAR(sheared.xy, half * gamma, 1e-11);
}

TEST(Compact, TorusIsTheSameFoam) {
  Foam foam = evolver_in_equilibrium();
  strain(foam, exponential(2.3, velocity_gradient(kSimple)));
  Foam compact = foam;
  make_compact(compact);
  EXPECT_NE(compact.surroundings.lattice, foam.surroundings.lattice);
  EXPECT_NEAR(compact.surroundings.lattice.second.x, 3, 1e-12);
  expect_valid(compact);
  for (const Half h : foam.half_slots()) {
    EXPECT_NEAR(norm(compact.chord(h) - foam.chord(h)), 0, 1e-12);
  }
}

} // namespace
} // namespace foam::test
