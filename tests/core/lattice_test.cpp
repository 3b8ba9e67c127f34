// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/lattice.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include "base/random.h"

namespace foam {
namespace {

double between(Random& random, double low, double high) {
  return low + (high - low) * random.uniform();
}

std::int32_t whole_between(Random& random, std::int32_t low, std::int32_t high) {
  return static_cast<std::int32_t>(std::floor(between(random, low, high + 1)));
}

Vec2 at_angle(double length, double angle) {
  return {length * std::cos(angle), length * std::sin(angle)};
}

/// Periods of any direction, between 30° and 150° apart.
Lattice skewed_lattice(Random& random) {
  const double direction = between(random, -std::numbers::pi, std::numbers::pi);
  const double apart = between(random, std::numbers::pi / 6, 5 * std::numbers::pi / 6);
  return {{between(random, -5, 5), between(random, -5, 5)},
          at_angle(between(random, 0.5, 3), direction),
          at_angle(between(random, 0.5, 3), direction + apart)};
}

/// Another basis of the same points, as far from being reduced as several shears make it.
Lattice another_basis(Lattice lattice, Random& random) {
  for (int shear = 0; shear < 4; ++shear) {
    lattice.first += whole_between(random, -3, 3) * lattice.second;
    lattice.second += whole_between(random, -3, 3) * lattice.first;
  }
  if (random.uniform() < 0.5) { // a quarter of a turn of the pair
    lattice = {lattice.origin, lattice.second, -lattice.first};
  }
  return lattice;
}

std::array<double, 2> lengths(const Lattice& lattice) {
  std::array<double, 2> both{norm(lattice.first), norm(lattice.second)};
  std::ranges::sort(both);
  return both;
}

/// The angle between the periods, in degrees.
double angle(const Lattice& lattice) {
  return angle_from_to(lattice.first, lattice.second) * 180 / std::numbers::pi;
}

/// Fails unless the reduction has the shortest periods, and its wraps stand for the same vectors.
/// \param shortest lengths of the lattice's shortest periods, ascending.
void expect_reduced(const Lattice& lattice, const std::array<double, 2>& shortest) {
  constexpr double kTie = 1e-8; // what a tie may leave
  const ReducedLattice result = reduced(lattice);
  EXPECT_EQ(result.lattice.origin, lattice.origin);
  EXPECT_EQ(result.xx * result.yy - result.xy * result.yx, 1);
  const double longest = lengths(lattice)[1];
  EXPECT_NEAR(result.lattice.area(), lattice.area(), 1e-14 * longest * longest);
  EXPECT_GE(angle(result.lattice), 60 - 60 * kTie);
  EXPECT_LE(angle(result.lattice), 120 + 60 * kTie);
  const std::array<double, 2> found = lengths(result.lattice);
  EXPECT_NEAR(found[0], shortest[0], kTie * shortest[0]);
  EXPECT_NEAR(found[1], shortest[1], kTie * shortest[1]);
  for (const Wrap w : {Wrap{1, 0}, Wrap{0, 1}, Wrap{-3, 2}, Wrap{5, 7}}) {
    const Vec2 difference = result.lattice.period(result.wrap(w)) - lattice.period(w);
    EXPECT_LT(norm(difference), 1e-13 * (std::abs(w.x) + std::abs(w.y)) * longest);
  }
  const ReducedLattice again = reduced(result.lattice);
  EXPECT_EQ(again.lattice, result.lattice);
  EXPECT_EQ(again.wrap({5, 7}), (Wrap{5, 7}));
}

TEST(Lattice, OfARectangleHasItsSides) {
  const Lattice lattice = Lattice::rectangle(-1, 3, 2, 4);
  EXPECT_TRUE(lattice.is_rectangle());
  EXPECT_EQ(lattice.area(), 8);
  EXPECT_EQ(lattice.period({2, -1}), (Vec2{8, -2}));
  EXPECT_EQ(lattice.coordinates({0, 3}), (Vec2{0.25, 0.5}));
  EXPECT_EQ(lattice.cell_of({0, 3}), (Wrap{0, 0}));
  EXPECT_EQ(lattice.cell_of({-1, 2}), (Wrap{0, 0})) << "its lower left corner is in the cell";
  EXPECT_EQ(lattice.cell_of({3, 4}), (Wrap{1, 1})) << "its upper right corner is not";
  EXPECT_EQ(lattice.cell_of({-1.5, 9}), (Wrap{-1, 3}));
}

TEST(Lattice, KnowsPlacesByTheirCoordinates) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Lattice lattice = skewed_lattice(random);
    EXPECT_FALSE(lattice.is_rectangle());
    EXPECT_GT(lattice.area(), 0);
    const Wrap wrap{whole_between(random, -9, 9), whole_between(random, -9, 9)};
    const Vec2 within{between(random, 0.01, 0.99), between(random, 0.01, 0.99)};
    const Vec2 place = lattice.origin + within.x * lattice.first + within.y * lattice.second +
                       lattice.period(wrap);
    const Vec2 coordinates = lattice.coordinates(place);
    EXPECT_NEAR(coordinates.x, wrap.x + within.x, 1e-12);
    EXPECT_NEAR(coordinates.y, wrap.y + within.y, 1e-12);
    EXPECT_EQ(lattice.cell_of(place), wrap);
    EXPECT_EQ(lattice.cell_of(place - lattice.period(wrap)), (Wrap{0, 0}));
  }
}

