// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "drawing/film_ends.h"

namespace foam {
namespace {

/// A double bubble of unit radius: two arcs of half-angle 120° and a straight film between them.
std::vector<DrawnFilm> double_bubble() {
  const double half = std::sqrt(3.0) / 2;
  const double bulge = std::tan(std::numbers::pi / 3);
  return {{{0, -half}, {0, half}, bulge, 0, 1},
          {{0, -half}, {0, half}, -bulge, 0, 1},
          {{0, half}, {0, -half}, 0, 1, 0}};
}

TEST(FilmEnds, of_a_double_bubble) {
  const auto ends = film_ends(double_bubble(), 0);
  ASSERT_EQ(ends.size(), 6u);
  // From the lower junction: film 0 goes out to the right, then counter-clockwise 2 and 1.
  EXPECT_EQ(ends[0].left.end, 5);
  EXPECT_EQ(ends[5].left.end, 2);
  EXPECT_EQ(ends[2].left.end, 0);
  EXPECT_EQ(ends[0].right.end, 2);
  // From the upper one clockwise.
  EXPECT_EQ(ends[1].right.end, 4);
  EXPECT_EQ(ends[4].right.end, 3);
  EXPECT_EQ(ends[3].right.end, 1);
  for (const auto& end : ends) {
    EXPECT_EQ(end.left.side.radius, 0);
    EXPECT_EQ(border_margin(end), 0);
  }
}

TEST(FilmEnds, share_the_sides_of_borders) {
  const auto ends = film_ends(double_bubble(), 0.1);
  for (std::size_t end = 0; end < ends.size(); ++end) {
    const auto& left = ends[end].left;
    ASSERT_GE(left.end, 0);
    EXPECT_GT(left.side.radius, 0.05);
    EXPECT_EQ(ends[static_cast<std::size_t>(left.end)].right.end, static_cast<std::int64_t>(end));
    EXPECT_EQ(ends[static_cast<std::size_t>(left.end)].right.side.radius, left.side.radius);
    EXPECT_NEAR(border_margin(ends[end]), 0.0155, 0.002); // (2/√3 − 1)·0.1, were all straight
  }
}

TEST(FilmEnds, borders_shrink_with_the_shortest_film) {
  auto films = double_bubble();
  films.push_back({{0, -0.8}, {0.02, -0.8}, 0, 7, 8});
  films.push_back({{0, -0.8}, {-1, 0}, 0, 7, 9});
  const auto ends = film_ends(films, 0.1);
  EXPECT_LT(ends[6].right.side.radius, 0.1);
  EXPECT_GT(ends[6].left.side.radius + ends[6].right.side.radius, 0);
}

TEST(FilmEnds, of_a_film_alone) {
  const auto ends = film_ends({{{0, 0}, {1, 0}, 0, 0, 1}}, 0.1);
  for (const auto& end : ends) {
    EXPECT_EQ(end.left.end, -1);
    EXPECT_EQ(end.right.end, -1);
  }
}

} // namespace
} // namespace foam
