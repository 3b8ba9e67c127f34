// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <string>

#include "base/random.h"
#include "construct/from_points.h"
#include "construct/jittered_grid.h"
#include "engines/engines.h"
#include "equilibrium/equilibrator.h"
#include "mesh/film_set.h"
#include "mesh/validate.h"
#include "physics/equilibrium_measures.h"

namespace foam::test {

/// Fails if the mesh or its geometry is not valid.
inline void expect_valid(const Foam& foam, const std::string& where = {}) {
  for (const auto& problem : validate(foam)) {
    ADD_FAILURE() << where << problem;
  }
  for (const auto& problem : validate_geometry(foam)) {
    ADD_FAILURE() << where << problem;
  }
}

/// Fails unless the foam is the equilibrium that every frame has to be.
inline void expect_equilibrium(const Foam& foam, const std::string& where = {}) {
  EXPECT_TRUE(foam.report.converged) << where << "residual " << foam.report.residual;
  EXPECT_LT(max_angle_error(foam), 1e-8) << where;
  EXPECT_LT(max_area_error(foam), 1e-9) << where;
}

/// The thesis's time step and thresholds (Figure 4.19): for bubbles of about 1 cm².
inline CoarseningOptions thesis_options() {
  CoarseningOptions options;
  options.time_step = 1.0 / 30;
  options.thresholds.kind = ThresholdKind::Absolute;
  return options;
}

inline void equilibrate(Foam& foam, double tolerance = 1e-9) {
  EquilibratorOptions options;
  options.tolerance = tolerance;
  make_equilibrator(options)->equilibrate(foam, 0.05 * foam.mean_spacing(), {});
}

/// A mesh of the thesis's jittered grid, not in equilibrium.
inline Foam jittered_foam(Boundary boundary, Index bubbles, std::uint64_t seed) {
  BuildOptions options;
  options.boundary = boundary;
  return build_from_points(jittered_grid(bubbles, 1, 1, seed), options);
}

/// A disordered foam in equilibrium, from the thesis's jittered grid.
inline Foam random_foam(Index bubbles, Boundary boundary, std::uint64_t seed = 1) {
  BuildOptions options;
  options.boundary = boundary;
  if (boundary == Boundary::Periodic) {
    const Vec2 corner = grid_corner(bubbles, 1);
    options.torus = Lattice::rectangle(0, corner.x, 0, corner.y);
  }
  Foam foam = build_from_points(jittered_grid(bubbles, 1, 1, seed), options);
  equilibrate(foam);
  return foam;
}

/// Tensions at random, 2γ give or take a part of it.
inline void pull_unevenly(Foam& foam, double part, std::uint64_t seed) {
  Random random(seed);
  foam.film_tension.clear();
  for (std::size_t f = 0; f < foam.film_angle.size(); ++f) {
    foam.film_tension.push_back(foam.reference_tension() * (1 + part * (2 * random.uniform() - 1)));
  }
}

/// Over the bubbles that there are.
template <class Of> double sum(const Foam& foam, const Of& of) {
  double total = 0;
  for (const Bubble b : foam.bubble_slots()) {
    total += foam.has_bubble(b) ? of(b) : 0;
  }
  return total;
}

inline double gas(const Foam& foam) {
  return sum(foam, [&](Bubble b) { return foam.target_area[b]; });
}

/// Every other bubble gets a tenth of what the smaller of it and the next one has.
inline void exchange_gas(Foam& foam) {
  for (Index i = 0; i + 1 < foam.bubble_slots().size(); i += 2) {
    double& first = foam.target_area[Bubble(i)];
    double& second = foam.target_area[Bubble(i + 1)];
    const double gas = 0.1 * std::min(first, second);
    first += gas;
    second -= gas;
  }
}

/// Unit bubbles of line tension 1 around the given points, free, in equilibrium.
inline Foam unit_cluster(const std::vector<Vec2>& points) {
  BuildOptions options;
  options.surface_tension = 0.5;
  options.target_areas = TargetAreas::Array;
  options.target_area_array.assign(points.size(), 1.0);
  Foam foam = build_from_points(points, options);
  equilibrate(foam, 1e-13);
  return foam;
}

/// A double bubble of line tension 1, not in equilibrium: a disc cut by a straight film.
inline Foam double_bubble(double area_left, double area_right) {
  FilmSet set;
  set.surface_tension = 0.5;
  set.junctions = {{0, -0.5}, {0, 0.5}};
  set.films = {{0, 1, 0, 1, 0.0, {}}, {1, 0, 0, -1, 1.3, {}}, {0, 1, 1, -1, 1.3, {}}};
  set.bubbles = {{0, 0.0, area_left}, {1, 0.0, area_right}};
  return foam_of(set);
}

} // namespace foam::test
