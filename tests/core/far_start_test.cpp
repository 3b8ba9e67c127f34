// SPDX-License-Identifier: GPL-3.0-or-later
//
// Foams that begin far from equilibrium: random points, as disordered as points can be.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <random>
#include <vector>

#include "construct/from_points.h"
#include "engines/engines.h"
#include "equilibrium/compressible_relaxation.h"
#include "equilibrium/equilibrator.h"
#include "foams.h"

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

TEST(FarStart, SoftGasLeavesAFoamNearEquilibrium) {
  Foam foam = poisson_foam(400, 1);
  const double angle_error = max_angle_error(foam);
  const double area_error = max_area_error(foam);
  relax_compressible(foam, 0.1, {});
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

} // namespace
} // namespace foam::test
