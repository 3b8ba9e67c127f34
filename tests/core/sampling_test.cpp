// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/sampled_foam.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "foams.h"
#include "hand_made.h"
#include "parallel/host.h"
#include "sampling/foam_sampler.h"
#include "topology/operations.h"

namespace foam {
namespace {

constexpr double kPi = std::numbers::pi;

/// Two half discs of radius 1 with a straight film between them.
Foam halved_disc() {
  FilmSet set;
  set.surface_tension = 0.25;
  set.junctions = {{0, -1}, {0, 1}};
  set.films = {{0, 1, 0, 1, 0, {}}, {1, 0, 0, -1, kPi / 2, {}}, {0, 1, 1, -1, kPi / 2, {}}};
  set.bubbles = {{0, 0, 1}, {1, 0, 1}};
  return foam_of(set);
}

Vec2 flat(const Point3& p) {
  EXPECT_EQ(p[2], 0);
  return {p[0], p[1]};
}

/// The points of a film's polyline.
std::vector<Vec2> polyline(const FilmPolylines& films, std::size_t film) {
  std::vector<Vec2> line;
  for (auto i = films.offsets[film]; i < films.offsets[film + 1]; ++i) {
    line.push_back(flat(
        films.points[static_cast<std::size_t>(films.connectivity[static_cast<std::size_t>(i)])]));
  }
  return line;
}

std::vector<Vec2> polygon(const BubblePolygons& bubbles, std::size_t bubble) {
  std::vector<Vec2> outline;
  for (auto i = bubbles.offsets[bubble]; i < bubbles.offsets[bubble + 1]; ++i) {
    outline.push_back(flat(bubbles.points[static_cast<std::size_t>(i)]));
  }
  return outline;
}

double polygon_area(const std::vector<Vec2>& outline) {
  double twice = 0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    twice += cross(outline[i] - outline[0], outline[(i + 1) % outline.size()] - outline[0]);
  }
  return 0.5 * twice;
}

/// A foam with arcs, and with elements that are gone.
Foam coarsened_foam(Boundary boundary) {
  Foam foam = test::random_foam(60, boundary);
  int removed = 0;
  for (const Half h : foam.half_slots()) {
    const Film f = h.film();
    if (removed < 3 && foam.has_film(f)) {
      const Bubble bubble = foam.left(h);
      if (!bubble.is_outside() && foam.sides[bubble] == 4 && can_perform_t1(foam, f)) {
        perform_t1(foam, f);
        if (can_perform_t2(foam, bubble)) {
          perform_t2(foam, bubble);
          ++removed;
        }
      }
    }
  }
  EXPECT_GT(removed, 0);
  std::ranges::reverse(foam.bubble_id);
  return foam;
}

class Sampling : public testing::TestWithParam<Boundary> {};

TEST_P(Sampling, FilmsAreTheFoamsFilms) {
  const Foam foam = coarsened_foam(GetParam());
  const FilmSet set = film_set(foam);
  const SampledFoam sampled = sample(foam, 1e-3);
  const FilmPolylines& films = sampled.films;
  ASSERT_EQ(films.offsets.size(), set.films.size() + 1);
  ASSERT_EQ(films.points.size(), films.junction_id.size());
  for (std::size_t j = 0; j < set.junctions.size(); ++j) {
    EXPECT_EQ(flat(films.points[j]), set.junctions[j]);
    EXPECT_EQ(films.junction_id[j], static_cast<std::int64_t>(j));
  }
  for (std::size_t f = 0; f < set.films.size(); ++f) {
    const FilmSet::Film& film = set.films[f];
    const auto id_at = [&](std::int64_t entry) {
      return films.junction_id[static_cast<std::size_t>(
          films.connectivity[static_cast<std::size_t>(entry)])];
    };
    EXPECT_EQ(id_at(films.offsets[f]), film.start);
    EXPECT_EQ(id_at(films.offsets[f + 1] - 1), film.end);
    EXPECT_EQ(films.left[f], film.left);
    EXPECT_EQ(films.right[f], film.right);
    EXPECT_EQ(films.half_angle[f], film.half_angle);
    EXPECT_EQ(films.on_boundary[f], film.left == -1 || film.right == -1);
    const auto line = polyline(films, f);
    EXPECT_EQ(line.front(), set.junctions[film.start]) << "exactly";
    EXPECT_EQ(line.back(), set.junctions[film.end] + foam.surroundings.lattice.period(film.wrap));
  }
  std::set<std::int64_t> used(films.connectivity.begin(), films.connectivity.end());
  EXPECT_EQ(used.size(), films.points.size()) << "no point belongs to no film";
}

TEST_P(Sampling, PointsLieOnTheArcAtEqualDistances) {
  const Foam foam = coarsened_foam(GetParam());
  const double error = 1e-4;
  const FilmPolylines films = sample(foam, error).films;
  int curved = 0;
  for (std::size_t f = 0; f + 1 < films.offsets.size(); ++f) {
    const auto line = polyline(films, f);
    const double alpha = films.half_angle[f];
    const Vec2 chord = line.back() - line.front();
    if (std::abs(alpha) < 1e-3) {
      continue;
    }
    ++curved;
    // By the inscribed angle theorem an arc of half-angle α sees its chord under π − |α|; it lies
    // to the right of the chord where α > 0.
    for (std::size_t k = 1; k + 1 < line.size(); ++k) {
      const double seen = angle_from_to(line.front() - line[k], line.back() - line[k]);
      EXPECT_NEAR(std::abs(seen), kPi - std::abs(alpha), 1e-9);
      EXPECT_GT(-cross(chord, line[k] - line.front()) * alpha, 0);
    }
    // Of an arc of radius r a segment of the angle β is off by r(1 − cos β/2) in its middle.
    const double radius = norm(chord) / (2 * std::sin(std::abs(alpha)));
    EXPECT_NEAR(1 / radius, std::abs(films.curvature[f]), 1e-9);
    EXPECT_NEAR(2 * radius * std::abs(alpha), films.length[f], 1e-12);
    const auto segments = static_cast<double>(line.size() - 1);
    const auto off = [&](double n) { return radius * (1 - std::cos(std::abs(alpha) / n)); };
    EXPECT_LE(off(segments), error * (1 + 1e-9));
    EXPECT_TRUE(segments == 1 || off(segments - 1) > error * (1 - 1e-9)) << "no more than needed";
    const double length = 2 * radius * std::sin(std::abs(alpha) / segments);
    for (std::size_t k = 0; k + 1 < line.size(); ++k) {
      EXPECT_NEAR(norm(line[k + 1] - line[k]), length, 1e-12);
    }
  }
  EXPECT_GT(curved, 50);
}

TEST_P(Sampling, BubblesArePolygonsInOrderOfTheirIds) {
  const Foam foam = coarsened_foam(GetParam());
  const SampledFoam sampled = sample(foam, 1e-5);
  const BubblePolygons& bubbles = sampled.bubbles;
  ASSERT_EQ(bubbles.offsets.size(), bubbles.each.size() + 1);
  ASSERT_EQ(place_of(foam.bubble_count()), bubbles.each.size());
  EXPECT_TRUE(std::ranges::is_sorted(bubbles.each, {}, &BubbleStatistics::id));
  EXPECT_EQ(bubbles.offsets.back(), static_cast<std::int64_t>(bubbles.points.size()));
  for (std::size_t b = 0; b < bubbles.each.size(); ++b) {
    const auto outline = polygon(bubbles, b);
    const BubbleStatistics& bubble = bubbles.each[b];
    EXPECT_NEAR(polygon_area(outline), bubble.area, 1e-5 * bubble.perimeter);
    double perimeter = 0;
    for (std::size_t i = 0; i < outline.size(); ++i) {
      perimeter += norm(outline[(i + 1) % outline.size()] - outline[i]);
    }
    EXPECT_NEAR(perimeter, bubble.perimeter, 1e-3 * bubble.perimeter);
    // Every vertex is a point of a film, a whole number of periods away.
    if (!foam.surroundings.periodic()) {
      for (const Vec2 p : outline) {
        EXPECT_TRUE(std::ranges::any_of(
            sampled.films.points, [&](const Point3& q) { return norm(flat(q) - p) < 1e-12; }));
      }
    }
  }
}

TEST_P(Sampling, DoesNotDependOnTheNumberOfThreads) {
  const Foam foam = coarsened_foam(GetParam());
  const auto sampled = [&](int threads) {
    Host host(threads, 8);
    return FoamSampler<Host>(host).sample(view_of(foam), BubbleNames<Host>(foam.bubble_id), 1e-3);
  };
  const SampledFoam one = sampled(1);
  for (const int threads : {2, 5}) {
    const SampledFoam many = sampled(threads);
    EXPECT_EQ(one.energy, many.energy);
    EXPECT_EQ(one.films.points, many.films.points);
    EXPECT_EQ(one.films.junction_id, many.films.junction_id);
    EXPECT_EQ(one.films.connectivity, many.films.connectivity);
    EXPECT_EQ(one.films.curvature, many.films.curvature);
    EXPECT_EQ(one.bubbles.points, many.bubbles.points);
    EXPECT_EQ(one.bubbles.offsets, many.bubbles.offsets);
  }
  EXPECT_EQ(one.energy, foam.energy());
}

INSTANTIATE_TEST_SUITE_P(Boundaries, Sampling,
                         testing::Values(Boundary::Free, Boundary::Periodic, Boundary::Fixed));

TEST(SampledFoam, ArcKeepsWithinTheChordError) {
  for (const double error : {0.1, 1e-2, 1e-4}) {
    const SampledFoam sampled = sample(halved_disc(), error);
    EXPECT_EQ(polyline(sampled.films, 0), (std::vector<Vec2>{{0, -1}, {0, 1}})) << "straight";
    for (const std::size_t film : {1u, 2u}) {
      const auto line = polyline(sampled.films, film);
      for (std::size_t i = 0; i + 1 < line.size(); ++i) {
        EXPECT_NEAR(norm(line[i]), 1, 1e-15);
        EXPECT_LE(1 - norm(0.5 * (line[i] + line[i + 1])), error * (1 + 1e-9));
      }
    }
    for (const std::size_t bubble : {0u, 1u}) {
      const auto outline = polygon(sampled.bubbles, bubble);
      EXPECT_NEAR(polygon_area(outline), kPi / 2, 4 * error);
      for (std::size_t i = 0; i < outline.size(); ++i) {
        EXPECT_GT(norm(outline[(i + 1) % outline.size()] - outline[i]), 1e-3) << "no point twice";
      }
    }
  }
}

TEST(SampledFoam, TakesATwoHundredthOfTheSpacingForTheErrorByItself) {
  const Foam foam = halved_disc(); // target areas of 1 cm²
  EXPECT_EQ(sample(foam, 0).films.points, sample(foam, 1.0 / 200).films.points);
  EXPECT_NE(sample(foam, 0).films.points, sample(foam, 1.0 / 100).films.points);
}

TEST(SampledFoam, BubblesOfATorusAreInOnePieceWithTheirCentroidsInTheCell) {
  const Foam foam = honeycomb(4, 2);
  const BubblePolygons bubbles = sample(foam, 0.01).bubbles;
  for (std::size_t b = 0; b < bubbles.each.size(); ++b) {
    const auto outline = polygon(bubbles, b);
    ASSERT_EQ(outline.size(), 6u);
    EXPECT_NEAR(polygon_area(outline), std::sqrt(0.75), 1e-13);
    Vec2 centre;
    for (std::size_t i = 0; i < 6; ++i) {
      EXPECT_NEAR(norm(outline[(i + 1) % 6] - outline[i]), 1 / std::sqrt(3.0), 1e-13);
      centre += (1.0 / 6) * outline[i];
    }
    EXPECT_EQ(foam.surroundings.lattice.cell_of(centre), Wrap{});
  }
}

TEST(SampledFoam, BubblesOfASkewedTorusHaveTheirCentroidsInItsCell) {
  BuildOptions options;
  options.boundary = Boundary::Periodic;
  for (const Lattice& torus :
       {Lattice{{-1, 2}, {7, 1}, {-3, 6}}, Lattice{{0, 0}, {7, 0}, {26, 7}}}) {
    options.torus = torus;
    const Foam foam = build_from_points(jittered_grid(49, 1, 1, 1), options);
    const BubblePolygons bubbles = sample(foam, 0.01).bubbles;
    ASSERT_EQ(bubbles.each.size(), 49u);
    for (std::size_t b = 0; b < bubbles.each.size(); ++b) {
      const auto outline = polygon(bubbles, b);
      EXPECT_NEAR(polygon_area(outline), bubbles.each[b].area, 1e-12);
      const Polygon whole{outline.data(), static_cast<Index>(outline.size()), 0};
      EXPECT_EQ(torus.cell_of(centroid(whole)), Wrap{});
    }
  }
}

TEST(SampledFoam, FilmsHaveTheirTensions) {
  FilmSet set = film_set(halved_disc());
  EXPECT_TRUE(sample(foam_of(set), 0.1).films.tension.empty()) << "all have 2γ";
  set.tensions = {0.25, 0.5, 0.625};
  const SampledFoam sampled = sample(foam_of(set), 0.1);
  EXPECT_EQ(sampled.films.tension, set.tensions);
  EXPECT_NEAR(sampled.energy, 0.25 * 2 + (0.5 + 0.625) * kPi, 1e-14);
}

/// A quadrilateral with a reflex corner is covered by the fan around that corner alone, or the one
/// opposite.
TEST(SampledFoam, PolygonsBeginWhereAFanCoversThem) {
  const std::vector<Vec2> dart{{2, 0}, {0, 1}, {0.5, 0}, {0, -1}};
  for (Index first = 0; first < 4; ++first) {
    const Polygon best = with_best_fan({dart.data(), 4, first});
    EXPECT_EQ(fan_error(best), 0);
    EXPECT_EQ(fan_error({dart.data(), 4, first}) == 0, first % 2 == 0);
    EXPECT_NEAR(centroid(best).x, 2.5 / 3, 1e-15) << "of two triangles over the axis";
    EXPECT_NEAR(centroid(best).y, 0, 1e-15);
  }
}

} // namespace
} // namespace foam
