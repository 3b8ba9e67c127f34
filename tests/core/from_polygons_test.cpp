// SPDX-License-Identifier: GPL-3.0-or-later
// Foams of polygons that share points.
#include "construct/from_polygons.h"

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include "base/error.h"
#include "foams.h"
#include "geometry/arc.h"

namespace foam::test {
namespace {

struct Polygons {
  std::vector<Vec2> points;
  std::vector<std::vector<Index>> cells;
};

DivisionFoam build(const Polygons& of, DivisionOutline outline = DivisionOutline::Films) {
  std::vector<Polygon> polygons;
  for (const auto& points : of.cells) {
    polygons.push_back({static_cast<std::int64_t>(polygons.size()), points});
  }
  return build_from_polygons(of.points, polygons, outline, 0.25);
}

std::string error_of(const Polygons& of) {
  try {
    build(of);
  } catch (const FoamError& error) {
    return error.what();
  }
  return "no error";
}

/// A foam's bubbles as polygons with so many points on each film.
Polygons polygons_of(const Foam& foam, int inside) {
  Polygons result;
  result.points.assign(foam.position.begin(), foam.position.end());
  std::vector<Index> first(foam.film_angle.size());
  for (const Film f : foam.film_slots()) {
    const Half h = f.half();
    first[f.place()] = static_cast<Index>(result.points.size());
    for (int k = 1; k <= inside; ++k) {
      result.points.push_back(arc_point(foam.position[foam.start(h)], foam.chord(h),
                                        foam.half_angle(h), static_cast<double>(k) / (inside + 1)));
    }
  }
  for (const Bubble b : foam.bubble_slots()) {
    auto& cell = result.cells.emplace_back();
    for_each_half(foam, b, [&](Half h) {
      cell.push_back(foam.start(h).index());
      for (int k = 0; k < inside; ++k) {
        cell.push_back(first[h.film().place()] + (h.reversed() ? inside - 1 - k : k));
      }
    });
  }
  return result;
}

/// Who is beside whom, how often.
std::map<std::pair<std::int64_t, std::int64_t>, int> neighbours(const Foam& foam) {
  std::map<std::pair<std::int64_t, std::int64_t>, int> pairs;
  const auto id = [&](Bubble b) { return b.is_outside() ? -1 : foam.bubble_id[b]; };
  for (const Film f : foam.film_slots()) {
    if (foam.has_film(f)) {
      const auto [low, high] = std::minmax({id(foam.left(f.half())), id(foam.right(f.half()))});
      ++pairs[{low, high}];
    }
  }
  return pairs;
}

/// A grid of squares, of which four meet in each inner point.
Polygons squares(Index columns, Index rows) {
  Polygons result;
  for (Index y = 0; y <= rows; ++y) {
    for (Index x = 0; x <= columns; ++x) {
      result.points.push_back({static_cast<double>(x), static_cast<double>(y)});
    }
  }
  const auto at = [&](Index x, Index y) { return y * (columns + 1) + x; };
  for (Index y = 0; y < rows; ++y) {
    for (Index x = 0; x < columns; ++x) {
      result.cells.push_back({at(x, y), at(x + 1, y), at(x + 1, y + 1), at(x, y + 1)});
    }
  }
  return result;
}

/// Three cells around a point.
Polygons three() {
  Polygons result;
  result.points = {{0, 0}};
  for (int k = 0; k < 6; ++k) {
    result.points.push_back(
        {std::cos(k * std::numbers::pi / 3), std::sin(k * std::numbers::pi / 3)});
  }
  result.cells = {{0, 1, 2, 3}, {0, 3, 4, 5}, {0, 5, 6, 1}};
  return result;
}

TEST(FromPolygons, KeepsNeighboursAreasAndArcs) {
  for (const std::uint64_t seed : {1, 2, 3}) {
    const Foam foam = random_foam(60, Boundary::Free, seed);
    const DivisionFoam made = build(polygons_of(foam, 15));
    expect_valid(made.foam);
    EXPECT_EQ(neighbours(made.foam), neighbours(foam));
    EXPECT_EQ(made.points_of_more_films, 0);
    for (const Bubble b : foam.bubble_slots()) {
      EXPECT_EQ(made.foam.bubble_id[b], b.index());
      // 16 chords to an arc of at most 2 rad lack 1/6·(2/16)² of the area beside it.
      EXPECT_NEAR(made.foam.area(b), foam.area(b), 0.01 * foam.area(b));
      EXPECT_EQ(made.foam.target_area[b], made.foam.area(b));
    }
    EXPECT_NEAR(made.foam.energy(), foam.energy(), 0.005 * foam.energy());
    Foam relaxed = made.foam;
    relaxed.target_area = foam.target_area;
    equilibrate(relaxed, 1e-12);
    EXPECT_NEAR(relaxed.energy(), foam.energy(), 1e-9);
  }
}

TEST(FromPolygons, MayBeWalkedEitherWayAndRepeatPoints) {
  const Polygons plain = three();
  Polygons other = plain;
  std::ranges::reverse(other.cells[1]);
  other.cells[0] = {0, 1, 2, 2, 3, 0};
  other.points.push_back({0, 0}); // again
  other.cells[2][0] = 7;
  EXPECT_TRUE(film_set(build(other).foam) == film_set(build(plain).foam));
  EXPECT_EQ(build(plain).foam.film_count(), 6); // three inside, three of the outline
  EXPECT_EQ(build(plain).foam.junction_count(), 4);
}

TEST(FromPolygons, FourOfThemInAPointAreTwoJunctions) {
  const DivisionFoam made = build(squares(5, 4));
  expect_valid(made.foam);
  EXPECT_EQ(made.points_of_more_films, 12);
  EXPECT_EQ(made.foam.junction_count(), 2 * 12 + 14);
  Foam foam = made.foam;
  equilibrate(foam);
  EXPECT_TRUE(foam.report.converged);
  // Where angles differ the smaller ones are cut off: a film's length is less that way.
  Polygons slanted = squares(2, 2);
  for (Vec2& p : slanted.points) {
    p.x += 0.5 * p.y;
  }
  const auto pairs = neighbours(build(slanted).foam);
  EXPECT_TRUE(pairs.contains({1, 2}));
  EXPECT_FALSE(pairs.contains({0, 3}));
}

TEST(FromPolygons, TwoThatTouchInAPointAreNeighbours) {
  Polygons touching = squares(2, 2);
  touching.cells = {touching.cells[0], touching.cells[3]};
  const DivisionFoam made = build(touching);
  expect_valid(made.foam);
  EXPECT_EQ(made.points_of_more_films, 1);
  EXPECT_EQ(made.foam.film_count(), 3);
}

TEST(FromPolygons, OutlineMayBeAWall) {
  const DivisionFoam made = build(squares(4, 3), DivisionOutline::Wall);
  expect_valid(made.foam);
  EXPECT_EQ(made.foam.surroundings.boundary, Boundary::Container);
  EXPECT_EQ(made.foam.wall_piece.size(), 4u); // a rectangle
  Foam foam = made.foam;
  equilibrate(foam);
  expect_equilibrium(foam);
  EXPECT_NEAR(gas(foam), 12, 1e-9);
}

TEST(FromPolygons, ErrorsNameTheCells) {
  Polygons bad = three();
  bad.cells.pop_back();
  bad.cells[1] = {0, 1, 2, 3};
  EXPECT_EQ(error_of(bad).find("cell 0 and cell 1 overlap: both lie on the same side"), 0u)
      << error_of(bad);

  Polygons hole = squares(5, 5);
  hole.cells.erase(hole.cells.begin() + 12);
  EXPECT_NE(error_of(hole).find("leave a gap or a hole between them"), std::string::npos)
      << error_of(hole);
  EXPECT_EQ(error_of(hole).find("cells 7, 11, 12, 16"), 0u) << error_of(hole);

  // A row of halves on a row of thirds: corners on sides.
  Polygons brick;
  brick.points = {{0, 0},  {3, 0},  {3, 1},  {1.5, 1}, {0, 1}, {1, 1}, {2, 1},
                  {0, -1}, {1, -1}, {2, -1}, {3, -1},  {1, 0}, {2, 0}, {1.5, 0}};
  brick.cells = {{0, 13, 3, 4}, {13, 1, 2, 3}, {7, 8, 11, 0}, {8, 9, 12, 11}, {9, 10, 1, 12}};
  EXPECT_EQ(error_of(brick),
            "cells 0, 1, 2, 3, 4 do not meet side by side: a corner of one lies on a side of "
            "another");

  Polygons apart = three();
  const Polygons again = three();
  for (const Vec2 p : again.points) {
    apart.points.push_back(p + Vec2{5, 0});
  }
  for (auto cell : again.cells) {
    for (Index& p : cell) {
      p += 7;
    }
    apart.cells.push_back(cell);
  }
  EXPECT_NE(error_of(apart).find("do not hang together with the others"), std::string::npos)
      << error_of(apart);

  Polygons folded = three();
  folded.points[0] = {1.5, 1.5}; // outside of them
  EXPECT_NE(error_of(folded).find("overlap"), std::string::npos) << error_of(folded);

  Polygons flat = three();
  flat.cells.push_back({1, 2, 1});
  EXPECT_EQ(error_of(flat).find("cell 3 encloses no area"), 0u) << error_of(flat);
  flat.cells.back() = {1, 2, 77};
  EXPECT_EQ(error_of(flat), "cell 3 has point 77, which does not exist");
  EXPECT_EQ(error_of({}), "there are no polygons");
  Polygons single = three();
  single.cells.resize(1);
  EXPECT_NE(error_of(single), "no error");
  Polygons nowhere = three();
  nowhere.points[2].x = std::nan("");
  EXPECT_EQ(error_of(nowhere), "point 2 is at (nan, " + number(nowhere.points[2].y) + ")");
}

} // namespace
} // namespace foam::test
