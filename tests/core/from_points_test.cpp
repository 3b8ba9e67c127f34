// SPDX-License-Identifier: GPL-3.0-or-later
#include "construct/from_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <string>

#include "base/error.h"
#include "construct/jittered_grid.h"
#include "hand_made.h"
#include "mesh/validate.h"

namespace foam {
namespace {

constexpr double kNan = std::numeric_limits<double>::quiet_NaN();
constexpr double kInfinity = std::numeric_limits<double>::infinity();

BuildOptions with(Boundary boundary) {
  BuildOptions options;
  options.boundary = boundary;
  return options;
}

double total(const std::vector<double>& values) {
  return std::accumulate(values.begin(), values.end(), 0.0);
}

/// What holds for every foam of n points.
void expect_foam_of(const Foam& foam, Index n, Boundary boundary) {
  expect_valid(foam);
  const bool torus = boundary == Boundary::Periodic;
  EXPECT_EQ(foam.boundary, boundary);
  EXPECT_EQ(foam.bubble_count(), n);
  EXPECT_EQ(foam.junction_count(), torus ? 2 * n : 2 * (n - 1));
  EXPECT_EQ(foam.film_count(), torus ? 3 * n : 3 * (n - 1));
  for (Index b = 0; b < n; ++b) {
    EXPECT_EQ(foam.bubble_id[Foam::size(b)], b);
    EXPECT_GT(foam.area(b), 0) << "bubble " << b << " of " << n;
    EXPECT_DOUBLE_EQ(foam.target_area[Foam::size(b)], foam.area(b));
  }
  EXPECT_TRUE(std::ranges::all_of(foam.pressure, [](double p) { return p == 0; }));
  EXPECT_TRUE(std::ranges::all_of(foam.film_angle, [](double a) { return a == 0; }));
  if (torus) {
    const double box = foam.box.width() * foam.box.height();
    EXPECT_NEAR(total(foam.target_area), box, 1e-12 * box);
  }
}

/// The arrays that make a foam.
bool same(const Foam& a, const Foam& b) {
  return a.position == b.position && a.junction_half == b.junction_half &&
         a.half_junction == b.half_junction && a.half_bubble == b.half_bubble &&
         a.bubble_half == b.bubble_half && a.sides == b.sides && a.film_wrap == b.film_wrap &&
         a.target_area == b.target_area && a.box == b.box;
}

std::string error_of(std::span<const Vec2> points, const BuildOptions& options) {
  try {
    build_from_points(points, options);
  } catch (const FoamError& error) {
    return error.what();
  }
  return "no error";
}

class AnyBoundary : public testing::TestWithParam<Boundary> {};
INSTANTIATE_TEST_SUITE_P(Boundaries, AnyBoundary,
                         testing::Values(Boundary::Free, Boundary::Periodic, Boundary::Fixed));

TEST_P(AnyBoundary, TakesJitteredGridsOfEverySize) {
  for (const Index n : {3, 4, 5, 10, 30, 100, 1000}) {
    for (std::uint64_t seed = 1; seed <= 10; ++seed) {
      for (const double jitter : {0.3, 1.0}) {
        SCOPED_TRACE(testing::Message() << n << " points, seed " << seed << ", jitter " << jitter);
        const auto points = jittered_grid(n, 1, jitter, seed);
        const Foam foam = build_from_points(points, with(GetParam()));
        expect_foam_of(foam, n, GetParam());
        EXPECT_TRUE(validate_geometry(foam).empty());
      }
    }
  }
}

TEST_P(AnyBoundary, TakesAHundredThousandPoints) {
  const auto points = jittered_grid(100000, 1, 1, 1);
  const Foam foam = build_from_points(points, with(GetParam()));
  EXPECT_TRUE(validate(foam).empty());
  EXPECT_TRUE(validate_geometry(foam).empty());
}

TEST_P(AnyBoundary, TakesASquareGrid) {
  for (const Index side : {2, 3, 10, 40}) {
    const auto points = jittered_grid(side * side, 0.1, 0, 1);
    expect_foam_of(build_from_points(points, with(GetParam())), side * side, GetParam());
  }
}

TEST_P(AnyBoundary, TakesPointsOfVeryUnequalDistances) {
  std::vector<Vec2> points = jittered_grid(1000, 1, 1, 4);
  for (Vec2& p : points) {
    p = {std::exp(0.3 * p.x), std::exp(0.2 * p.y)};
  }
  expect_foam_of(build_from_points(points, with(GetParam())), 1000, GetParam());
}

TEST_P(AnyBoundary, TakesPointsOnACircle) {
  std::vector<Vec2> points;
  for (int i = 0; i < 500; ++i) {
    points.push_back(
        {std::cos(0.004 * std::numbers::pi * i), std::sin(0.004 * std::numbers::pi * i)});
  }
  expect_foam_of(build_from_points(points, with(GetParam())), 500, GetParam());
}

TEST_P(AnyBoundary, IsAFunctionOfThePoints) {
  for (const double jitter : {0.0, 1.0}) {
    const auto points = jittered_grid(400, 1, jitter, 2);
    EXPECT_TRUE(same(build_from_points(points, with(GetParam())),
                     build_from_points(points, with(GetParam()))));
  }
}

TEST_P(AnyBoundary, FoamIsTheSameAsReadBackFromItsFilms) {
  for (const Index n : {3, 5, 200}) {
    const Foam foam = build_from_points(jittered_grid(n, 1, 1, 2), with(GetParam()));
    Foam read = foam_of(film_set(foam));
    read.box = foam.box;
    EXPECT_TRUE(same(foam, read)) << n;
  }
}

TEST_P(AnyBoundary, UniformTargetAreasAreTheMean) {
  auto options = with(GetParam());
  const auto points = jittered_grid(50, 1, 1, 2);
  const double mean = total(build_from_points(points, options).target_area) / 50;
  options.target_areas = TargetAreas::Uniform;
  for (const double area : build_from_points(points, options).target_area) {
    EXPECT_NEAR(area, mean, 1e-13);
  }
}

TEST_P(AnyBoundary, RefusesBadPoints) {
  const auto options = with(GetParam());
  const std::vector<Vec2> two{{0, 0}, {1, 0}};
  EXPECT_EQ(error_of(two, options), "a foam takes at least 3 points, but there are 2");
  EXPECT_EQ(error_of({}, options), "a foam takes at least 3 points, but there are 0");
  const std::vector<Vec2> nan{{0, 0}, {1, 0}, {0.5, kNan}};
  EXPECT_EQ(error_of(nan, options), "point 2 is at (0.5, nan)");
  const std::vector<Vec2> infinite{{0, 0}, {-kInfinity, 0}, {0.5, 1}};
  EXPECT_EQ(error_of(infinite, options), "point 1 is at (-inf, 0)");
  const std::vector<Vec2> twice{{0, 0}, {1, 0.25}, {0.5, 1}, {0.5, 0.5}, {1, 0.25}};
  EXPECT_EQ(error_of(twice, options), "points 1 and 4 are both at (1, 0.25)");
}

TEST_P(AnyBoundary, RefusesBadOptions) {
  const auto points = jittered_grid(4, 1, 1, 1);
  for (const double bad : {0.0, -1.0, kNan, kInfinity}) {
    auto options = with(GetParam());
    options.surface_tension = bad;
    EXPECT_EQ(error_of(points, options).find("the surface tension must be positive, but is "), 0u);
  }
  for (const double bad : {-0.5, kNan, kInfinity}) {
    auto options = with(GetParam());
    options.fin_size = bad;
    EXPECT_EQ(error_of(points, options).find("the fin size must not be negative, but is "), 0u);
  }
  auto options = with(GetParam());
  options.target_areas = TargetAreas::Array;
  options.target_area_array = {1, 1, 1};
  EXPECT_EQ(error_of(points, options), "there are 3 target areas for 4 points");
  options.target_area_array = {1, 1, 1, 0};
  EXPECT_EQ(error_of(points, options), "the target area of point 3 must be positive, but is 0");
  options.target_area_array = {1, kNan, 1, 1};
  EXPECT_EQ(error_of(points, options), "the target area of point 1 must be positive, but is nan");
}

class Outlined : public AnyBoundary {};
INSTANTIATE_TEST_SUITE_P(Boundaries, Outlined, testing::Values(Boundary::Free, Boundary::Fixed));

TEST_P(Outlined, ATriangleHasItsFinsAtTheirPlaces) {
  auto options = with(GetParam());
  const std::vector<Vec2> points{{0, 0}, {3, 0}, {0, 4}};
  options.fin_size = 0.6;
  const Foam foam = build_from_points(points, options);
  // Thesis 4.5.3: a fin's tip stands 0.6 off the middle of its edge; junctions are barycentres.
  std::vector<Vec2> expected{
      {1, 4.0 / 3}, {1.5, -0.2}, {-0.2, 2}, {1.5 + 0.2 * 0.8, 2 + 0.2 * 0.6}};
  for (const Vec2 place : expected) {
    EXPECT_EQ(std::ranges::count_if(foam.position, [&](Vec2 p) { return norm(p - place) < 1e-14; }),
              1);
  }
  // Without a size, 1.5·√(6/3) for each fin, here less than 1.5 edges.
  const Foam default_fins = build_from_points(points, with(GetParam()));
  const double out = 0.5 * std::sqrt(2.0);
  EXPECT_EQ(std::ranges::count_if(default_fins.position,
                                  [&](Vec2 p) {
                                    return norm(p - Vec2{1.5, -out}) < 1e-14;
                                  }),
            1);
}

TEST_P(Outlined, ASquareGridHasTheWorldOnFourSides) {
  const Foam foam = build_from_points(jittered_grid(100, 1, 0, 1), with(GetParam()));
  Index on_world = 0;
  for (Index b = 0; b < 100; ++b) {
    on_world += foam.bubble_on_world(b);
  }
  EXPECT_EQ(on_world, 36);
}

TEST_P(Outlined, BubblesOnTheBoundaryAreNoLongerThanTheRest) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    const Foam foam = build_from_points(jittered_grid(2000, 1, 1, seed), with(GetParam()));
    const double mean = total(foam.target_area) / 2000;
    EXPECT_LT(*std::ranges::max_element(foam.target_area), 4 * mean);
  }
}

