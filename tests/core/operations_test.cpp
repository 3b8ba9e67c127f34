// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/operations.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <functional>
#include <map>
#include <numbers>
#include <random>

#include "construct/jittered_grid.h"
#include "hand_made.h"
#include "mesh/element_measures.h"
#include "physics/swap_rule.h"

namespace foam {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kThird = 2 * kPi / 3; // 120°

Foam sample(Boundary boundary, Index n = 60, std::uint64_t seed = 1) {
  BuildOptions options;
  options.boundary = boundary;
  return build_from_points(jittered_grid(n, 1, 1, seed), options);
}

double total_area(const Foam& foam) {
  double sum = 0;
  for (const Bubble b : foam.bubble_slots()) {
    sum += foam.has_bubble(b) ? foam.area(b) : 0;
  }
  return sum;
}

double total_target(const Foam& foam) {
  double sum = 0;
  for (const Bubble b : foam.bubble_slots()) {
    sum += foam.has_bubble(b) ? foam.target_area[b] : 0;
  }
  return sum;
}

std::pair<Bubble, Bubble> unordered(Bubble a, Bubble b) {
  return {std::min(a, b), std::max(a, b)};
}

/// How many films each pair of bubbles shares.
std::map<std::pair<Bubble, Bubble>, int> contacts(const Foam& foam) {
  std::map<std::pair<Bubble, Bubble>, int> result;
  for (const Film f : foam.film_slots()) {
    if (foam.has_film(f)) {
      ++result[unordered(foam.left(f.half()), foam.right(f.half()))];
    }
  }
  return result;
}

/// Largest deviation from 120° between the films at a junction, rad.
double angle_error(const Foam& foam, Junction j) {
  double error = 0;
  for (const Half h : foam.junction_half[j]) {
    const double angle = angle_from_to(foam.tangent(h), foam.tangent(foam.next_around_junction(h)));
    error = std::max(error, std::abs(angle - kThird));
  }
  return error;
}

void expect_plateau(const Foam& foam) {
  for (const Junction j : foam.junction_slots()) {
    if (foam.has_junction(j)) {
      EXPECT_LT(angle_error(foam, j), 1e-9) << "junction " << j.index();
    }
  }
}

void expect_area_on_target(const Foam& foam) {
  for (const Bubble b : foam.bubble_slots()) {
    if (foam.has_bubble(b)) {
      EXPECT_NEAR(foam.target_area[b], foam.area(b), 1e-12);
    }
  }
}

void aim_at_areas(Foam& foam) {
  for (const Bubble b : foam.bubble_slots()) {
    foam.target_area[b] = foam.area(b);
  }
}

// Equilibria in closed form. A Möbius map takes circles to circles and keeps angles, so that it
// takes an equilibrium to another one, without symmetry.

struct Moebius {
  std::complex<double> pole_inverse; // w = z/(1 − c·z)

