// SPDX-License-Identifier: GPL-3.0-or-later
#include "base/error.h"
#include "construct/jittered_grid.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>

namespace foam {
namespace {

TEST(JitteredGrid, WithoutJitterIsTheCentresOfAGridRowByRow) {
  const auto points = jittered_grid(6, 2, 0, 1);
  const std::vector<Vec2> expected{{1, 1}, {3, 1}, {5, 1}, {1, 3}, {3, 3}, {5, 3}};
  EXPECT_EQ(points, expected);
  EXPECT_EQ(grid_corner(6, 2), (Vec2{6, 4}));
}

TEST(JitteredGrid, StretchesCellsWhereNotAllRowsAreFull) {
  const auto points = jittered_grid(7, 3, 0, 1); // three rows of three, two and two
  const std::vector<Vec2> expected{{1.5, 1.5}, {4.5, 1.5}, {7.5, 1.5}, {2.25, 4},
                                   {6.75, 4},  {2.25, 6},  {6.75, 6}};
  ASSERT_EQ(points.size(), expected.size());
  for (std::size_t i = 0; i < points.size(); ++i) {
    EXPECT_NEAR(norm(points[i] - expected[i]), 0, 1e-14) << i;
  }
  EXPECT_NEAR(norm(grid_corner(7, 3) - Vec2{9, 7}), 0, 1e-14);
}

TEST(JitteredGrid, FillsARectangleWithASquareForEachPoint) {
  for (const Index count : {1, 2, 3, 5, 10, 17, 50, 99, 2000, 4567}) {
    const Vec2 corner = grid_corner(count, 0.5);
    EXPECT_NEAR(corner.x * corner.y, 0.25 * count, 1e-9);
    Vec2 mean;
    for (const Vec2 p : jittered_grid(count, 0.5, 0, 1)) {
      mean += (1.0 / count) * p;
    }
    EXPECT_NEAR(norm(mean - 0.5 * corner), 0, 1e-9) << count;
  }
}

TEST(JitteredGrid, EachPointStaysInItsCell) {
  for (const double jitter : {0.25, 1.0}) {
    const auto points = jittered_grid(2025, 0.5, jitter, 7);
    ASSERT_EQ(points.size(), 2025u);
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vec2 centre{0.5 * (static_cast<double>(i % 45) + 0.5),
                        0.5 * (static_cast<double>(i / 45) + 0.5)};
      EXPECT_LE(std::abs(points[i].x - centre.x), 0.25 * jitter);
      EXPECT_LE(std::abs(points[i].y - centre.y), 0.25 * jitter);
    }
  }
}

TEST(JitteredGrid, FillsItsCellsEvenly) {
  const auto points = jittered_grid(10000, 1, 1, 3);
  double sum = 0;
  double squares = 0;
  for (const Vec2 p : points) {
    for (const double u : {p.x - std::floor(p.x), p.y - std::floor(p.y)}) {
      sum += u;
      squares += u * u;
    }
  }
  // Five standard deviations of the mean of 20,000 uniform numbers, and of their squares.
  EXPECT_NEAR(sum / 20000, 1.0 / 2, 5 * std::sqrt(1.0 / 12 / 20000));
  EXPECT_NEAR(squares / 20000, 1.0 / 3, 5 * std::sqrt(4.0 / 45 / 20000));
}

TEST(JitteredGrid, DrawsFromSplitMix64) {
  // The generator's published sequence for the seed 1234567.
  const double x = static_cast<double>(6457827717110365317u >> 11) * 0x1p-53;
  const double y = static_cast<double>(3203168211198807973u >> 11) * 0x1p-53;
  const auto points = jittered_grid(1, 1, 1, 1234567);
  EXPECT_NEAR(points[0].x, x, 1e-15);
  EXPECT_NEAR(points[0].y, y, 1e-15);
}

TEST(JitteredGrid, IsAFunctionOfTheSeed) {
  EXPECT_EQ(jittered_grid(50, 1, 1, 5), jittered_grid(50, 1, 1, 5));
  EXPECT_NE(jittered_grid(50, 1, 1, 5), jittered_grid(50, 1, 1, 6));
}

TEST(JitteredGrid, RefusesBadInput) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_THROW(jittered_grid(0, 1, 1, 1), FoamError);
  EXPECT_THROW(jittered_grid(-3, 1, 1, 1), FoamError);
  EXPECT_THROW(jittered_grid(9, 0, 1, 1), FoamError);
  EXPECT_THROW(jittered_grid(9, nan, 1, 1), FoamError);
  EXPECT_THROW(jittered_grid(9, 1, -0.1, 1), FoamError);
  EXPECT_THROW(jittered_grid(9, 1, 1.1, 1), FoamError);
  EXPECT_THROW(jittered_grid(9, 1, nan, 1), FoamError);
}

} // namespace
} // namespace foam