TEST_P(AnyBoundary, RefusesPointsOnALine) {
  const std::vector<Vec2> exactly{{0, 0}, {1, 0}, {2, 0}};
  EXPECT_EQ(error_of(exactly, with(GetParam())),
            "all 3 points lie on the line through (0, 0) and (1, 0)");
  std::vector<Vec2> rounded;
  for (int i = 0; i < 20; ++i) {
    rounded.push_back({0.1 * i, 0.3 * i});
  }
  EXPECT_EQ(error_of(rounded, with(GetParam())).find("all 20 points lie on the line through "), 0u);
}

TEST(FromPoints, FreeTargetAreasAreTakenAsGiven) {
  auto options = with(Boundary::Free);
  options.target_areas = TargetAreas::Array;
  options.target_area_array = {1, 2, 3, 4};
  const Foam foam = build_from_points(jittered_grid(4, 1, 1, 1), options);
  EXPECT_EQ(foam.target_area, options.target_area_array);
}

TEST(FromPoints, GivenTargetAreasMustFillTheTorus) {
  auto options = with(Boundary::Periodic);
  options.periodic_box = Box{0, 2, 0, 2};
  options.target_areas = TargetAreas::Array;
  options.target_area_array = {0.5, 0.5, 1, 2 + 1e-6};
  const auto points = jittered_grid(4, 1, 1, 1);
  const Foam foam = build_from_points(points, options);
  EXPECT_NEAR(total(foam.target_area), 4, 1e-15);
  EXPECT_NEAR(foam.target_area[3] / foam.target_area[0], 2 * (2 + 1e-6), 1e-14);
  options.target_area_array[3] = 2.25;
  EXPECT_EQ(error_of(points, options),
            "the target areas add up to 4.25, but the area of the periodic bounds is 4");
}