  Vec2 operator()(Vec2 p) const {
    const std::complex<double> z(p.x, p.y);
    const std::complex<double> w = z / (1.0 - pole_inverse * z);
    return {w.real(), w.imag()};
  }
};

FilmSet mapped(FilmSet set, const Moebius& map) {
  for (auto& film : set.films) {
    const Vec2 a = set.junctions[film.start];
    const Vec2 b = set.junctions[film.end];
    const Vec2 middle = map(arc_point(a, b - a, film.half_angle, 0.5));
    film.half_angle = angle_from_to(middle - map(a), map(b) - middle); // inscribed angle
  }
  std::ranges::transform(set.junctions, set.junctions.begin(), map);
  return set;
}

const Moebius kMap{{0.13, -0.21}};

Foam equilibrium(const FilmSet& set) {
  Foam foam = foam_of(set);
  aim_at_areas(foam);
  expect_plateau(foam);
  return foam;
}

Vec2 polar(double radius, double angle) {
  return {radius * std::cos(angle), radius * std::sin(angle)};
}

FilmSet free_set(std::size_t bubbles) {
  FilmSet set;
  set.surface_tension = 0.5;
  for (std::size_t b = 0; b < bubbles; ++b) {
    set.bubbles.push_back({static_cast<std::int64_t>(b), 0, 1});
  }
  return set;
}

/// Three equal bubbles: radial films to distance 1, semicircles outside.
FilmSet triple_bubble() {
  FilmSet set = free_set(3);
  set.junctions.push_back({0, 0});
  for (int k = 0; k < 3; ++k) {
    set.junctions.push_back(polar(1, k * kThird));
  }
  for (Index k = 0; k < 3; ++k) {
    set.films.push_back({0, 1 + k, k, (k + 2) % 3, 0, {}});
    set.films.push_back({1 + k, 1 + (k + 1) % 3, k, -1, kPi / 2, {}});
  }
  return set;
}

/// The same around a small bubble with corners at distance 0.3, whose sides have half-angle 30°.
FilmSet three_petals() {
  FilmSet set = free_set(4);
  for (int k = 0; k < 6; ++k) {
    set.junctions.push_back(polar(k < 3 ? 0.3 : 1.0, k * kThird));
  }
  for (Index k = 0; k < 3; ++k) {
    set.films.push_back({k, k + 3, k, (k + 2) % 3, 0, {}});
    set.films.push_back({k, (k + 1) % 3, 3, k, kPi / 6, {}});
    set.films.push_back({k + 3, 3 + (k + 1) % 3, k, -1, kPi / 2, {}});
  }
  return set;
}

/// Two equal bubbles with a straight film of length 2 between them and arcs of 240° outside.
FilmSet double_bubble() {
  FilmSet set = free_set(2);
  set.junctions = {{0, -1}, {0, 1}};
  set.films = {{0, 1, 0, 1, 0, {}}, {1, 0, 0, -1, kThird, {}}, {0, 1, 1, -1, kThird, {}}};
  return set;
}

/// The same with a lens on the film between them, from `low` to `high`; its sides have half-angle
/// 60°.
FilmSet double_bubble_with_lens(double low, double high) {
  FilmSet set = free_set(3);
  set.junctions = {{0, -1}, {0, 1}, {0, low}, {0, high}};
  set.films = {{0, 2, 0, 1, 0, {}},       {3, 1, 0, 1, 0, {}},       {1, 0, 0, -1, kThird, {}},
               {0, 1, 1, -1, kThird, {}}, {2, 3, 2, 1, kPi / 3, {}}, {3, 2, 2, 0, kPi / 3, {}}};
  return set;
}

class AnyBoundary : public testing::TestWithParam<Boundary> {};
INSTANTIATE_TEST_SUITE_P(Boundaries, AnyBoundary,
                         testing::Values(Boundary::Free, Boundary::Periodic, Boundary::Fixed));

TEST_P(AnyBoundary, T1ExchangesNeighbours) {
  const Foam before = sample(GetParam());
  Index performed = 0;
  for (const Film f : before.film_slots()) {
    if (!can_perform_t1(before, f)) {
      continue;
    }
    Foam foam = before;
    const Half h = f.half();
    const Bubble at_start = before.left(before.next_around_junction(h));
    const Bubble at_end = before.left(before.next_around_junction(h.twin()));
    const auto parted = perform_t1(foam, f);
    ++performed;
    expect_valid(foam);
    EXPECT_EQ(unordered(parted[0], parted[1]), unordered(before.left(h), before.right(h)));
    EXPECT_EQ(unordered(foam.left(h), foam.right(h)), unordered(at_start, at_end));
    for (const Bubble b : parted) {
      EXPECT_TRUE(b.is_outside() || foam.sides[b] == before.sides[b] - 1);
    }
    for (const Bubble b : {at_start, at_end}) {
      EXPECT_TRUE(b.is_outside() || foam.sides[b] == before.sides[b] + 1);
    }
    EXPECT_EQ(foam.t1_count, 1);
    EXPECT_GT(foam.topology, before.topology);
    EXPECT_EQ(foam.target_area, before.target_area);
    EXPECT_TRUE(foam.wall(h) || std::abs(norm(foam.chord(h)) - norm(before.chord(h))) < 1e-12);
  }
  EXPECT_GT(performed, 100);
}

TEST_P(AnyBoundary, T1TwiceReturnsToTheSameNeighbours) {
  const Foam before = sample(GetParam());
  for (const Film f : before.film_slots()) {
    Foam foam = before;
    if (!can_perform_t1(foam, f)) {
      continue;
    }
    perform_t1(foam, f);
    if (foam.wall(f.half())) {
      continue; // a piece of the wall does not swap back
    }
    ASSERT_TRUE(can_perform_t1(foam, f)) << f.index();
    perform_t1(foam, f);
    expect_valid(foam);
    EXPECT_EQ(foam.sides, before.sides);
    EXPECT_EQ(contacts(foam), contacts(before));
    EXPECT_EQ(foam.t1_count, 2);
  }
}

TEST(T1, NewFilmLiesAcrossTheOldOne) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic}) {
    const Foam before = sample(boundary);
    for (const Film f : before.film_slots()) {
      Foam foam = before;
      if (!can_perform_t1(foam, f)) {
        continue;
      }
      const Junction j = foam.start(f.half());
      const Vec2 middle = foam.position[j] + 0.5 * foam.chord(f.half());
      perform_t1(foam, f);
      EXPECT_NEAR(dot(foam.chord(f.half()), before.chord(f.half())), 0, 1e-12);
      EXPECT_NEAR(norm(foam.position[j] + 0.5 * foam.chord(f.half()) - middle), 0, 1e-12);
    }
  }
}

