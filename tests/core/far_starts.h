// SPDX-License-Identifier: GPL-3.0-or-later
//
// Foams that begin far from equilibrium, a bubble of mean area 1 per point.
#pragma once

#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/random.h"
#include "foams.h"

namespace foam::test {

enum class Points {
  Poisson,   ///< uniformly random in a square: as uneven as points can be
  Jittered,  ///< the thesis's jittered grid
  Ring,      ///< on a circle, a spacing apart
  RingRound, ///< the same round one more
  Clusters   ///< in six heaps, Gaussian, whose middles are random
};

/// Of the normal distribution, by Box and Muller.
inline double normal(Random& random) {
  const double radius = std::sqrt(-2 * std::log(1 - random.uniform()));
  return radius * std::cos(2 * std::numbers::pi * random.uniform());
}

/// Areas of mean 1 with a lognormal distribution. \param variation their coefficient of variation
inline std::vector<double> lognormal_areas(std::size_t count, double variation, Random& random) {
  const double sigma = std::sqrt(std::log1p(variation * variation));
  std::vector<double> areas(count);
  double sum = 0;
  for (double& area : areas) {
    area = std::exp(sigma * normal(random));
    sum += area;
  }
  for (double& area : areas) {
    area *= static_cast<double>(count) / sum;
  }
  return areas;
}

/// Six heaps of a width of 1 in a square of 20.
inline std::vector<Vec2> clustered_points(Index count, Random& random) {
  constexpr Index kClusters = 6;
  std::array<Vec2, kClusters> middles;
  for (Vec2& middle : middles) {
    middle.x = 20 * random.uniform();
    middle.y = 20 * random.uniform();
  }
  std::vector<Vec2> points(place_of(count));
  for (Index i = 0; i < count; ++i) {
    Vec2& p = points[place_of(i)];
    p = middles[place_of(i % kClusters)];
    p.x += normal(random);
    p.y += normal(random);
  }
  return points;
}

inline std::vector<Vec2> far_points(Points kind, Index count, Random& random, std::uint64_t seed) {
  if (kind == Points::Jittered) {
    return jittered_grid(count, 1, 1, seed);
  }
  if (kind == Points::Clusters) {
    return clustered_points(count, random);
  }
  std::vector<Vec2> points(place_of(count));
  const Index around = kind == Points::RingRound ? count - 1 : count;
  const double side = std::sqrt(count);
  for (Index i = 0; i < count; ++i) {
    const double turn = 2 * std::numbers::pi * i / around;
    const double radius = i < around ? around / (2 * std::numbers::pi) : 0;
    points[place_of(i)] = kind == Points::Poisson
                              ? Vec2{side * random.uniform(), side * random.uniform()}
                              : radius * Vec2{std::cos(turn), std::sin(turn)};
  }
  return points;
}

struct FarStart {
  Points points = Points::Poisson;
  Boundary boundary = Boundary::Periodic;
  Index bubbles = 0;
  double variation = 0; ///< of the target areas; 0 for equal ones
  std::uint64_t seed = 0;

  Foam foam() const {
    Random random(seed);
    const std::vector<Vec2> places = far_points(points, bubbles, random, seed);
    BuildOptions options;
    options.boundary = boundary;
    const double side =
        points == Points::Jittered ? std::ceil(std::sqrt(bubbles)) : std::sqrt(bubbles);
    if (boundary == Boundary::Periodic && points != Points::Clusters) {
      options.torus = Lattice::rectangle(0, side, 0, side);
    }
    Foam made = build_from_points(places, options);
    const double mean = gas(made) / bubbles;
    const std::vector<double> areas = lognormal_areas(places.size(), variation, random);
    for (const Bubble b : made.bubble_slots()) {
      made.target_area[b] = variation > 0 ? mean * areas[b.place()] : mean;
    }
    return made;
  }

  std::string name() const {
    constexpr std::array kPoints{"Poisson", "jittered", "ring", "ring round one", "clustered"};
    constexpr std::array kBoundaries{"free", "periodic", "fixed"};
    return std::string(kPoints[static_cast<std::size_t>(points)]) + ", " +
           kBoundaries[static_cast<std::size_t>(boundary)] + ", " + std::to_string(bubbles) +
           " bubbles, variation " + std::to_string(variation) + ", seed " + std::to_string(seed) +
           ": ";
  }
};

/// Fails unless Newton's method finds an equilibrium from there. \returns the foam
inline Foam expect_equilibrium_from(const FarStart& start) {
  Foam foam = start.foam();
  const double before = gas(foam);
  const auto count = foam.bubble_count();
  equilibrate(foam);
  const std::string name = start.name();
  expect_valid(foam, name);
  expect_equilibrium(foam, name);
  EXPECT_EQ(foam.bubble_count(), count) << name;
  EXPECT_EQ(gas(foam), before) << name;
  if (foam.surroundings.rotates()) { // Σ(p − p₀)A = E/2, of a free cluster
    EXPECT_NEAR(sum(foam, [&](Bubble b) { return foam.pressure[b] * foam.area(b); }),
                0.5 * foam.energy(), 1e-7 * foam.energy())
        << name;
  }
  return foam;
}

} // namespace foam::test
