// SPDX-License-Identifier: GPL-3.0-or-later
#include "construct/honeycomb.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "base/error.h"
#include "foams.h"

namespace foam {
namespace {

TEST(Honeycomb, IsInEquilibrium) {
  const Foam foam = honeycomb({.columns = 6, .rows = 4});
  test::expect_valid(foam);
  EXPECT_EQ(foam.bubble_count(), 24);
  EXPECT_LT(max_angle_error(foam), 1e-12);
  for (const Bubble b : foam.bubble_slots()) {
    EXPECT_EQ(foam.sides[b], 6);
    EXPECT_NEAR(foam.area(b), 1, 1e-12);
  }
}

TEST(Honeycomb, IsDisorderedOnDemand) {
  const Foam foam = honeycomb({.columns = 30, .rows = 30, .displacement = 0.1, .swaps = 0.3});
  test::expect_valid(foam);
  double total = 0;
  for (const double area : foam.target_area) {
    total += area;
  }
  EXPECT_NEAR(total, foam.surroundings.lattice.area(), 1e-9);
  EXPECT_EQ(std::ranges::min(foam.sides), 5);
  EXPECT_EQ(std::ranges::max(foam.sides), 7);
  EXPECT_GT(std::ranges::count(foam.sides, 5), 100);
}

TEST(Honeycomb, DependsOnItsSeedAlone) {
  const HoneycombOptions options{.columns = 8, .rows = 8, .displacement = 0.1, .swaps = 0.3};
  EXPECT_EQ(honeycomb(options).position, honeycomb(options).position);
  HoneycombOptions other = options;
  other.seed = 2;
  EXPECT_NE(honeycomb(options).position, honeycomb(other).position);
}

TEST(Honeycomb, RejectsOptionsOutOfRange) {
  EXPECT_THROW(honeycomb({.columns = 3, .rows = 4}), FoamError);
  EXPECT_THROW(honeycomb({.columns = 4, .rows = 5}), FoamError);
  EXPECT_THROW(honeycomb({.columns = 4, .rows = 4, .displacement = 0.2}), FoamError);
  EXPECT_THROW(honeycomb({.columns = 4, .rows = 4, .swaps = -1}), FoamError);
  EXPECT_THROW(honeycomb({.columns = 4, .rows = 4, .surface_tension = 0}), FoamError);
}

} // namespace
} // namespace foam