TEST(T1, NewFilmHasTheCurvatureOfItsPressures) {
  Foam foam = honeycomb(4, 2);
  for (const Bubble b : foam.bubble_slots()) {
    foam.pressure[b] = 0.02 * (b.index() % 5);
  }
  const Film f(17);
  perform_t1(foam, f);
  const double q = foam.pressure_difference(f.half());
  EXPECT_NE(q, 0);
  // Laplace and Young: the pressure difference is 2γ times the curvature.
  const double curvature = arc_curvature(norm(foam.chord(f.half())), foam.half_angle(f.half()));
  EXPECT_NEAR(foam.reference_tension() * curvature, q, 1e-15);
}

TEST(T1, KeepsTheContainer) {
  const Foam before = sample(Boundary::Fixed);
  Index at_wall = 0;
  for (const Film f : before.film_slots()) {
    Foam foam = before;
    if (foam.wall(f.half())) {
      EXPECT_FALSE(can_perform_t1(foam, f));
    } else if (can_perform_t1(foam, f)) {
      perform_t1(foam, f);
      if (foam.wall(f.half())) {
        ++at_wall;
        EXPECT_EQ(foam.half_angle(f.half()), 0);
        EXPECT_NEAR(total_area(foam), total_area(before), 1e-12 * total_area(before));
      }
    }
  }
  EXPECT_GT(at_wall, 10);
}

TEST(T1, IsRefusedWhereABubbleWouldLoseItsLastTwoSides) {
  const Foam triple = foam_of(triple_bubble());
  for (const Film f : triple.film_slots()) {
    EXPECT_EQ(can_perform_t1(triple, f), true) << "three sides can spare one";
  }
  const Foam two = foam_of(double_bubble());
  for (const Film f : two.film_slots()) {
    EXPECT_FALSE(can_perform_t1(two, f));
  }
}

