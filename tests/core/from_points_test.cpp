// SPDX-License-Identifier: GPL-3.0-or-later
#include "construct/from_points.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <span>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/random.h"
#include "construct/jittered_grid.h"
#include "geometry/bounds.h"
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
  EXPECT_EQ(foam.surroundings.boundary, boundary);
  EXPECT_EQ(foam.bubble_count(), n);
  EXPECT_EQ(foam.junction_count(), torus ? 2 * n : 2 * (n - 1));
  EXPECT_EQ(foam.film_count(), torus ? 3 * n : 3 * (n - 1));
  for (const Bubble b : foam.bubble_slots()) {
    EXPECT_EQ(foam.bubble_id[b], b.index());
    EXPECT_GT(foam.area(b), 0) << "bubble " << b.index() << " of " << n;
    EXPECT_DOUBLE_EQ(foam.target_area[b], foam.area(b));
  }
  EXPECT_TRUE(std::ranges::all_of(foam.pressure, [](double p) { return p == 0; }));
  EXPECT_TRUE(std::ranges::all_of(foam.film_angle, [](double a) { return a == 0; }));
  if (torus) {
    const double cell = foam.surroundings.lattice.area();
    EXPECT_NEAR(total(foam.target_area), cell, 1e-12 * cell);
  }
}

