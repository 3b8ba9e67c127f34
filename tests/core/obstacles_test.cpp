// SPDX-License-Identifier: GPL-3.0-or-later
//
// Obstacles that films come upon and leave.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "base/error.h"
#include "coarsening/coarsening.h"
#include "containers.h"
#include "engines/engines.h"
#include "foams.h"
#include "mesh/film_set.h"
#include "physics/gas.h"
#include "topology/wall_contact.h"

namespace foam::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// A square of side 1 with a disc on its diagonal.
Container square_with_disc(double place, double radius) {
  Container container = rectangle({0, 1, 0, 1}, WallContact::Slip);
  const double c = place;
  container.walls.push_back(
      annulus({c - 1, c + 1, c - 1, c + 1}, radius, WallContact::Slip).walls[1]);
  return container;
}

int hosted_walls(const Foam& foam) {
  int count = 0;
  for (const Exterior& wall : foam.exterior) {
    count += wall.host != kNone ? 1 : 0;
  }
  return count;
}

double area_of(const Foam& foam) {
  return sum(foam, [&](Bubble b) { return foam.area(b); });
}

double area_in(const Foam& foam) {
  double sum = 0;
  for (const Outside wall : foam.outside_slots()) {
    sum += foam.area_of_wall(wall);
  }
  return sum;
}

/// A film across the corner of the square, with the disc behind it in the corner's bubble.
Foam disc_in_corner(double place, double radius, double corner_area) {
  const double gas = 1 - kPi * radius * radius;
  return filled(square_with_disc(place, radius), {{0.2, 0.2}, {0.57, 0.57}},
                {corner_area, gas - corner_area});
}

/// Of the film across the corner, if it is the only one.
double radius_of_sector(const Foam& foam) {
  return foam.energy() / foam.reference_tension() / (0.5 * kPi);
}

TEST(Obstacles, LieInABubbleThatNoticesOnlyTheirArea) {
  const double radius = 0.05;
  const Foam foam = disc_in_corner(0.3, radius, 0.25);
  ASSERT_TRUE(foam.report.converged);
  ASSERT_EQ(hosted_walls(foam), 1);
  EXPECT_EQ(foam.bubble_id[foam.exterior[Outside(1)].host], 0);
  EXPECT_NEAR(radius_of_sector(foam), std::sqrt((0.25 + kPi * radius * radius) * 4 / kPi), 1e-12);
  EXPECT_NEAR(area_of(foam), area_in(foam), 1e-14);
}

// The bubble in the corner shrinks by 3K/2, its film a quarter of a circle, until that meets the
// disc; then the film ends on it and has a law of its own.
TEST(Obstacles, AFilmComesUponThemAtItsTime) {
  for (const double radius : {0.01, 0.05}) {
    SCOPED_TRACE(radius);
    const double disc = kPi * radius * radius;
    const Foam start = disc_in_corner(0.3, radius, 0.3);
    const double gas = area_of(start);
    CoarseningOptions options;
    options.permeability = 1;
    const double rate = -1.5 * von_neumann_constant(start.surface_tension, options.permeability);
    EXPECT_NEAR(area_rates(start, options.permeability)[Bubble(0)], rate, 1e-12);
    const double farthest = 0.3 * std::sqrt(2.0) + radius;
    const double time = (0.25 * kPi * farthest * farthest - disc - 0.3) / rate;
    constexpr int kFrames = 40;
    options.time_step = time / (kFrames + 1e-4);
    const auto coarsening = make_coarsening(options);
    coarsening->restart(start);
    for (int frame = 1; frame <= 2 * kFrames; ++frame) {
      ASSERT_TRUE(coarsening->advance({})) << frame;
      const Foam& foam = coarsening->foam();
      EXPECT_TRUE(foam.report.converged) << frame;
      expect_valid(foam);
      EXPECT_NEAR(area_of(foam), gas, 1e-12);
      ASSERT_EQ(hosted_walls(foam), frame <= kFrames ? 1 : 0) << frame;
      if (frame <= kFrames) {
        EXPECT_NEAR(foam.target_area[Bubble(0)], 0.3 + frame * options.time_step * rate, 1e-10);
      }
    }
  }
}

