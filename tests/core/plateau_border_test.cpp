// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "geometry/plateau_border.h"

namespace foam {
namespace {

constexpr double kDegree = std::numbers::pi / 180;

FilmAtJunction film(double degrees, double curvature) {
  return {{std::cos(degrees * kDegree), std::sin(degrees * kDegree)}, curvature};
}

/// How far a border's side is from touching a film's circle or line (cm).
double gap(const BorderSide& side, const FilmAtJunction& film) {
  if (film.curvature == 0) {
    return std::abs(cross(film.tangent, side.centre)) - side.radius;
  }
  const Vec2 centre = (1 / film.curvature) * left_normal(film.tangent);
  const double distance = norm(side.centre - centre);
  const double film_radius = std::abs(1 / film.curvature);
  return std::min(std::abs(distance - (film_radius + side.radius)),
                  std::abs(distance - std::abs(film_radius - side.radius)));
}

TEST(PlateauBorder, between_straight_films_is_the_circle_in_their_corner) {
  const auto side = border_side(film(0, 0), film(120, 0), 0.3, 10);
  ASSERT_TRUE(side);
  EXPECT_NEAR(side->radius, 0.3, 1e-15);
  EXPECT_NEAR(norm(side->centre), 0.3 / std::sin(60 * kDegree), 1e-15);
  EXPECT_NEAR(std::atan2(side->centre.y, side->centre.x), 60 * kDegree, 1e-14);
}

TEST(PlateauBorder, touches_both_films_however_they_are_bent) {
  for (const double angle : {40.0, 90.0, 120.0, 150.0}) {
    for (const double first : {-0.9, -0.2, 0.0, 0.7}) {
      for (const double second : {-0.6, 0.0, 0.4, 1.1}) {
        const FilmAtJunction a = film(17, first), b = film(17 + angle, second);
        const auto side = border_side(a, b, 0.1, 10);
        ASSERT_TRUE(side);
        EXPECT_NEAR(gap(*side, a), 0, 1e-14) << angle << ' ' << first << ' ' << second;
        EXPECT_NEAR(gap(*side, b), 0, 1e-14) << angle << ' ' << first << ' ' << second;
      }
    }
  }
}

// Around a border the liquid has one pressure. By Laplace–Young a side has the curvature
// (p_gas − p_liquid)/γ and a film (p_left − p_right)/2γ, so that the sides left and right of a film
// differ by twice the film's curvature.
TEST(PlateauBorder, holds_liquid_of_one_pressure) {
  const FilmAtJunction films[] = {film(10, 0.8), film(130, -0.3), film(250, -0.5)};
  double curvature[3];
  for (int k = 0; k < 3; ++k) {
    const auto side = border_side(films[k], films[(k + 1) % 3], 0.15, 10);
    ASSERT_TRUE(side);
    curvature[k] = 1 / side->radius;
  }
  for (int k = 0; k < 3; ++k) {
    const double left = curvature[k], right = curvature[(k + 2) % 3];
    EXPECT_NEAR(left - right, 2 * films[k].curvature, 1e-12) << k;
  }
}

TEST(PlateauBorder, has_no_side_where_a_film_goes_straight_on_or_comes_from_behind) {
  EXPECT_FALSE(border_side(film(0, 0), film(180, 0), 0.1, 1));
  EXPECT_FALSE(border_side(film(0, 0), film(200, 0), 0.1, 1));
  EXPECT_FALSE(border_side(film(0, 0), film(0, 0), 0.1, 1));
  EXPECT_FALSE(border_side(film(0, 0), film(120, 0), 0, 1));
}

TEST(PlateauBorder, keeps_within_reach) {
  const auto side = border_side(film(0, 0), film(120, 0), 1, 0.1);
  ASSERT_TRUE(side);
  EXPECT_NEAR(side->radius / std::tan(60 * kDegree), 0.1, 1e-15);
}

} // namespace
} // namespace foam
