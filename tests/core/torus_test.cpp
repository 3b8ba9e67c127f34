// SPDX-License-Identifier: GPL-3.0-or-later
// Foams on tori of any two periods: the same whatever basis describes their lattice.
#include <gtest/gtest.h>

#include <cmath>
#include <span>
#include <string>
#include <utility>
#include <vector>

#include "../newton_on_host.h"
#include "base/random.h"
#include "engines/engines.h"
#include "foams.h"
#include "mesh/reduce.h"
#include "sampling/polygon.h"
#include "sampling/sampled_foam.h"

namespace foam::test {
namespace {

/// Cells of 1 cm²: a square, a sheared one, half a honeycomb's, and one at no angle in particular.
const Lattice kSquare{{0, 0}, {1, 0}, {0, 1}};
const Lattice kSheared{{0, 0}, {1, 0}, {0.3, 1}};
const Lattice kRhombus{{0, 0}, {1.0745699318235418, 0}, {0.5372849659117709, 0.9306048591020996}};
const Lattice kTurned{{0.2, -0.1}, {0.8, 0.6}, {-0.9, 0.575}};

Lattice scaled(double by, const Lattice& lattice) {
  return {by * lattice.origin, by * lattice.first, by * lattice.second};
}

/// A point in every cell of a square grid in the lattice's coordinates, somewhere in its middle.
std::vector<Vec2> jittered_points(const Lattice& torus, Index side, std::uint64_t seed) {
  Random random(seed);
  std::vector<Vec2> points;
  for (Index i = 0; i < side * side; ++i) {
    const double x = (i % side + 0.1 + 0.8 * random.uniform()) / side;
    const double y = (i / side + 0.1 + 0.8 * random.uniform()) / side;
    points.push_back(torus.origin + x * torus.first + y * torus.second);
  }
  return points;
}

Foam foam_of_points(std::span<const Vec2> points, const Lattice& torus) {
  BuildOptions options;
  options.boundary = Boundary::Periodic;
  options.torus = torus;
  return build_from_points(points, options);
}

/// A disordered foam of side² bubbles of 1 cm² in the mean, not in equilibrium.
Foam disordered(const Lattice& of_unit_area, Index side, std::uint64_t seed = 1) {
  const Lattice torus = scaled(side, of_unit_area);
  return foam_of_points(jittered_points(torus, side, seed), torus);
}

/// Another basis of a lattice: xx·first + xy·second and yx·first + yy·second.
struct Basis {
  std::int32_t xx, xy, yx, yy; ///< determinant 1

