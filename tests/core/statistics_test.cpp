// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/statistics.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "construct/jittered_grid.h"
#include "hand_made.h"
#include "parallel/host.h"
#include "statistics/parallel_statistics.h"
#include "topology/operations.h"

namespace foam {
namespace {

/// A bubble and the six around it, from points.
Foam flower() {
  std::vector<Vec2> points{{0, 0}};
  for (int i = 0; i < 6; ++i) {
    points.push_back({std::cos(std::numbers::pi / 3 * i), std::sin(std::numbers::pi / 3 * i)});
  }
  return build_from_points(points, {});
}

const SideStatistics& with_sides(const FoamStatistics& s, Index n) {
  return *std::ranges::find(s.by_sides, n, &SideStatistics::sides);
}

TEST(Statistics, Honeycomb) {
  const Foam foam = honeycomb(6, 3);
  const auto s = statistics(foam, false);
  EXPECT_EQ(s.bubbles, 36);
  EXPECT_EQ(s.mean_sides, 6);
  EXPECT_EQ(s.mu2, 0);
  EXPECT_NEAR(s.mean_area, std::sqrt(0.75), 1e-14);
  EXPECT_NEAR(s.area_second_moment, 1, 1e-13);
  // The honeycomb's energy: √(2√3) per bubble and √area (T. Hales, Discrete Comput. Geom. 2001).
  EXPECT_NEAR(s.energy, 2 * 0.25 * 36 * std::sqrt(2 * std::sqrt(3.0) * std::sqrt(0.75)), 1e-12);
  EXPECT_TRUE(std::isnan(s.aboav)) << "one n makes no line";
  ASSERT_EQ(s.by_sides.size(), 1u);
  EXPECT_EQ(s.by_sides[0].sides, 6);
  EXPECT_EQ(s.by_sides[0].count, 36);
  EXPECT_EQ(s.by_sides[0].fraction, 1);
  EXPECT_EQ(s.by_sides[0].mean_neighbour_sides, 6);
  EXPECT_NEAR(s.by_sides[0].mean_relative_area, 1, 1e-13);
  ASSERT_EQ(s.each.size(), 36u);
  for (std::size_t i = 0; i < 36; ++i) {
    EXPECT_EQ(s.each[i].id, static_cast<std::int64_t>(i));
    EXPECT_NEAR(s.each[i].perimeter, 6 / std::sqrt(3.0), 1e-13);
    EXPECT_FALSE(s.each[i].on_boundary);
  }
}

TEST(Statistics, OneSwapInAHoneycomb) {
  // Two bubbles have five sides and neighbours of 7, 7, 6, 6, 6; two have seven, and neighbours of
  // 5, 5, 7, 6, 6, 6, 6. The line through n·m(n) = 32, 36 + 2/(N − 4), 41 rises by 4.5 per side.
  Foam foam = honeycomb(8, 4);
  perform_t1(foam, Film(100));
  const auto s = statistics(foam, false);
  EXPECT_EQ(s.mean_sides, 6);
  EXPECT_DOUBLE_EQ(s.mu2, 4.0 / 64);
  ASSERT_EQ(s.by_sides.size(), 3u);
  EXPECT_EQ(with_sides(s, 5).count, 2);
  EXPECT_EQ(with_sides(s, 7).count, 2);
  EXPECT_DOUBLE_EQ(with_sides(s, 5).mean_neighbour_sides, 32.0 / 5);
  EXPECT_DOUBLE_EQ(with_sides(s, 7).mean_neighbour_sides, 41.0 / 7);
  EXPECT_DOUBLE_EQ(with_sides(s, 6).mean_neighbour_sides, (36 + 2.0 / 60) / 6);
  EXPECT_NEAR(s.aboav, 1.5, 1e-12);
}

TEST(Statistics, SumRulesOfATorus) {
  BuildOptions options;
  options.boundary = Boundary::Periodic;
  options.torus = Lattice::rectangle(0, 20, 0, 20);
  const Foam foam = build_from_points(jittered_grid(400, 1, 1, 1), options);
  const auto s = statistics(foam, false);
  EXPECT_EQ(s.mean_sides, 6) << "Euler";
  double fractions = 0;
  double product = 0;
  double area = 0;
  for (const auto& row : s.by_sides) {
    fractions += row.fraction;
    product += row.fraction * row.sides * row.mean_neighbour_sides;
    area += row.fraction * row.mean_relative_area;
  }
  EXPECT_NEAR(fractions, 1, 1e-14);
  EXPECT_NEAR(product, 36 + s.mu2, 1e-12) << "Weaire's sum rule";
  EXPECT_NEAR(area, 1, 1e-13);
  EXPECT_NEAR(s.mean_area, 1, 1e-13);
  EXPECT_TRUE(std::ranges::is_sorted(s.by_sides, {}, &SideStatistics::sides));
  double perimeters = 0;
  for (const auto& bubble : s.each) {
    perimeters += bubble.perimeter;
  }
  EXPECT_NEAR(0.25 * perimeters, s.energy, 1e-11) << "every film bounds two bubbles";
}

TEST(Statistics, BoundaryCountsOnlyWhenAskedFor) {
  const Foam foam = flower();
  const auto inner = statistics(foam, false);
  EXPECT_EQ(inner.bubbles, 1);
  EXPECT_EQ(inner.mean_sides, 6);
  ASSERT_EQ(inner.by_sides.size(), 1u);
  EXPECT_EQ(inner.by_sides[0].mean_neighbour_sides, 4) << "bubbles on the outside are neighbours";

  const auto all = statistics(foam, true);
  EXPECT_EQ(all.bubbles, 7);
  EXPECT_DOUBLE_EQ(all.mean_sides, 30.0 / 7);
  EXPECT_DOUBLE_EQ(all.mu2, 24.0 / 7);
  EXPECT_NEAR(with_sides(all, 4).mean_neighbour_sides, 14.0 / 3, 1e-14) << "the outside is none";
  EXPECT_NEAR(all.aboav, 6 - (24 - 4 * 14.0 / 3) / 2, 1e-12) << "a line through two points";

  for (const auto* s : {&inner, &all}) {
    ASSERT_EQ(s->each.size(), 7u);
    EXPECT_FALSE(s->each[0].on_boundary);
    EXPECT_TRUE(s->each[1].on_boundary);
    EXPECT_EQ(s->energy, foam.energy());
  }
}

TEST(Statistics, EnergyIsThatOfTheFilmsOwnTensions) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Fixed}) {
    BuildOptions options;
    options.boundary = boundary;
    Foam foam = build_from_points(jittered_grid(30, 1, 1, 1), options);
    double energy = 0;
    for (const Film f : foam.film_slots()) {
      foam.film_tension.push_back(0.5 + 0.01 * (f.index() % 11));
      energy += foam.wall(f.half()) ? 0 : foam.film_tension[f] * foam.length(f.half());
    }
    EXPECT_NEAR(statistics(foam, false).energy, energy, 1e-12 * energy);
    EXPECT_EQ(statistics(foam, false).energy, foam.energy());
  }
}