TEST(T2, OfAnEquilibriumLeavesAnEquilibrium) {
  // The decoration theorem, for a bubble inside.
  for (const Moebius& map : {Moebius{}, kMap}) {
    Foam foam = equilibrium(mapped(three_petals(), map));
    const double area = total_area(foam);
    ASSERT_TRUE(can_perform_t2(foam, Bubble(3)));
    const T2Result result = perform_t2(foam, Bubble(3));
    expect_valid(foam);
    expect_plateau(foam);
    expect_area_on_target(foam);
    EXPECT_NEAR(total_area(foam), area, 1e-12) << "the outside has not changed";
    EXPECT_FALSE(foam.has_bubble(Bubble(3)));
    EXPECT_EQ(foam.t2_count, 1);

    const Foam expected = foam_of(mapped(triple_bubble(), map));
    for (const Bubble b : Slots<Bubble>(3)) {
      EXPECT_NEAR(foam.area(b), expected.area(b), 1e-12);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const Junction j = foam.start(result.films[k].half());
      EXPECT_EQ(j, foam.start(result.films[0].half()));
      EXPECT_NEAR(norm(foam.position[j]), 0, 1e-12) << "the map keeps the origin";
      EXPECT_NE(std::ranges::find(result.bubbles, Bubble(static_cast<Index>(k))),
                result.bubbles.end());
    }
  }
}

TEST(T2, OfAnEquilibriumOnTheBoundaryLeavesAnEquilibrium) {
  // A triple bubble without one of its three is a double bubble.
  for (const Moebius& map : {Moebius{}, kMap}) {
    Foam foam = equilibrium(mapped(triple_bubble(), map));
    ASSERT_TRUE(can_perform_t2(foam, Bubble(1)));
    perform_t2(foam, Bubble(1));
    expect_valid(foam);
    expect_plateau(foam);
    expect_area_on_target(foam);
    EXPECT_EQ(foam.bubble_count(), 2);
  }
  Foam foam = equilibrium(triple_bubble());
  perform_t2(foam, Bubble(1));
  const double radius = std::sqrt(3.0) / 2; // of the semicircles
  const double area = radius * radius * (kThird + std::sqrt(3.0) / 4);
  EXPECT_NEAR(foam.area(Bubble(0)), area, 1e-12);
  EXPECT_NEAR(foam.area(Bubble(2)), area, 1e-12);
}

TEST(T2, SharesOutWhatABubbleLackedOfItsTarget) {
  Foam foam = equilibrium(three_petals());
  foam.target_area[Bubble(3)] *= 0.5;
  const double total = total_target(foam);
  perform_t2(foam, Bubble(3));
  EXPECT_NEAR(total_target(foam), total, 1e-12);
}

TEST(T2, IsRefusedWhereANeighbourWouldBeLeftWithOneSide) {
  const Foam foam = foam_of(mapped(double_bubble_with_lens(-0.2, 0.3), kMap));
  for (const Bubble b : foam.bubble_slots()) {
    EXPECT_FALSE(can_perform_t2(foam, b));
  }
  EXPECT_FALSE(can_perform_t2(honeycomb(4, 2), Bubble(0))) << "six sides";
}

TEST(T3, OfAnEquilibriumLeavesAnEquilibrium) {
  for (const Moebius& map : {Moebius{}, kMap}) {
    Foam foam = equilibrium(mapped(double_bubble_with_lens(-0.2, 0.5), map));
    const double area = total_area(foam);
    ASSERT_TRUE(can_perform_t3(foam, Bubble(2)));
    const auto neighbours = perform_t3(foam, Bubble(2));
    EXPECT_EQ(unordered(neighbours[0], neighbours[1]), std::pair(Bubble(0), Bubble(1)));
    expect_valid(foam);
    expect_plateau(foam);
    expect_area_on_target(foam);
    EXPECT_NEAR(total_area(foam), area, 1e-12);
    EXPECT_EQ(foam.t3_count, 1);
    const Foam expected = foam_of(mapped(double_bubble(), map));
    EXPECT_NEAR(foam.area(Bubble(0)), expected.area(Bubble(0)), 1e-12);
    EXPECT_NEAR(foam.area(Bubble(1)), expected.area(Bubble(1)), 1e-12);
    EXPECT_NEAR(foam.energy(), expected.energy(), 1e-12);
  }
}