  Lattice of(const Lattice& lattice) const {
    return {lattice.origin, xx * lattice.first + xy * lattice.second,
            yx * lattice.first + yy * lattice.second};
  }
  /// The same periods in it: w = w′.x·(xx, xy) + w′.y·(yx, yy).
  Wrap wrap(Wrap w) const { return {yy * w.x - yx * w.y, -xy * w.x + xx * w.y}; }
};

const std::vector<Basis> kBases{{1, 1, 0, 1}, {1, 0, -3, 1}, {0, 1, -1, 0}, {2, 1, 5, 3}};

Foam described_by(const Foam& foam, const Basis& basis) {
  FilmSet set = film_set(foam);
  set.surroundings.lattice = basis.of(set.surroundings.lattice);
  for (auto& film : set.films) {
    film.wrap = basis.wrap(film.wrap);
  }
  return foam_of(set);
}

/// Everything that can be seen.
void expect_same(const Foam& a, const Foam& b, double error) {
  EXPECT_NEAR(a.energy(), b.energy(), error * a.energy());
  for (const Bubble bubble : a.bubble_slots()) {
    EXPECT_NEAR(a.area(bubble), b.area(bubble), error);
    EXPECT_NEAR(a.pressure[bubble], b.pressure[bubble], error);
  }
  for (const Film f : a.film_slots()) {
    EXPECT_NEAR(a.length(f.half()), b.length(f.half()), error);
  }
}

class AnyTorus : public testing::TestWithParam<Lattice> {};
INSTANTIATE_TEST_SUITE_P(Lattices, AnyTorus, testing::Values(kSquare, kSheared, kRhombus, kTurned));

TEST_P(AnyTorus, IsTheSameInAnyBasis) {
  Foam foam = disordered(GetParam(), 7);
  equilibrate(foam, 1e-12);
  expect_valid(foam);
  for (const Basis& basis : kBases) {
    const Foam other = described_by(foam, basis);
    expect_valid(other);
    EXPECT_NEAR(other.surroundings.lattice.area(), 49, 1e-11);
    expect_same(foam, other, 1e-12);
    const Foam back = reduced(other);
    expect_valid(back);
    expect_same(foam, back, 1e-12);
    Foam again = other;
    equilibrate(again, 1e-12);
    EXPECT_TRUE(again.report.converged);
    EXPECT_LE(again.report.iterations, 1) << "it is in equilibrium";
    expect_same(foam, again, 1e-10);
  }
}

/// Coarsens a foam in two bases.
void expect_to_coarsen_alike(const Foam& foam, const Basis& basis, Stepping stepping, int frames) {
  CoarseningOptions options = thesis_options();
  options.stepping = stepping;
  const auto here = make_coarsening(options);
  const auto there = make_coarsening(options);
  here->restart(foam);
  there->restart(described_by(foam, basis));
  for (int frame = 0; frame < frames; ++frame) {
    ASSERT_TRUE(here->advance({}));
    ASSERT_TRUE(there->advance({}));
    ASSERT_EQ(there->foam().t1_count, here->foam().t1_count) << frame;
    ASSERT_EQ(there->foam().t2_count, here->foam().t2_count) << frame;
    EXPECT_NEAR(there->foam().energy() / here->foam().energy(), 1, 1e-9) << frame;
  }
  expect_equilibrium(there->foam());
  expect_valid(there->foam());
  EXPECT_GT(here->foam().t1_count, 2);
  EXPECT_GT(here->foam().t2_count, 2);
}

TEST_P(AnyTorus, CoarsensTheSameInAnyBasis) {
  Foam foam = disordered(GetParam(), 7);
  equilibrate(foam);
  for (const Basis& basis : {kBases[1], kBases[3]}) {
    expect_to_coarsen_alike(foam, basis, Stepping::Events, 60);
  }
}

TEST(Torus, CoarsensTheSameInAnyBasisInFixedSteps) {
  Foam foam = disordered(kSheared, 7);
  equilibrate(foam);
  expect_to_coarsen_alike(foam, kBases[3], Stepping::FixedSteps, 25);
}

TEST_P(AnyTorus, EquilibriumOfPointsIsTheSameInAnyBasis) {
  const Lattice torus = scaled(8, GetParam());
  const std::vector<Vec2> points = jittered_points(torus, 8, 5);
  Foam expected = foam_of_points(points, torus);
  equilibrate(expected, 1e-12);
  EXPECT_TRUE(expected.report.converged);
  for (const Basis& basis : kBases) {
    Foam foam = foam_of_points(points, basis.of(torus));
    equilibrate(foam, 1e-12);
    EXPECT_TRUE(foam.report.converged) << foam.report.residual;
    expect_valid(foam);
    EXPECT_EQ(foam.t1_count, expected.t1_count);
    EXPECT_NEAR(foam.energy() / expected.energy(), 1, 1e-9);
    for (const Bubble b : foam.bubble_slots()) {
      EXPECT_NEAR(foam.pressure[b], expected.pressure[b], 1e-9);
    }
  }
}

/// A honeycomb on columns × rows of its own primitive cells, its junctions displaced at random.
Foam displaced_honeycomb(Index columns, Index rows) {
  const double a = std::sqrt(2 / std::sqrt(3.0)); // of a cell of 1 cm²
  const Vec2 first{a, 0};
  const Vec2 second{0.5 * a, std::sqrt(0.75) * a};
  std::vector<Vec2> points;
  for (Index i = 0; i < columns * rows; ++i) {
    points.push_back((i % columns + 0.25) * first + (i / columns + 0.25) * second);
  }
  BuildOptions options;
  options.boundary = Boundary::Periodic;
  options.torus = Lattice{{0, 0}, columns * first, rows * second};
  options.target_areas = TargetAreas::Uniform;
  options.surface_tension = 0.5;
  Foam foam = build_from_points(points, options);
  Random random(columns + 10 * rows);
  for (Vec2& p : foam.position) {
    p += {0.2 * (random.uniform() - 0.5), 0.2 * (random.uniform() - 0.5)};
  }
  return foam;
}

/// A regular hexagon of sides s has the area 3√3/2·s², and three sides of its own where six are
/// shared: with areas and tension of 1 an energy of 3s = √(2√3) for each bubble.
TEST(Torus, HoneycombInItsOwnCell) {
  const double side = std::sqrt(2 / (3 * std::sqrt(3.0)));
  for (const auto& [columns, rows] :
       {std::pair{2, 2}, {3, 2}, {2, 3}, {4, 3}, {5, 4}, {3, 9}, {8, 2}, {7, 7}}) {
    SCOPED_TRACE(std::to_string(columns) + " x " + std::to_string(rows));
    Foam foam = displaced_honeycomb(columns, rows);
    EXPECT_GT(max_angle_error(foam), 0.1);
    equilibrate(foam, 1e-12);
    EXPECT_TRUE(foam.report.converged) << foam.report.residual;
    expect_valid(foam);
    EXPECT_EQ(foam.t1_count, 0);
    EXPECT_NEAR(foam.energy() / foam.bubble_count(), 1.861209718204, 1e-11);
    EXPECT_NEAR(foam.energy(), 3 * side * foam.bubble_count(), 1e-10);
    EXPECT_LT(max_angle_error(foam), 1e-10);
    for (const Bubble b : foam.bubble_slots()) {
      EXPECT_EQ(foam.sides[b], 6);
      EXPECT_NEAR(foam.area(b), 1, 1e-11);
      EXPECT_NEAR(foam.pressure[b], 0, 1e-10) << "a common pressure is left out";
    }
    for (const Film f : foam.film_slots()) {
      EXPECT_NEAR(foam.length(f.half()), side, 1e-10);
      EXPECT_NEAR(foam.film_angle[f], 0, 1e-10);
    }
  }
}

/// Some gas changes hands, as in coarsening.
void move_gas(Foam& foam) {
  for (const Bubble b : foam.bubble_slots()) {
    foam.target_area[b] += 0.01 * (foam.sides[b] - 6);
  }
}

/// Of MINRES, for what a frame in fixed steps asks of it.
int inner_iterations(Foam foam) {
  move_gas(foam);
  const newton::NewtonResult result =
      equilibrate_on_host(view_of(foam), EquilibratorOptions{}, 0.05);
  EXPECT_TRUE(result.report.converged) << result.report.residual;
  return result.inner_iterations;
}

TEST(Torus, MinresTakesNoLongerOnASkewedOne) {
  const auto in_equilibrium = [](const Lattice& lattice) {
    Foam foam = disordered(lattice, 16);
    KrylovEquilibrator(EquilibratorOptions{}).equilibrate(foam, 0.05, {});
    expect_equilibrium(foam);
    return foam;
  };
  const int on_a_square = inner_iterations(in_equilibrium(kSquare));
  for (const Lattice& lattice : {kSheared, kRhombus, kTurned}) {
    const Foam foam = in_equilibrium(lattice);
    const int iterations = inner_iterations(foam);
    EXPECT_LT(iterations, 1.5 * on_a_square);
    EXPECT_GT(iterations, on_a_square / 1.5);
    for (const Basis& basis : kBases) {
      EXPECT_NEAR(inner_iterations(described_by(foam, basis)), iterations, 0.1 * iterations);
    }
  }
}

/// Where nothing happens in a frame, both steppings end in the same equilibrium.
TEST_P(AnyTorus, FixedStepsGoWhereEventsGo) {
  Foam start = described_by(disordered(GetParam(), 8, 3), kBases[0]);
  equilibrate(start, 1e-11);
  const auto after_a_frame = [&](Stepping stepping) {
    CoarseningOptions options = thesis_options();
    options.stepping = stepping;
    options.time_step = 0.01;
    options.thresholds.t1_length = 0;
    options.equilibrator.tolerance = 1e-11;
    const auto coarsening = make_coarsening(options);
    coarsening->restart(start);
    EXPECT_TRUE(coarsening->advance({}));
    expect_equilibrium(coarsening->foam());
    return coarsening->foam();
  };
  const Foam expected = after_a_frame(Stepping::Events);
  const Foam foam = after_a_frame(Stepping::FixedSteps);
  ASSERT_TRUE(expected.half_bubble == start.half_bubble) << "no event";
  ASSERT_TRUE(foam.half_bubble == start.half_bubble);
  EXPECT_GT(std::abs(foam.energy() / start.energy() - 1), 1e-5);
  EXPECT_NEAR(foam.energy() / expected.energy(), 1, 1e-9);
  expect_same(foam, expected, 1e-9);
}

TEST_P(AnyTorus, BubblesAreShownInOnePieceInTheCell) {
  constexpr double kChordError = 1e-3;
  Foam start = disordered(GetParam(), 7);
  equilibrate(start);
  const auto coarsening = make_coarsening(thesis_options());
  coarsening->restart(start);
  for (int frame = 0; frame < 30; ++frame) {
    ASSERT_TRUE(coarsening->advance({}));
  }
  EXPECT_GT(coarsening->foam().t2_count, 3);
  for (const Basis& basis : {Basis{1, 0, 0, 1}, kBases[3]}) {
    const Foam foam = described_by(coarsening->foam(), basis);
    const Lattice& torus = foam.surroundings.lattice;
    const BubblePolygons bubbles = sample(foam, kChordError).bubbles;
    ASSERT_EQ(bubbles.each.size(), place_of(foam.bubble_count()));
    double total = 0;
    for (const Bubble b : foam.bubble_slots()) { // in the order of their ids
      std::vector<Vec2> outline;
      for (auto i = bubbles.offsets[b.place()]; i < bubbles.offsets[b.place() + 1]; ++i) {
        const Point3& p = bubbles.points[static_cast<std::size_t>(i)];
        outline.push_back({p[0], p[1]});
      }
      double shoelace = 0;
      double perimeter = 0;
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const Vec2 p = outline[i];
        const Vec2 q = outline[(i + 1) % outline.size()];
        shoelace += 0.5 * cross(p - outline[0], q - outline[0]);
        perimeter += norm(q - p);
      }
      ASSERT_EQ(bubbles.each[b.place()].id, foam.bubble_id[b]);
      EXPECT_NEAR(shoelace, foam.area(b), kChordError * perimeter);
      double expected_perimeter = 0;
      for_each_half(foam, b, [&](Half h) { expected_perimeter += foam.length(h); });
      EXPECT_NEAR(perimeter, expected_perimeter, 0.01 * perimeter);
      const Polygon whole{outline.data(), static_cast<Index>(outline.size()), 0};
      EXPECT_EQ(torus.cell_of(centroid(whole)), Wrap{});
      total += shoelace;
    }
    EXPECT_NEAR(total, torus.area(), 1e-9) << "what one bubble lacks its neighbour has";
  }
}

/// A film that leaves the cell ends a whole number of periods from its junction.
TEST_P(AnyTorus, FilmsAreShownFromJunctionToJunction) {
  const Foam foam = described_by(disordered(GetParam(), 7), kBases[1]);
  const FilmPolylines films = sample(foam, 1e-3).films;
  int crossing = 0;
  for (const Film f : foam.film_slots()) {
    const auto point = [&](std::int64_t entry) {
      const auto number = films.connectivity[static_cast<std::size_t>(entry)];
      const Point3& p = films.points[static_cast<std::size_t>(number)];
      return Vec2{p[0], p[1]};
    };
    const Half h = f.half();
    const Vec2 begin = point(films.offsets[f.place()]);
    const Vec2 end = point(films.offsets[f.place() + 1] - 1);
    EXPECT_EQ(begin, foam.position[foam.start(h)]);
    EXPECT_EQ(end, foam.position[foam.end(h)] + foam.surroundings.lattice.period(foam.wrap(h)));
    EXPECT_NEAR(norm(end - begin - foam.chord(h)), 0, 1e-12);
    crossing += foam.wrap(h) != Wrap{} ? 1 : 0;
  }
  EXPECT_GT(crossing, 10);
}

} // namespace
} // namespace foam::test