TEST(FromPoints, GivenTargetAreasMustFillTheContainer) {
  auto options = with(Boundary::Fixed);
  const auto points = jittered_grid(30, 1, 1, 1);
  const double space = total(build_from_points(points, options).target_area);
  options.target_areas = TargetAreas::Array;
  options.target_area_array.assign(30, space / 30 * (1 + 5e-7));
  EXPECT_NEAR(total(build_from_points(points, options).target_area), space, 1e-13 * space);
  options.target_area_array.assign(30, 1);
  EXPECT_EQ(error_of(points, options)
                .find("the target areas add up to 30, but the area of the "
                      "container is "),
            0u);
}

TEST(FromPoints, DefaultBoxOfASquareGridIsItsPeriod) {
  const Foam foam = build_from_points(jittered_grid(49, 0.5, 0, 1), with(Boundary::Periodic));
  EXPECT_NEAR(foam.box.xmin, 0, 1e-14);
  EXPECT_NEAR(foam.box.xmax, 3.5, 1e-14);
  EXPECT_NEAR(foam.box.ymin, 0, 1e-14);
  EXPECT_NEAR(foam.box.ymax, 3.5, 1e-14);
  for (const Index n : foam.sides) {
    EXPECT_EQ(n, 6);
  }
}

TEST(FromPoints, AHexagonalLatticeIsAHoneycomb) {
  const Foam foam = honeycomb(8, 5);
  expect_foam_of(foam, 80, Boundary::Periodic);
  for (Index b = 0; b < 80; ++b) {
    EXPECT_EQ(foam.sides[Foam::size(b)], 6);
    EXPECT_NEAR(foam.area(b), std::sqrt(0.75), 1e-13);
  }
  for (Index f = 0; f < foam.film_capacity(); ++f) {
    EXPECT_NEAR(foam.length(2 * f), 1 / std::sqrt(3.0), 1e-13);
  }
}