// A film across a channel is pushed over a disc in its middle: it touches it, straight, at its near
// side. The two films that it becomes meet the disc and the walls at right angles, and leave it
// when they meet behind it: quarters of circles by then, round points of the walls.
TEST(Obstacles, AFilmThatIsPushedOverThemLeavesThem) {
  const double radius = 0.06;
  const double place = 0.9;
  const double disc = kPi * radius * radius;
  const double touch = place - radius;
  const double leave = place + radius + 0.125 * kPi - disc;
  Container container = rectangle({0, 2, 0, 1}, WallContact::Slip);
  container.walls.push_back(
      annulus({place - 1, place + 1, -0.5, 1.5}, radius, WallContact::Slip).walls[1]);
  for (const bool forwards : {true, false}) {
    SCOPED_TRACE(forwards);
    const double total = 2 - disc;
    const auto from = [&](double area) { // of the bubble that the film comes from
      const double left = forwards ? area : total - area;
      return std::vector{left, total - left};
    };
    const double side = forwards ? place : 2 - place;
    if (!forwards) {
      container.walls[1] =
          annulus({side - 1, side + 1, -0.5, 1.5}, radius, WallContact::Slip).walls[1];
    }
    Foam foam = filled(container, {{forwards ? 0.3 : 0.7, 0.5}, {forwards ? 1.3 : 1.7, 0.5}},
                       from(touch - 0.1));
    ASSERT_EQ(hosted_walls(foam), 1);
    const auto push_to = [&](double area) {
      const std::vector<double> areas = from(area);
      foam.target_area.assign(areas.begin(), areas.end());
      EquilibratorOptions options;
      options.tolerance = 1e-13;
      const auto equilibrator = make_equilibrator(options);
      EXPECT_TRUE(equilibrator->equilibrate(foam, 1e-7, {}).converged) << area;
      expect_valid(foam);
    };
    const Bubble before(forwards ? 0 : 1);
    const Bubble behind(forwards ? 1 : 0);
    push_to(touch - 1e-9);
    EXPECT_EQ(foam.exterior[Outside(1)].host, behind);
    EXPECT_NEAR(foam.energy(), 1, 1e-12);
    push_to(touch + 1e-9);
    EXPECT_EQ(hosted_walls(foam), 0);
    constexpr int kSteps = 60;
    for (int k = 1; k < kSteps; ++k) {
      push_to(touch + (leave - touch) * k / kSteps);
      ASSERT_EQ(hosted_walls(foam), 0) << k;
    }
    push_to(leave - 1e-5);
    ASSERT_EQ(hosted_walls(foam), 0);
    EXPECT_NEAR(foam.energy(), 0.5 * kPi - 2e-5, 1e-8); // two quarters of radius 1/2, of pressure 2
    push_to(leave + 1e-5);
    EXPECT_EQ(foam.exterior[Outside(1)].host, before);
    EXPECT_NEAR(foam.energy(), 1, 1e-12);
    EXPECT_NEAR(area_of(foam), total, 1e-12);
    EXPECT_EQ(foam.t1_count, 2);
  }
}

TEST(Obstacles, AreKeptByAListOfFilms) {
  const Foam foam = disc_in_corner(0.3, 0.05, 0.25);
  const FilmSet list = film_set(foam);
  const Foam again = foam_of(list);
  EXPECT_EQ(film_set(again), list);
  EXPECT_EQ(again.exterior, foam.exterior);
  // A film that parts and one that leaves need room for what they make.
  Foam touched = again;
  const auto approach = nearest_film(touched, Outside(1));
  ASSERT_TRUE(approach);
  EXPECT_NEAR(approach->gap, radius_of_sector(foam) - (0.3 * std::sqrt(2.0) + 0.05), 1e-12);
  perform_touch(touched, *approach);
  expect_valid(touched);
  EXPECT_EQ(hosted_walls(touched), 0);
}

TEST(Obstacles, ThatLieInNoBubbleAreRefused) {
  FilmSet list = film_set(disc_in_corner(0.3, 0.05, 0.25));
  for (WallPiece& piece : list.wall_pieces) {
    if (piece.half_angle != 0) {
      piece.start += Vec2{5, 0};
    }
  }
  EXPECT_THROW(foam_of(list), FoamError);
}

// Small obstacles in the way of a foam that coarsens to its end, in events and in fixed steps.
TEST(Obstacles, KeepGasAndAreaWhateverComesUponThem) {
  int touched = 0;
  for (const Stepping stepping : {Stepping::Events, Stepping::FixedSteps}) {
    for (std::uint64_t seed = 1; seed <= 2; ++seed) {
      SCOPED_TRACE(seed);
      Container container = square_with_disc(0.3, 0.02);
      container.walls.push_back(square_with_disc(0.7, 0.01).walls[1]);
      container.walls.push_back(
          outline({{{{0, 0}, {1, 0}, {1, 1}, {0, 1}}, {{0.28, 0.7}, {0.32, 0.7}, {0.3, 0.73}}}},
                  WallContact::Slip)
              .walls[1]);
      Foam start = random_foam_in(container, 20, seed);
      ASSERT_TRUE(start.report.converged);
      const double gas = area_of(start);
      CoarseningOptions options;
      options.permeability = 1;
      options.stepping = stepping;
      options.time_step = 0.02 * start.mean_area();
      const auto coarsening = make_coarsening(options);
      coarsening->restart(start);
      int hosted = hosted_walls(start);
      for (int frame = 0; frame < 100 && coarsening->advance({}); ++frame) {
        const Foam& foam = coarsening->foam();
        EXPECT_TRUE(foam.report.converged) << frame;
        expect_valid(foam);
        EXPECT_NEAR(area_of(foam), gas, 1e-11);
        touched += std::max(hosted - hosted_walls(foam), 0);
        hosted = hosted_walls(foam);
      }
    }
  }
  EXPECT_GE(touched, 2);
}

} // namespace
} // namespace foam::test