TEST(T3, OfALensOnTheBoundaryLeavesTheOuterArcWhole) {
  // A lens on the outer film of a double bubble; the film is an arc of 240° about (1/√3, 0).
  FilmSet set = double_bubble();
  set.bubbles.push_back({2, 0, 1});
  const double radius = 2 / std::sqrt(3.0);
  const double from = -0.4;
  const double to = 0.1;
  const Vec2 centre{1 / std::sqrt(3.0), 0};
  set.junctions.push_back(centre + polar(radius, from));
  set.junctions.push_back(centre + polar(radius, to));
  const double delta = 0.5 * (to - from);
  set.films[2] = {0, 2, 1, -1, 0.5 * (from + kThird), {}};
  set.films.push_back({3, 1, 1, -1, 0.5 * (kThird - to), {}});
  set.films.push_back({2, 3, 2, -1, delta + kPi / 3, {}});
  set.films.push_back({3, 2, 2, 1, kPi / 3 - delta, {}});
  Foam foam = equilibrium(set);
  ASSERT_TRUE(can_perform_t3(foam, Bubble(2)));
  perform_t3(foam, Bubble(2));
  expect_valid(foam);
  expect_plateau(foam);
  const Foam expected = foam_of(double_bubble());
  EXPECT_NEAR(foam.area(Bubble(1)), expected.area(Bubble(1)), 1e-12);
  EXPECT_NEAR(foam.target_area[Bubble(1)], expected.area(Bubble(1)), 1e-12);
}

TEST(T3, IsRefusedForTheBubblesOfADoubleBubble) {
  const Foam foam = foam_of(double_bubble());
  EXPECT_FALSE(can_perform_t3(foam, Bubble(0)));
  EXPECT_FALSE(can_perform_t3(foam, Bubble(1)));
  EXPECT_FALSE(can_perform_t3(foam_of(triple_bubble()), Bubble(0))) << "three sides";
}

TEST(Slide, KeepsTheEquilibriumAndTheLens) {
  for (const Moebius& map : {Moebius{}, kMap}) {
    for (const auto& [low, high] : {std::pair(-0.3, 0.5), std::pair(-0.5, 0.1)}) {
      Foam foam = equilibrium(mapped(double_bubble_with_lens(low, high), map));
      const Bubble lens(2);
      const Half lower = Film(0).half();
      const Half upper = Film(1).half();
      const Half side = Film(4).half();
      const bool up = foam.length(upper) < foam.length(lower);
      const Half ahead = up ? upper : lower;
      const Half behind = up ? lower : upper;
      const double chord = norm(foam.chord(side));
      const double area = foam.area(lens);
      const double path = arc_curvature(norm(foam.chord(ahead)), foam.half_angle(ahead));
      slide_two_sided_bubble(foam, lens, 0.05);
      expect_valid(foam);
      expect_plateau(foam);
      EXPECT_NEAR(foam.length(ahead), 0.05, 1e-12);
      EXPECT_NEAR(norm(foam.chord(side)), chord, 1e-12);
      EXPECT_NEAR(foam.area(lens), area, 1e-12);
      for (const Half h : {ahead, behind}) {
        EXPECT_NEAR(arc_curvature(norm(foam.chord(h)), foam.half_angle(h)), path, 1e-10);
      }
      const FilmSet there = film_set(foam);
      slide_two_sided_bubble(foam, lens, 0.05);
      EXPECT_LT(norm(foam.position[Junction(2)] - there.junctions[2]), 1e-12)
          << "close enough already";
      slide_two_sided_bubble(foam, lens, 0.2);
      EXPECT_LT(norm(foam.position[Junction(2)] - there.junctions[2]), 1e-12) << "never backwards";
    }
  }
}