/// The arrays that make a foam.
bool same(const Foam& a, const Foam& b) {
  return a.position == b.position && a.junction_half == b.junction_half &&
         a.half_junction == b.half_junction && a.half_bubble == b.half_bubble &&
         a.bubble_half == b.bubble_half && a.sides == b.sides && a.film_wrap == b.film_wrap &&
         a.target_area == b.target_area && a.surroundings == b.surroundings;
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
    EXPECT_TRUE(same(foam, foam_of(film_set(foam)))) << n;
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

TEST_P(Outlined, ASquareGridHasTheOutsideOnFourSides) {
  const Foam foam = build_from_points(jittered_grid(100, 1, 0, 1), with(GetParam()));
  Index on_outside = 0;
  for (const Bubble b : foam.bubble_slots()) {
    on_outside += foam.bubble_on_outside(b);
  }
  EXPECT_EQ(on_outside, 36);
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
  options.torus = Lattice::rectangle(0, 2, 0, 2);
  options.target_areas = TargetAreas::Array;
  options.target_area_array = {0.5, 0.5, 1, 2 + 1e-6};
  const auto points = jittered_grid(4, 1, 1, 1);
  const Foam foam = build_from_points(points, options);
  EXPECT_NEAR(total(foam.target_area), 4, 1e-15);
  EXPECT_NEAR(foam.target_area[Bubble(3)] / foam.target_area[Bubble(0)], 2 * (2 + 1e-6), 1e-14);
  options.target_area_array[3] = 2.25;
  EXPECT_EQ(
      error_of(points, options),
      "the target areas add up to 4.25, but the area of the torus is 4: FitAreas scales them, "
      "whatever they add up to");
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

TEST(FromPoints, DefaultTorusOfASquareGridIsItsPeriod) {
  const Foam foam = build_from_points(jittered_grid(49, 0.5, 0, 1), with(Boundary::Periodic));
  const auto& [origin, first, second] = foam.surroundings.lattice;
  EXPECT_NEAR(norm(origin), 0, 1e-14);
  EXPECT_NEAR(norm(first - Vec2{3.5, 0}), 0, 1e-14);
  EXPECT_NEAR(norm(second - Vec2{0, 3.5}), 0, 1e-14);
  for (const Index n : foam.sides) {
    EXPECT_EQ(n, 6);
  }
}

/// Points in cells wider than high ask for a gap of their own in x and another in y: those of the
/// cells.
TEST(FromPoints, DefaultTorusHasAGapForEachDirection) {
  constexpr Vec2 kCell{1.5, 1 / 1.5};
  constexpr int kSeeds = 20;
  for (const double jitter : {0.0, 0.5, 1.0}) {
    Vec2 mean;
    for (int seed = 1; seed <= kSeeds; ++seed) {
      auto points = jittered_grid(400, 1, jitter, static_cast<std::uint64_t>(seed));
      for (Vec2& p : points) {
        p = {kCell.x * p.x, kCell.y * p.y};
      }
      const Lattice torus =
          build_from_points(points, with(Boundary::Periodic)).surroundings.lattice;
      mean += (1.0 / kSeeds) * Vec2{torus.first.x, torus.second.y};
    }
    EXPECT_NEAR(mean.x, 20 * kCell.x, jitter > 0 ? 0.06 : 1e-12) << jitter;
    EXPECT_NEAR(mean.y, 20 * kCell.y, jitter > 0 ? 0.03 : 1e-12) << jitter;
  }
}

// The mean area of points within half a spacing of the points' bounds beside that of the others.
double seam_ratio(const std::vector<Vec2>& points) {
  const Foam foam = build_from_points(points, with(Boundary::Periodic));
  const Bounds bounds = bounds_of(points);
  const double spacing = foam.mean_spacing();
  double seam = 0;
  double others = 0;
  int count = 0;
  for (const Bubble b : foam.bubble_slots()) {
    const Vec2 p = points[b.place()];
    const Vec2 inside{std::min(p.x - bounds.low.x, bounds.high.x - p.x),
                      std::min(p.y - bounds.low.y, bounds.high.y - p.y)};
    const bool at_seam = std::min(inside.x, inside.y) < 0.5 * spacing;
    (at_seam ? seam : others) += foam.area(b);
    count += at_seam ? 1 : 0;
  }
  return seam / count * (static_cast<double>(points.size()) - count) / others;
}

TEST(FromPoints, DefaultTorusOfALatticeHasItsAreas) {
  for (const int rows : {6, 7, 12, 13}) { // whose odd ones do not fit each other at the seam
    std::vector<Vec2> points;
    for (int y = 0; y < rows; ++y) {
      for (int x = 0; x < 9; ++x) {
        points.push_back({x + 0.5 * (y % 2), std::sqrt(0.75) * y});
      }
    }
    const Foam foam = build_from_points(points, with(Boundary::Periodic));
    EXPECT_NEAR(foam.surroundings.lattice.first.x, 9, 1e-5) << rows;
    EXPECT_NEAR(foam.surroundings.lattice.second.y, std::sqrt(0.75) * rows, 1e-5) << rows;
    EXPECT_NEAR(seam_ratio(points), 1, 1e-5) << rows;
  }
}

TEST(FromPoints, BubblesAtTheSeamAreAsLargeAsTheOthers) {
  constexpr int kSamples = 20;
  double poisson = 0;
  double jittered = 0;
  for (std::uint64_t seed = 1; seed <= kSamples; ++seed) {
    Random random(seed);
    std::vector<Vec2> points(400);
    for (Vec2& p : points) {
      p.x = 20 * random.uniform();
      p.y = 20 * random.uniform();
    }
    poisson += seam_ratio(points) / kSamples;
    jittered += seam_ratio(jittered_grid(400, 1, 1, seed)) / kSamples;
    EXPECT_NEAR(seam_ratio(jittered_grid(400, 1, 1, seed)), 1, 0.15) << seed;
  }
  EXPECT_NEAR(poisson, 1, 0.06); // three times what twenty samples scatter by
  EXPECT_NEAR(jittered, 1, 0.03);
}

TEST(FromPoints, AHexagonalLatticeIsAHoneycomb) {
  const Foam foam = honeycomb(8, 5);
  expect_foam_of(foam, 80, Boundary::Periodic);
  for (const Bubble b : foam.bubble_slots()) {
    EXPECT_EQ(foam.sides[b], 6);
    EXPECT_NEAR(foam.area(b), std::sqrt(0.75), 1e-13);
  }
  for (const Film f : foam.film_slots()) {
    EXPECT_NEAR(foam.length(f.half()), 1 / std::sqrt(3.0), 1e-13);
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
    options.torus = Lattice::rectangle(0, 10 * stretch, 0, 10);
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
  options.torus = Lattice::rectangle(-1, 3, 2, 4);
  std::vector<Vec2> points;
  for (const Vec2 p : jittered_grid(64, 0.5, 1, 3)) {
    points.push_back({p.x - 1, 0.5 * p.y + 2});
  }
  const Foam foam = build_from_points(points, options);
  for (std::size_t i = 0; i < points.size(); i += 3) {
    points[i] += {4.0 * static_cast<double>(i % 5), -2.0 * static_cast<double>(i % 7)};
  }
  options.fold = true;
  const Foam wrapped = build_from_points(points, options);
  EXPECT_EQ(wrapped.junction_half, foam.junction_half);
  EXPECT_EQ(wrapped.film_wrap, foam.film_wrap);
  for (const Junction j : foam.junction_slots()) {
    EXPECT_NEAR(norm(wrapped.position[j] - foam.position[j]), 0, 1e-13);
    EXPECT_GE(foam.position[j].x, -1);
    EXPECT_LE(foam.position[j].x, 3);
    EXPECT_GE(foam.position[j].y, 2);
    EXPECT_LE(foam.position[j].y, 4);
  }
}

TEST(FromPoints, RefusesPeriodsThatMakeNoTorus) {
  const auto points = jittered_grid(4, 1, 1, 1);
  const auto error_with = [&](const Lattice& torus) {
    auto options = with(Boundary::Periodic);
    options.fold = true;
    options.torus = torus;
    return error_of(points, options);
  };
  EXPECT_EQ(error_with(Lattice::rectangle(0, 2, 1, 1)),
            "the periods (2, 0) and (0, 0) at (0, 1) enclose no area");
  EXPECT_EQ(error_with(Lattice::rectangle(0, kNan, 0, 1)),
            "the periods (nan, 0) and (0, 1) at (0, 0) enclose no area");
  EXPECT_EQ(error_with(Lattice::rectangle(0, kInfinity, 0, 1)),
            "the periods (inf, 0) and (0, 1) at (0, 0) enclose no area");
  EXPECT_EQ(error_with({{kNan, 0}, {1, 0}, {0, 1}}),
            "the periods (1, 0) and (0, 1) at (nan, 0) enclose no area");
  EXPECT_EQ(error_with({{}, {2, 1}, {4, 2}}),
            "the periods (2, 1) and (4, 2) at (0, 0) enclose no area");
  EXPECT_EQ(error_with({{}, {1, 2}, {2, 1}}), "the periods (1, 2) and (2, 1) are clockwise");
  EXPECT_EQ(error_with(Lattice::rectangle(0, 2e6, 0, 1)),
            "the periods (2e+06, 0) and (0, 1) enclose a cell 2e+06 times longer than wide");
  EXPECT_EQ(error_with({{}, {1, 0}, {2048, 1}}),
            "the periods (1, 0) and (2048, 1) enclose a cell 4194305 times longer than wide");
}

TEST(FromPoints, RefusesAPointThatIsTooFarAway) {
  auto options = with(Boundary::Periodic);
  options.torus = Lattice::rectangle(0, 2, 0, 2);
  options.fold = true;
  const std::vector<Vec2> points{{0.5, 0}, {1, 1}, {1.5, 1}, {0.5, 1e11}};
  EXPECT_EQ(error_of(points, options),
            "point 3 at (0.5, 1e+11) lies too many periods from the torus's cell");
}

TEST(FromPoints, RefusesATorusSmallerThanItsPointsUnlessTheyAreFolded) {
  const auto points = jittered_grid(100, 1, 0, 1); // 9 by 9 across
  auto options = with(Boundary::Periodic);
  options.torus = Lattice::rectangle(0, 10, 0, 8.5);
  EXPECT_EQ(error_of(points, options),
            "the points extend over (9, 9), but the torus is only (10, 8.5)");
  options.torus = Lattice{{}, {5, 1}, {-1, 5}};
  EXPECT_EQ(error_of(points, options),
            "the points cover an area of 81, but that of the torus is 26");
  options.fold = true;
  EXPECT_EQ(build_from_points(jittered_grid(100, 1, 1, 1), options).bubble_count(), 100);
  options.fold = false;
  options.torus = Lattice{{3, -40}, {10, 0}, {3, 10}}; // whose cell is no rectangle
  EXPECT_EQ(build_from_points(points, options).bubble_count(), 100);
}

// Tori of any two periods.

/// Of each bubble the bubbles beside it, in ascending order.
std::vector<std::vector<Index>> neighbours(const Foam& foam) {
  std::vector<std::vector<Index>> result;
  for (const Bubble b : foam.bubble_slots()) {
    auto& beside = result.emplace_back();
    for_each_half(foam, b, [&](Half h) { beside.push_back(foam.right(h).index()); });
    std::ranges::sort(beside);
  }
  return result;
}

/// Points at random in the cell of a torus.
std::vector<Vec2> random_points(const Lattice& torus, Index n) {
  Random random(7);
  std::vector<Vec2> points;
  for (Index i = 0; i < n; ++i) {
    const double along_first = random.uniform();
    points.push_back(torus.origin + along_first * torus.first + random.uniform() * torus.second);
  }
  return points;
}

Foam on_torus(std::span<const Vec2> points, const Lattice& torus) {
  auto options = with(Boundary::Periodic);
  options.fold = true;
  options.torus = torus;
  return build_from_points(points, options);
}

/// How much larger bubbles at the seam of a torus are than the others.
double seam_ratio(const Foam& foam) {
  double seam = 0;
  double other = 0;
  int at_seam = 0;
  for (const Bubble b : foam.bubble_slots()) {
    bool crosses = false;
    for_each_half(foam, b, [&](Half h) { crosses = crosses || foam.wrap(h) != Wrap{}; });
    (crosses ? seam : other) += foam.area(b);
    at_seam += crosses ? 1 : 0;
  }
  return seam / at_seam / (other / (foam.bubble_count() - at_seam));
}

/// On the torus that is found for points the seam is not seen: it is as on the torus that they were
/// made for.
TEST(FromPoints, FindsATorusWhoseSeamIsNotSeen) {
  const Lattice torus = Lattice::rectangle(3, 23, -5, 15);
  struct Found {
    double seam = 0, area = 0;
  };
  const auto mean_of = [&](const auto& points_of) {
    constexpr int kSeeds = 10;
    Found mean;
    for (int seed = 1; seed <= kSeeds; ++seed) {
      const std::vector<Vec2> points = points_of(seed);
      const Foam found = build_from_points(points, with(Boundary::Periodic));
      mean.seam += seam_ratio(found) / seam_ratio(on_torus(points, torus)) / kSeeds;
      mean.area += found.surroundings.lattice.area() / torus.area() / kSeeds;
    }
    return mean;
  };
  const auto random = mean_of([&](int seed) {
    Random numbers(static_cast<std::uint64_t>(seed));
    std::vector<Vec2> points;
    for (int i = 0; i < 400; ++i) {
      const double x = numbers.uniform();
      points.push_back(torus.origin + x * torus.first + numbers.uniform() * torus.second);
    }
    return points;
  });
  const auto jittered = [&](double jitter) {
    return mean_of([&](int seed) {
      auto points = jittered_grid(400, 1, jitter, static_cast<std::uint64_t>(seed));
      for (Vec2& point : points) {
        point += torus.origin;
      }
      return points;
    });
  };
  EXPECT_NEAR(random.seam, 1, 0.12) << "the points' own number fluctuates";
  EXPECT_NEAR(random.area, 1, 0.05);
  const Found as_from_foam_points = jittered(1);
  EXPECT_NEAR(as_from_foam_points.seam, 1, 0.03);
  EXPECT_NEAR(as_from_foam_points.area, 1, 0.01);
  EXPECT_NEAR(jittered(0.3).area, 1, 0.01);
  EXPECT_NEAR(jittered(0).area, 1, 1e-12) << "the grid's own";
}

class AnyTorus : public testing::TestWithParam<Lattice> {};
INSTANTIATE_TEST_SUITE_P(
    Lattices, AnyTorus,
    testing::Values(Lattice{{0, 0}, {10, 0}, {0, 10}}, Lattice{{0, 0}, {10, 0}, {3, 10}},
                    Lattice{{-2, 1}, {10, 2}, {-4, 9}}, Lattice{{1, 1}, {7, 7}, {-6, 8}},
                    Lattice{{0, 0}, {0, -10}, {10, 0}}, Lattice{{0, 0}, {10, 0}, {37, 10}},
                    Lattice{{5, -3}, {10, 1}, {-93, -1}}, Lattice{{0, 0}, {300, 1}, {0.3, 0.2}}));

TEST_P(AnyTorus, IsFilledByItsBubbles) {
  for (const Index n : {3, 4, 7, 30, 500}) {
    SCOPED_TRACE(n);
    const Foam foam = on_torus(random_points(GetParam(), n), GetParam());
    expect_foam_of(foam, n, Boundary::Periodic);
    EXPECT_EQ(foam.surroundings.lattice, GetParam());
    EXPECT_TRUE(validate_geometry(foam).empty());
  }
}

TEST_P(AnyTorus, HasTheSameNeighboursInAnyBasis) {
  const auto& [origin, first, second] = GetParam();
  const std::vector<Lattice> others{{origin, first, second + 3 * first},
                                    {origin, first - 2 * second, second},
                                    {origin, second, -first},
                                    {origin + Vec2{0.3, -1.7}, first + second, second}};
  for (const Index n : {3, 7, 30, 500}) {
    const auto points = random_points(GetParam(), n);
    const auto expected = neighbours(on_torus(points, GetParam()));
    for (const Lattice& other : others) {
      EXPECT_EQ(neighbours(on_torus(points, other)), expected) << n;
    }
  }
}

TEST_P(AnyTorus, HasTheSameNeighboursWhereverItsPointsAreSeen) {
  const Lattice& torus = GetParam();
  auto points = random_points(torus, 100);
  const auto expected = neighbours(on_torus(points, torus));
  for (std::int32_t i = 0; i < 100; i += 3) {
    points[place_of(i)] += torus.period({i % 5, -(i % 7)});
  }
  EXPECT_EQ(neighbours(on_torus(points, torus)), expected);
}

TEST(FromPoints, AHexagonalLatticeIsAHoneycombInARhombus) {
  const Vec2 a{1, 0};
  const Vec2 b{0.5, std::sqrt(0.75)};
  std::vector<Vec2> points;
  for (int i = 0; i < 36; ++i) {
    points.push_back((i % 6 + 0.25) * a + (i / 6 + 0.25) * b);
  }
  for (const Lattice& torus : {Lattice{{}, 6 * a, 6 * b}, Lattice{{}, 6 * a, 6 * b - 12 * a}}) {
    const Foam foam = on_torus(points, torus);
    expect_foam_of(foam, 36, Boundary::Periodic);
    for (const Bubble bubble : foam.bubble_slots()) {
      EXPECT_EQ(foam.sides[bubble], 6);
      EXPECT_NEAR(foam.area(bubble), std::sqrt(0.75), 1e-13);
    }
  }
}

/// Every four neighbours lie on a circle.
TEST(FromPoints, ASquareGridFitsASkewedTorus) {
  for (const Lattice& torus : {Lattice{{}, {4, 1}, {-1, 4}}, Lattice{{}, {4, 1}, {11, 7}}}) {
    std::vector<Vec2> points; // (17, 0) is a sum of periods, and nothing before it on the axis
    for (int i = 0; i < 17; ++i) {
      const Vec2 p{i + 0.5, 0.5};
      points.push_back(p - torus.period(torus.cell_of(p)));
    }
    expect_foam_of(on_torus(points, torus), 17, Boundary::Periodic);
  }
}

TEST(FromPoints, RefusesPointsThatAreTheSameOnTheTorus) {
  auto options = with(Boundary::Periodic);
  options.torus = Lattice::rectangle(0, 2, 0, 2);
  const std::vector<Vec2> points{{0.5, 0}, {1, 1}, {1.5, 1}, {0.5, 2}};
  EXPECT_EQ(error_of(points, options),
            "points 0 at (0.5, 0) and 3 at (0.5, 2) are the same point of the torus");
}

} // namespace
} // namespace foam