TEST(Statistics, NoBubbleInside) {
  const std::vector<Vec2> points{{0, 0}, {1, 0}, {0, 1}};
  const auto s = statistics(build_from_points(points, {}), false);
  EXPECT_EQ(s.bubbles, 0);
  EXPECT_EQ(s.each.size(), 3u);
  EXPECT_TRUE(s.by_sides.empty());
  for (const double mean : {s.mean_sides, s.mu2, s.mean_area, s.area_second_moment, s.aboav}) {
    EXPECT_TRUE(std::isnan(mean));
  }
}

TEST(Statistics, VanishedBubblesAreLeftOutAndTheRestIsSortedById) {
  Foam foam = flower();
  std::ranges::reverse(foam.bubble_id);
  const Bubble gone(3);
  // The flower's petals have four sides; one swap makes a petal three-sided.
  for (const Film f : foam.film_slots()) {
    const bool of_petal = foam.left(f.half()) == gone || foam.right(f.half()) == gone;
    if (of_petal && !foam.on_outside(f.half()) && can_perform_t1(foam, f)) {
      perform_t1(foam, f);
      break;
    }
  }
  ASSERT_TRUE(can_perform_t2(foam, gone));
  perform_t2(foam, gone);
  const auto s = statistics(foam, true);
  EXPECT_EQ(s.bubbles, 6);
  ASSERT_EQ(s.each.size(), 6u);
  EXPECT_TRUE(std::ranges::is_sorted(s.each, {}, &BubbleStatistics::id));
}

TEST(Statistics, DoNotDependOnTheNumberOfThreads) {
  const Foam foam = build_from_points(jittered_grid(300, 1, 1, 1), {});
  const auto measured = [&](int threads) {
    Host host(threads, 16);
    return ParallelStatistics<Host>(host).measure(view_of(foam), BubbleNames<Host>(foam.bubble_id),
                                                  false);
  };
  const FoamStatistics one = measured(1);
  for (const int threads : {2, 7}) {
    const FoamStatistics many = measured(threads);
    EXPECT_EQ(one.mean_area, many.mean_area);
    EXPECT_EQ(one.area_second_moment, many.area_second_moment);
    EXPECT_EQ(one.energy, many.energy);
    EXPECT_EQ(one.aboav, many.aboav);
    EXPECT_TRUE(std::ranges::equal(one.each, many.each, {}, &BubbleStatistics::perimeter,
                                   &BubbleStatistics::perimeter));
  }
}

/// Sums taken one after the other, over bubbles that are seen one after the other.
TEST(Statistics, OfADisorderedFoam) {
  const Foam foam = build_from_points(jittered_grid(300, 1, 1, 2), {});
  const auto s = statistics(foam, false);
  std::map<Index, std::vector<Bubble>> with;
  double area = 0;
  double area_squared = 0;
  for (const Bubble b : foam.bubble_slots()) {
    if (!foam.bubble_on_outside(b)) {
      with[foam.sides[b]].push_back(b);
      area += foam.area(b) / s.bubbles;
      area_squared += foam.area(b) * foam.area(b) / s.bubbles;
    }
  }
  EXPECT_NEAR(s.mean_area, area, 1e-12);
  EXPECT_NEAR(s.area_second_moment, area_squared / (area * area), 1e-12);
  ASSERT_EQ(s.by_sides.size(), with.size());
  for (const auto& row : s.by_sides) {
    const std::vector<Bubble>& bubbles = with.at(row.sides);
    EXPECT_EQ(row.count, static_cast<Index>(bubbles.size()));
    double neighbours = 0;
    double own_area = 0;
    for (const Bubble b : bubbles) {
      own_area += foam.area(b);
      for_each_half(foam, b, [&](Half h) { // inside: all its neighbours are bubbles
        neighbours += static_cast<double>(foam.sides[foam.right(h)]) / row.sides;
      });
    }
    EXPECT_NEAR(row.mean_neighbour_sides, neighbours / row.count, 1e-12);
    EXPECT_NEAR(row.mean_relative_area, own_area / row.count / area, 1e-12);
  }
}

} // namespace
} // namespace foam