/// The tensions of a foam's films are their own from now on, all equal at first.
void give_tensions(Foam& foam) {
  foam.film_tension.assign(foam.film_angle.size(), foam.reference_tension());
}

/// A film of length 1, film 0, between a bubble on either side and one at either end; the four
/// films that end in it are straight and leave it at 130° on both sides. Tension 0.5.
struct ShortFilm {
  static constexpr double kAngle = 50 * kPi / 180; // between the film's line and the other four
  Foam foam = foam_of_polygons({{-0.5, 0},
                                {0.5, 0},
                                Vec2{-0.5, 0} + polar(2, kPi - kAngle),
                                Vec2{-0.5, 0} + polar(2, kPi + kAngle),
                                Vec2{0.5, 0} + polar(2, -kAngle),
                                Vec2{0.5, 0} + polar(2, kAngle)},
                               {{2, 3, 0}, {1, 4, 5}, {2, 0, 1, 5}, {3, 4, 1, 0}});
  Film film{0};

  ShortFilm() { give_tensions(foam); }

  /// Of the film from one junction to another, N/cm.
  double& tension(Index from, Index to) {
    for (const Half h : foam.half_slots()) {
      if (foam.start(h) == Junction(from) && foam.end(h) == Junction(to)) {
        return foam.film_tension[h.film()];
      }
    }
    throw std::out_of_range("no such film");
  }
};

TEST(OwnTensions, PullAFilmShutThatTheyOvercome) {
  // Two films of tension 0.5 pull across with 2·0.5·sin 50° = 0.766.
  ShortFilm s;
  EXPECT_TRUE(unstable_to_t1(s.foam, s.film));
  s.tension(0, 1) = 0.76;
  EXPECT_TRUE(unstable_to_t1(s.foam, s.film));
  s.tension(0, 1) = 0.77;
  EXPECT_FALSE(unstable_to_t1(s.foam, s.film));
}

TEST(OwnTensions, PullAFilmShutHarderAcrossThanAlong) {
  // With t for the two films below, 2t·sin 50° across, on the weaker side, and
  // √((0.5 + t)²·cos² 50° + (0.5 − t)²·sin² 50°) along are equal at t = 0.371.
  ShortFilm s;
  s.tension(0, 1) = 0.1;
  s.tension(0, 3) = s.tension(1, 4) = 0.38;
  EXPECT_TRUE(unstable_to_t1(s.foam, s.film));
  s.tension(0, 3) = s.tension(1, 4) = 0.36;
  EXPECT_FALSE(unstable_to_t1(s.foam, s.film));
}

TEST(OwnTensions, ThatAreAllTheSameChangeNothing) {
  const Foam uniform = sample(Boundary::Periodic);
  Foam own = uniform;
  give_tensions(own);
  for (const Film f : uniform.film_slots()) {
    EXPECT_EQ(unstable_to_t1(own, f), unstable_to_t1(uniform, f));
    EXPECT_EQ(can_perform_t1(own, f), can_perform_t1(uniform, f));
  }
}

TEST(T1, IsRefusedWhereAJunctionCouldNotHoldItsTensions) {
  ShortFilm s;
  ASSERT_TRUE(can_perform_t1(s.foam, s.film));
  s.tension(0, 2) = 0.99;
  EXPECT_TRUE(can_perform_t1(s.foam, s.film));
  s.tension(0, 2) = 1.01; // beside the film and another one, of 0.5
  EXPECT_FALSE(can_perform_t1(s.foam, s.film));
  s.tension(0, 1) = 0.6;
  EXPECT_TRUE(can_perform_t1(s.foam, s.film));
  s.tension(0, 1) = 1.6; // what the film itself pulls with is too much for two of 0.5
  EXPECT_FALSE(can_perform_t1(s.foam, s.film));
}