/// A rectangle's coordinates are found in another way, to the same effect.
TEST(Lattice, OfARectangleIsOneLikeOthers) {
  const Lattice rectangle = Lattice::rectangle(-1, 3, 2, 4);
  Lattice turned = rectangle;
  const double slight = 1e-14;
  turned.first.y = slight;
  EXPECT_FALSE(turned.is_rectangle());
  for (const Vec2 place : {Vec2{0, 3}, Vec2{7.7, -4}, Vec2{-20, 30}}) {
    EXPECT_LT(norm(turned.coordinates(place) - rectangle.coordinates(place)), 1e-12);
  }
}

TEST(ReducedLattice, IsTheSameFromAnyBasis) {
  Random random(2);
  for (int i = 0; i < 200; ++i) {
    const Lattice lattice = skewed_lattice(random);
    const std::array<double, 2> shortest = lengths(reduced(lattice).lattice);
    for (int basis = 0; basis < 20; ++basis) {
      expect_reduced(another_basis(lattice, random), shortest);
    }
  }
}

TEST(ReducedLattice, HasTheShortestVectors) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const Lattice lattice = reduced(skewed_lattice(random)).lattice;
    std::vector<double> all; // but for multiples of others
    for (std::int32_t x = -4; x <= 4; ++x) {
      for (std::int32_t y = 0; y <= 4; ++y) {
        if (std::gcd(x, y) == 1 && (y > 0 || x > 0)) {
          all.push_back(norm(lattice.period({x, y})));
        }
      }
    }
    std::ranges::sort(all);
    EXPECT_NEAR(lengths(lattice)[0], all[0], 1e-8);
    EXPECT_NEAR(lengths(lattice)[1], all[1], 1e-8);
  }
}

TEST(ReducedLattice, LeavesWhatIsReduced) {
  for (const double second : {60.0, 75.0, 90.0, 120.0}) {
    const Lattice lattice{{1, 2}, {2, 0}, at_angle(2, second * std::numbers::pi / 180)};
    const ReducedLattice result = reduced(lattice);
    EXPECT_EQ(result.lattice, lattice) << second;
    EXPECT_EQ(result.wrap({3, -2}), (Wrap{3, -2})) << second;
  }
  const Lattice long_first = Lattice::rectangle(0, 9, 0, 1);
  EXPECT_EQ(reduced(long_first).lattice, long_first);
}

/// Where several bases are the shortest, the reduction ends in one of them all the same.
TEST(ReducedLattice, EndsWhereThereAreTies) {
  Random random(4);
  for (int i = 0; i < 2000; ++i) {
    const double turn = i % 2 == 0 ? 0 : between(random, -std::numbers::pi, std::numbers::pi);
    const double spacing = i % 4 < 2 ? 1 : between(random, 1e-3, 1e3);
    const Vec2 first = at_angle(spacing, turn);
    const Lattice square{{}, first, left_normal(first)};
    expect_reduced(another_basis(square, random), {spacing, spacing});
    const Lattice hexagonal{{}, first, at_angle(spacing, turn + std::numbers::pi / 3)};
    expect_reduced(another_basis(hexagonal, random), {spacing, spacing});
    const Lattice centred{{}, first, 0.5 * first + 1.5 * left_normal(first)}; // of a rectangle
    expect_reduced(another_basis(centred, random), {spacing, std::sqrt(2.5) * spacing});
  }
}

} // namespace
} // namespace foam
