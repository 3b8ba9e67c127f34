// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/arcs.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "hand_made.h"

namespace foam {
namespace {

/// Two half discs of radius 1 with a straight film between them.
Foam halved_disc() {
  FilmSet set;
  set.surface_tension = 0.25;
  set.junctions = {{0, -1}, {0, 1}};
  const double right_angle = std::numbers::pi / 2;
  set.films = {{0, 1, 0, 1, 0, {}}, {1, 0, 0, -1, right_angle, {}}, {0, 1, 1, -1, right_angle, {}}};
  set.bubbles = {{0, 0, 1}, {1, 0, 1}};
  return foam_of(set);
}

double polygon_area(const std::vector<Vec2>& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    twice += cross(outline[i], outline[(i + 1) % outline.size()]);
  }
  return 0.5 * twice;
}

TEST(Sampling, ArcKeepsWithinTheChordError) {
  const Foam foam = halved_disc();
  for (const double error : {0.1, 1e-2, 1e-4}) {
    for (const Index half : {2, 3}) { // the arc through (−1, 0), both ways
      const Vec2 start = foam.position[Foam::size(foam.start(half))];
      std::vector<Vec2> points{{7, 7}};
      sample_arc(foam, half, start, error, points);
      EXPECT_EQ(points[0], (Vec2{7, 7})) << "points are appended";
      EXPECT_EQ(points[1], start);
      EXPECT_EQ(points.back(), start + foam.chord(half));
      for (std::size_t i = 1; i + 1 < points.size(); ++i) {
        EXPECT_NEAR(norm(points[i]), 1, 1e-15);
        EXPECT_LE(points[i].x, 1e-15);
        EXPECT_LE(1 - norm(0.5 * (points[i] + points[i + 1])), error * (1 + 1e-9));
      }
    }
  }
}

TEST(Sampling, StraightFilmIsItsEnds) {
  std::vector<Vec2> points;
  sample_arc(halved_disc(), 0, {0, -1}, 1e-6, points);
  EXPECT_EQ(points, (std::vector<Vec2>{{0, -1}, {0, 1}}));
}

TEST(Sampling, ArcStartsWhereItIsAskedTo) {
  std::vector<Vec2> points;
  sample_arc(halved_disc(), 0, {10, 4}, 1e-6, points);
  EXPECT_EQ(points, (std::vector<Vec2>{{10, 4}, {10, 6}}));
}

TEST(Sampling, OutlineIsCounterClockwiseWithTheAreaOfTheBubble) {
  const Foam foam = halved_disc();
  for (const Index b : {0, 1}) {
    const auto outline = sample_bubble(foam, b, 1e-5);
    EXPECT_NEAR(polygon_area(outline), std::numbers::pi / 2, 1e-4);
    for (std::size_t i = 0; i < outline.size(); ++i) {
      EXPECT_GT(norm(outline[(i + 1) % outline.size()] - outline[i]), 1e-3) << "no point twice";
    }
  }
}

TEST(Sampling, OutlineOnATorusIsInOnePiece) {
  const Foam foam = honeycomb(4, 2);
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    const auto outline = sample_bubble(foam, b, 0.01);
    EXPECT_EQ(outline.size(), 6u);
    EXPECT_NEAR(polygon_area(outline), std::sqrt(0.75), 1e-13);
    for (std::size_t i = 0; i < outline.size(); ++i) {
      EXPECT_NEAR(norm(outline[(i + 1) % 6] - outline[i]), 1 / std::sqrt(3.0), 1e-13);
    }
  }
}

} // namespace
} // namespace foam