TEST(T1, NewFilmKeepsItsTensionAndIsCurvedByIt) {
  Foam foam = honeycomb(4, 2);
  give_tensions(foam);
  for (const Bubble b : foam.bubble_slots()) {
    foam.pressure[b] = 0.02 * (b.index() % 5);
  }
  const Film f(17);
  foam.film_tension[f] = 0.8;
  const Field<Film, double> tensions = foam.film_tension;
  perform_t1(foam, f);
  EXPECT_EQ(foam.film_tension, tensions);
  const double curvature = arc_curvature(norm(foam.chord(f.half())), foam.half_angle(f.half()));
  EXPECT_NEAR(0.8 * curvature, foam.pressure_difference(f.half()), 1e-15);
  EXPECT_NE(curvature, 0);
}

/// Three petals whose inner bubble is turned, so that the arcs of the other films do not meet.
Foam turned_petals(double turn) {
  FilmSet set = three_petals();
  for (std::size_t k = 0; k < 3; ++k) {
    set.junctions[k] = polar(0.3, static_cast<double>(k) * kThird + turn);
  }
  Foam foam = foam_of(set);
  aim_at_areas(foam);
  give_tensions(foam);
  return foam;
}

TEST(T2, WhereArcsDoNotMeetKeepsTheGas) {
  for (const double turn : {0.05, -0.4, 0.9}) {
    Foam foam = turned_petals(turn);
    foam.film_tension[Film(0)] = 1.2; // a spoke
    const double area = total_area(foam);
    ASSERT_TRUE(can_perform_t2(foam, Bubble(3)));
    const T2Result result = perform_t2(foam, Bubble(3));
    expect_valid(foam);
    EXPECT_TRUE(validate_geometry(foam).empty());
    expect_area_on_target(foam);
    EXPECT_NEAR(total_area(foam), area, 1e-12);
    EXPECT_EQ(foam.film_tension[Film(0)], 1.2);
    EXPECT_LT(norm(foam.position[foam.start(result.films[0].half())]), 0.3);
  }
}

TEST(T2, IsRefusedWhereAJunctionCouldNotHoldItsTensions) {
  Foam foam = turned_petals(0);
  foam.film_tension[Film(0)] = 1.99; // beside the other two, of 1
  EXPECT_TRUE(can_perform_t2(foam, Bubble(3)));
  foam.film_tension[Film(0)] = 2.01;
  EXPECT_FALSE(can_perform_t2(foam, Bubble(3)));
}

TEST(T3, KeepsTheTensionOfTheFilmThatRemains) {
  Foam foam = equilibrium(mapped(double_bubble_with_lens(-0.2, 0.5), kMap));
  give_tensions(foam);
  const Bubble lens(2);
  const Half h = foam.bubble_half[lens];
  const Film remains = foam.previous_around_junction(h).film();
  const Film goes = foam.previous_around_junction(foam.next_in_bubble(h)).film();
  foam.film_tension[remains] = 2.01; // it would end between two films of 1
  EXPECT_FALSE(can_perform_t3(foam, lens));
  foam.film_tension[goes] = 2.01; // and now that one does
  foam.film_tension[remains] = 1.99;
  ASSERT_TRUE(can_perform_t3(foam, lens));
  perform_t3(foam, lens);
  expect_valid(foam);
  expect_area_on_target(foam);
  EXPECT_TRUE(foam.has_film(remains));
  EXPECT_FALSE(foam.has_film(goes));
  EXPECT_EQ(foam.film_tension[remains], 1.99);
}

/// Performs operations at random, as many as there are T1s to do, and calls check after each.
class RandomOperations {
public:
  RandomOperations(Foam foam, unsigned seed) : foam_(std::move(foam)), random_(seed) {}