TEST(FromPoints, AFreeHexagonalLatticeIsAFoam) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Fixed}) {
    expect_foam_of(build_from_points(honeycomb_points(8, 5), with(boundary)), 80, boundary);
  }
}

TEST(FromPoints, TorusMayHaveAnyAspect) {
  const auto points = jittered_grid(100, 1, 1, 1);
  for (const double stretch : {0.01, 0.3, 7.0, 1000.0}) {
    auto options = with(Boundary::Periodic);
    options.periodic_box = Box{0, 10 * stretch, 0, 10};
    std::vector<Vec2> stretched;
    for (const Vec2 p : points) {
      stretched.push_back({stretch * p.x, p.y});
    }
    expect_foam_of(build_from_points(stretched, options), 100, Boundary::Periodic);
    stretched.resize(3);
    expect_foam_of(build_from_points(stretched, options), 3, Boundary::Periodic);
  }
}

TEST(FromPoints, TorusIsTheSameWhereverItsPointsAreSeen) {
  auto options = with(Boundary::Periodic);
  options.periodic_box = Box{-1, 3, 2, 4};
  std::vector<Vec2> points;
  for (const Vec2 p : jittered_grid(64, 0.5, 1, 3)) {
    points.push_back({p.x - 1, 0.5 * p.y + 2});
  }
  const Foam foam = build_from_points(points, options);
  for (std::size_t i = 0; i < points.size(); i += 3) {
    points[i] += {4.0 * static_cast<double>(i % 5), -2.0 * static_cast<double>(i % 7)};
  }
  const Foam wrapped = build_from_points(points, options);
  EXPECT_EQ(wrapped.junction_half, foam.junction_half);
  EXPECT_EQ(wrapped.film_wrap, foam.film_wrap);
  for (Index j = 0; j < foam.junction_capacity(); ++j) {
    EXPECT_NEAR(norm(wrapped.position[Foam::size(j)] - foam.position[Foam::size(j)]), 0, 1e-13);
    EXPECT_GE(foam.position[Foam::size(j)].x, -1);
    EXPECT_LE(foam.position[Foam::size(j)].x, 3);
    EXPECT_GE(foam.position[Foam::size(j)].y, 2);
    EXPECT_LE(foam.position[Foam::size(j)].y, 4);
  }
}

TEST(FromPoints, RefusesABoxWithoutArea) {
  const auto points = jittered_grid(4, 1, 1, 1);
  auto options = with(Boundary::Periodic);
  options.periodic_box = Box{0, 2, 1, 1};
  EXPECT_EQ(error_of(points, options), "the periodic bounds enclose no area: 0 2 1 1");
  options.periodic_box = Box{2, 0, 0, 1};
  EXPECT_EQ(error_of(points, options), "the periodic bounds enclose no area: 2 0 0 1");
  options.periodic_box = Box{0, kNan, 0, 1};
  EXPECT_EQ(error_of(points, options), "the periodic bounds enclose no area: 0 nan 0 1");
  options.periodic_box = Box{0, kInfinity, 0, 1};
  EXPECT_EQ(error_of(points, options), "the periodic bounds enclose no area: 0 inf 0 1");
  options.periodic_box = Box{0, 2e6, 0, 1};
  EXPECT_EQ(error_of(points, options), "the periodic bounds are 2e+06 times longer than wide");
}

TEST(FromPoints, RefusesPointsThatAreTheSameOnTheTorus) {
  auto options = with(Boundary::Periodic);
  options.periodic_box = Box{0, 2, 0, 2};
  const std::vector<Vec2> points{{0.5, 0}, {1, 1}, {1.5, 1}, {0.5, 2}};
  EXPECT_EQ(error_of(points, options),
            "points 0 at (0.5, 0) and 3 at (0.5, 2) are the same point of the torus");
}

} // namespace
} // namespace foam