  void run(int t1s, const std::function<void(const Foam&)>& check) {
    for (int i = 0; i < t1s; ++i) {
      const Film f(static_cast<Index>(random_() % place_of(foam_.film_slots().size())));
      if (!can_perform_t1(foam_, f)) {
        continue;
      }
      const auto parted = perform_t1(foam_, f);
      check(foam_);
      for (const Bubble b : parted) {
        if (b.is_outside() || foam_.bubble_count() < 6) {
          continue;
        }
        if (can_perform_t3(foam_, b)) {
          perform_t3(foam_, b);
          check(foam_);
        } else if (can_perform_t2(foam_, b) && random_() % 3 == 0) {
          perform_t2(foam_, b);
          check(foam_);
        }
      }
    }
  }

  const Foam& foam() const { return foam_; }

private:
  Foam foam_;
  std::mt19937 random_;
};

TEST_P(AnyBoundary, RandomOperationsKeepTheMeshValid) {
  std::int64_t t1 = 0;
  std::int64_t t2 = 0;
  std::int64_t t3 = 0;
  for (const Index n : {3, 4, 8, 30, 100}) {
    for (unsigned seed = 1; seed <= 5; ++seed) {
      SCOPED_TRACE(testing::Message() << n << " bubbles, seed " << seed);
      RandomOperations operations(sample(GetParam(), n, seed), seed);
      operations.run(400, [](const Foam& foam) {
        ASSERT_TRUE(validate(foam).empty()) << validate(foam).front();
        for (const Film f : foam.film_slots()) {
          ASSERT_TRUE(!foam.has_film(f) || (std::isfinite(norm(foam.chord(f.half()))) &&
                                            std::abs(foam.half_angle(f.half())) < kPi));
        }
      });
      t1 += operations.foam().t1_count;
      t2 += operations.foam().t2_count;
      t3 += operations.foam().t3_count;
    }
  }
  EXPECT_GT(t1, 1000);
  EXPECT_GT(t2, 50);
  EXPECT_GT(t3, 20);
}

/// Tensions of 1.8 and, where no two of them meet, 0.8: two of these cannot hold one of those.
void give_strong_and_weak_tensions(Foam& foam) {
  foam.film_tension.assign(foam.film_angle.size(), 1.8);
  Field<Junction, char> weak(foam.position.size(), 0);
  for (const Film f : foam.film_slots()) {
    char& at_start = weak[foam.start(f.half())];
    char& at_end = weak[foam.end(f.half())];
    if (at_start == 0 && at_end == 0) {
      at_start = at_end = 1;
      foam.film_tension[f] = 0.8;
    }
  }
}

TEST_P(AnyBoundary, RandomOperationsLeaveNoJunctionThatCannotHoldItsTensions) {
  for (unsigned seed = 1; seed <= 3; ++seed) {
    Foam start = sample(GetParam(), 60, seed);
    give_strong_and_weak_tensions(start);
    RandomOperations operations(start, seed);
    operations.run(400, [](const Foam& foam) {
      ASSERT_TRUE(validate(foam).empty()) << validate(foam).front();
      for (const Junction j : foam.junction_slots()) {
        ASSERT_TRUE(!foam.moves(j) || can_balance(tensions_at(foam, j))) << j.index();
      }
    });
    EXPECT_GT(operations.foam().t1_count, 50);
    EXPECT_GT(operations.foam().t2_count + operations.foam().t3_count, 3);
  }
}

TEST(Operations, OnATorusAreaAndGasAreConserved) {
  for (unsigned seed = 1; seed <= 5; ++seed) {
    const Foam start = sample(Boundary::Periodic, 50, seed);
    const double box = start.surroundings.lattice.area();
    RandomOperations operations(start, seed);
    operations.run(300, [&](const Foam& foam) {
      ASSERT_NEAR(total_area(foam), box, 1e-9 * box);
      ASSERT_NEAR(total_target(foam), box, 1e-9 * box);
    });
    EXPECT_GT(operations.foam().t2_count + operations.foam().t3_count, 10);
  }
}

} // namespace
} // namespace foam
