// SPDX-License-Identifier: GPL-3.0-or-later
// Foams in containers, on whose walls films slide: against closed forms and symmetries.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

#include "../staircase.h"
#include "construct/containers.h"
#include "containers.h"
#include "engines/engines.h"
#include "foams.h"
#include "physics/gas.h"
#include "reference.h"
#include "statistics/wall_forces.h"

namespace foam::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// With films swapped only where they are about to vanish.
void follow(Foam& foam) {
  EquilibratorOptions options;
  options.tolerance = 1e-12;
  make_equilibrator(options)->equilibrate(foam, 1e-4 * foam.mean_spacing(), {});
  expect_valid(foam);
  expect_equilibrium(foam);
}

/// Of the line tension 1, in equilibrium: films in a container.
Foam between_walls(FilmSet set, const Container& container) {
  set.surroundings.lattice.first.x = container.period;
  set.surroundings.boundary = Boundary::Container;
  set.surface_tension = 0.5;
  for (const Wall& wall : container.walls) {
    set.exteriors.push_back({.kind = Exterior::Kind::Solid,
                             .contact = wall.contact,
                             .first_piece = static_cast<Index>(set.wall_pieces.size()),
                             .pieces = static_cast<Index>(wall.pieces.size())});
    set.wall_pieces.insert(set.wall_pieces.end(), wall.pieces.begin(), wall.pieces.end());
  }
  Foam foam = foam_of(set);
  follow(foam);
  return foam;
}

// All with the line tension 2γ = 1.

TEST(Walls, BubblesInACornerAreSectors) {
  for (const double angle : {0.25 * kPi, 0.5 * kPi, kPi / 3}) {
    // A triangle with the corner at the origin, of which a bubble of area 0.1 cuts it off.
    const std::vector<Vec2> corners{{0, 0}, {4, 0}, rotated({4, 0}, angle)};
    const double area = 0.5 * 16 * std::sin(angle);
    const Vec2 towards = rotated({1, 0}, 0.5 * angle);
    Foam foam = filled(outline({{corners}}, WallContact::Slip), {0.2 * towards, 1.5 * towards},
                       {0.1, area - 0.1});
    expect_equilibrium(foam);
    EXPECT_NEAR(foam.energy(), std::sqrt(2 * angle * 0.1), 1e-10);
  }
}

TEST(Walls, ABubbleOnAStraightWallIsHalfADisc) {
  FilmSet set;
  set.junctions = {{-0.7, 0}, {0.8, 0}};
  set.films = {{1, 0, 0, 1, 1.2, {}}, {0, 1, 0, -1, 0, {}}, {1, 0, 1, -1, 0, {}}};
  set.bubbles = {{0, 0, 1}, {1, 0, 99}};
  const Foam foam = between_walls(set, rectangle({-5, 5, 0, 10}, WallContact::Slip));
  EXPECT_NEAR(foam.energy(), 2.506628274631, 1e-10);
}

TEST(Walls, OneFilmAcrossADisc) {
  struct Row {
    double fraction, length, pressure;
  };
  for (const auto& [fraction, length, pressure] :
       {Row{0.1, 1.241110322779, 1.655718681022}, Row{1.0 / 3, 1.893825250731, 0.419220584497}}) {
    Foam foam = filled(disc({-1, 1, -1, 1}, WallContact::Slip), {{-0.8, 0.1}, {0.1, 0}},
                       {fraction * kPi, (1 - fraction) * kPi});
    expect_equilibrium(foam);
    EXPECT_NEAR(foam.energy(), length, 1e-10);
    EXPECT_NEAR(foam.pressure[Bubble(0)] - foam.pressure[Bubble(1)], pressure, 1e-10);
  }
}

/// Two bubbles side by side on the lower wall of a rectangle, and a large one around them.
Foam two_on_a_wall(double first, double second) {
  FilmSet set;
  set.junctions = {{-1.2, 0}, {0, 0}, {1.2, 0}, {0, 0.8}};
  set.films = {{0, 3, 2, 0, -0.4, {}}, {1, 3, 0, 1, 0, {}},  {2, 3, 1, 2, 0.4, {}},
               {0, 1, 0, -1, 0, {}},   {1, 2, 1, -1, 0, {}}, {2, 0, 2, -1, 0, {}}};
  set.bubbles = {{0, 0, first}, {1, 0, second}, {2, 0, 100 - first - second}};
  return between_walls(set, rectangle({-5, 5, 0, 10}, WallContact::Slip));
}

TEST(Walls, TwoBubblesSideBySideAreHalfOfADoubleBubble) {
  Foam equal = two_on_a_wall(1, 1);
  EXPECT_NEAR(equal.energy(), 6.359129253960 / std::sqrt(2), 1e-10);
  const auto rows = read_csv("double_bubble_unequal.csv");
  ASSERT_FALSE(rows.empty());
  for (const auto& row : rows) {
    const double a = number(row, "A1") / 2;
    const double b = number(row, "A2") / 2;
    if (std::min(a, b) > 0.05) {
      const Foam foam = two_on_a_wall(a, b);
      expect_equilibrium(foam);
      EXPECT_NEAR(foam.energy(), number(row, "P_line_tension_1") / 2, 1e-10) << a << ' ' << b;
    }
  }
}

/// Bubbles of area 1 in a row of the given width each on the lower wall of a rectangle, with one
/// large bubble above, which has the pressure of a gas. The side walls cut the row in the middle of
/// bubbles, where by symmetry it goes on for ever.
Foam row_on_a_wall(double width) {
  const int whole = 3;
  const double length = (whole + 1) * width;
  std::vector<Vec2> points{{0.2 * width, 0.4}};
  for (int k = 1; k <= whole; ++k) {
    points.push_back({k * width, 0.4});
  }
  points.push_back({length - 0.2 * width, 0.4});
  points.push_back({0.5 * length, 2.2});
  const double height = 3;
  std::vector<double> areas(points.size(), 1);
  areas[0] = areas[whole + 1] = 0.5;
  areas.back() = length * height - (whole + 1);
  return filled(rectangle({0, length, 0, height}, WallContact::Slip), points, areas);
}

/// How far the films of a row on a wall pull its middle planes together: their tension, less the
/// excess pressure as high as the row is there.
double pull_along_row(const Foam& foam) {
  double height = 0;
  for (const Junction j : foam.junction_slots()) {
    if (foam.has_junction(j) && foam.on_wall(j) && foam.position[j].x < 1e-9) {
      height = std::max(height, foam.position[j].y);
    }
  }
  return 1 - (foam.pressure[Bubble(0)] - foam.pressure[Bubble(foam.bubble_slots().size() - 1)]) *
                 height;
}

TEST(Walls, ARowOfBubblesOnAWall) {
  const Foam row = row_on_a_wall(1);
  expect_equilibrium(row);
  const Bubble above(5);
  for (Index b = 0; b < 5; ++b) {
    EXPECT_NEAR(row.pressure[Bubble(b)] - row.pressure[above], 1, 1e-10);
  }
  EXPECT_NEAR(row.energy(), 4 * 1.956611477491, 1e-10);
  int upright = 0;
  for (const Film f : row.film_slots()) {
    if (row.has_film(f) && !row.wall(f.half()) && row.left(f.half()) != above &&
        row.right(f.half()) != above) {
      EXPECT_NEAR(row.length(f.half()), 0.909413926294, 1e-10);
      ++upright;
    }
  }
  EXPECT_EQ(upright, 4);

  const double best = 1 / std::sqrt(kPi / 6 + std::sqrt(3) / 4);
  EXPECT_NEAR(best, 1.022426756718, 1e-12);
  const Foam relaxed = row_on_a_wall(best);
  expect_equilibrium(relaxed);
  EXPECT_NEAR(relaxed.energy(), 4 * 1.956130340740, 1e-10);
  EXPECT_NEAR(pull_along_row(relaxed), 0, 1e-10);
  EXPECT_GT(row_on_a_wall(best * 1.01).energy(), relaxed.energy());
  EXPECT_GT(row_on_a_wall(best / 1.01).energy(), relaxed.energy());
}

TEST(Walls, RadialFilmsOfAnAnnulus) {
  std::vector<Vec2> points;
  const int n = 7;
  for (int k = 0; k < n; ++k) {
    points.push_back(rotated({1.5, 0}, 2 * kPi * k / n));
  }
  Foam foam = filled(annulus({-2, 2, -2, 2}, 1, WallContact::Slip), points,
                     std::vector<double>(n, 3 * kPi / n));
  expect_equilibrium(foam);
  EXPECT_NEAR(foam.energy(), n, 1e-10);
  EXPECT_LT(std::ranges::max(foam.pressure) - std::ranges::min(foam.pressure), 1e-10);
}

TEST(Walls, BambooAndStaircase) {
  // Six bubbles of unit height, straight across the channel.
  std::vector<Vec2> row;
  for (int k = 0; k < 6; ++k) {
    row.push_back({k + 0.5, 0.5 + 0.01 * k});
  }
  Foam bamboo = filled(channel({0, 6, 0, 1}, WallContact::Slip), row, {1, 0.5, 1.5, 1.2, 0.8, 1});
  expect_equilibrium(bamboo);
  EXPECT_NEAR(bamboo.energy(), 6, 1e-10);
  for (const double rate : area_rates(bamboo, 1)) {
    EXPECT_NEAR(rate, 0, 1e-9);
  }

  std::vector<Vec2> double_row;
  for (int k = 0; k < 6; ++k) {
    double_row.push_back({k * 0.5 + 0.25, k % 2 == 0 ? 0.2 : 0.8});
  }
  Foam stairs =
      filled(channel({0, 3, 0, 1}, WallContact::Slip), double_row, std::vector<double>(6, 0.5));
  expect_equilibrium(stairs);
  EXPECT_NEAR(stairs.energy(), 6 * 0.933012701892, 1e-9);
}

TEST(Walls, AStaircaseIsInEquilibriumAsItIsBuilt) {
  for (const double area : {0.1, 0.5, 1.0, 1.7}) {
    Foam foam = staircase(3, 1, area);
    expect_valid(foam);
    const FilmSet before = film_set(foam);
    equilibrate(foam, 1e-12);
    expect_equilibrium(foam);
    EXPECT_NEAR(foam.energy(), 6 * (0.5 + 0.5 * std::sqrt(3.0) * area), 1e-12) << area;
    for (std::size_t j = 0; j < before.junctions.size(); ++j) {
      EXPECT_LT(norm(film_set(foam).junctions[j] - before.junctions[j]), 1e-12);
    }
  }
}

/// The same channel, narrower by a factor and so much longer, not in equilibrium.
Foam narrowed(const Foam& foam, double factor) {
  const auto map = [&](Vec2 p) { return Vec2{p.x * factor, p.y / factor}; };
  FilmSet set = film_set(foam);
  std::ranges::transform(set.junctions, set.junctions.begin(), map);
  for (WallPiece& piece : set.wall_pieces) {
    piece = {map(piece.start), map(piece.chord), piece.half_angle};
  }
  Lattice& lattice = set.surroundings.lattice;
  lattice = {map(lattice.origin), map(lattice.first), {}};
  return foam_of(set);
}

/// A double row in a channel of width W is stretched until its films to the walls, of length W/2 −
/// A/(2√3 W), vanish, and the films become bamboo, which stays when all is pushed back, although
/// below A/W² = 1/√3 it has the greater energy.
TEST(Walls, TheDoubleRowBecomesBambooAndDoesNotComeBack) {
  constexpr double kArea = 0.5;
  constexpr int kBubbles = 6;
  const double limit = std::sqrt(3);
  const double crossing = 1 / std::sqrt(3);
  std::vector<Vec2> points;
  for (int k = 0; k < kBubbles; ++k) {
    points.push_back({k * 0.5 + 0.25, k % 2 == 0 ? 0.2 : 0.8});
  }
  Foam foam = filled(channel({0, 3, 0, 1}, WallContact::Slip), points,
                     std::vector<double>(kBubbles, kArea));
  double ratio = kArea; // A/W²
  const auto go_to = [&](double next) {
    foam = narrowed(foam, std::sqrt(next / ratio));
    ratio = next;
    follow(foam);
    return std::sqrt(kArea / ratio); // the width
  };
  const auto expect_double_row = [&](double width) {
    EXPECT_EQ(foam.t1_count, 0) << ratio;
    EXPECT_NEAR(foam.energy(), kBubbles * (width / 2 + std::sqrt(3) / 2 * kArea / width), 1e-10)
        << ratio;
    EXPECT_LT(std::ranges::max(foam.pressure) - std::ranges::min(foam.pressure), 1e-9) << ratio;
    for (const Film f : foam.film_slots()) {
      const Half h = f.half();
      if (!foam.wall(h)) {
        const bool to_wall = foam.on_wall(foam.start(h)) || foam.on_wall(foam.end(h));
        const double zigzag = 2 * kArea / (std::sqrt(3) * width);
        EXPECT_NEAR(foam.length(h), to_wall ? width / 2 - zigzag / 4 : zigzag, 1e-9) << ratio;
      }
    }
  };
  for (const double next : {0.4, 0.5, crossing, 0.7, 0.9, 1.2, 1.5, 1.7, limit * (1 - 1e-3)}) {
    expect_double_row(go_to(next));
    if (next == crossing) {
      EXPECT_NEAR(foam.energy(), kBubbles * std::sqrt(kArea / crossing), 1e-10);
    }
  }
  double width = go_to(limit * (1 + 1e-3));
  EXPECT_EQ(foam.t1_count, kBubbles);
  EXPECT_NEAR(foam.energy(), kBubbles * width, 1e-10);
  for (const double next : {1.5, 1.2, 0.9, crossing, 0.4}) {
    width = go_to(next);
    EXPECT_EQ(foam.t1_count, kBubbles);
    EXPECT_NEAR(foam.energy(), kBubbles * width, 1e-10);
  }
  EXPECT_GT(foam.energy(), kBubbles * (width / 2 + std::sqrt(3) / 2 * kArea / width));
}

/// Two bubbles fill an annulus between two radial films; a third sits on the obstacle, of radius 1,
/// under a single film of radius 1. What lies around has one pressure, and the film meets no other.
TEST(Walls, ABubbleOnADisc) {
  FilmSet set;
  set.junctions = {{0, 1}, {0, 4}, {0, -1}, {0, -4}, rotated({1, 0}, -0.6), rotated({1, 0}, 0.6)};
  set.films = {{0, 1, 1, 0, 0, {}},  {2, 3, 0, 1, 0, {}},  {4, 5, 2, 0, 2, {}},
               {3, 1, 0, -1, 0, {}}, {1, 3, 1, -1, 0, {}}, {0, 5, 0, -2, 0, {}},
               {5, 4, 2, -2, 0, {}}, {4, 2, 0, -2, 0, {}}, {2, 0, 1, -2, 0, {}}};
  const double area = 1 + kPi / 2;
  set.bubbles = {{0, 0, 7.5 * kPi - area}, {1, 0, 7.5 * kPi}, {2, 0, area}};
  const Foam foam = between_walls(set, annulus({-4, 4, -4, 4}, 1, WallContact::Slip));
  EXPECT_EQ(foam.t1_count, 0);
  const Film arc(2);
  EXPECT_NEAR(foam.length(arc.half()), 1.5 * kPi, 1e-10);
  EXPECT_NEAR(foam.energy(), 2 * 3 + 1.5 * kPi, 1e-10);
  EXPECT_NEAR(arc_curvature(norm(foam.chord(arc.half())), foam.half_angle(arc.half())), 1, 1e-10);
  EXPECT_NEAR(foam.pressure[Bubble(2)] - foam.pressure[Bubble(0)], 1, 1e-10);
  EXPECT_NEAR(foam.pressure[Bubble(1)] - foam.pressure[Bubble(0)], 0, 1e-10);
  EXPECT_NEAR(area_rate(view_of(foam), 1)(Bubble(2)), -(kPi + 2 * std::atan(1)), 1e-9);
}

/// A Möbius map of the unit disc.
std::complex<double> moebius(std::complex<double> z, std::complex<double> a) {
  return (z + a) / (1.0 + std::conj(a) * z);
}

/// They keep circles and angles, and so take an equilibrium in a disc to another.
TEST(Walls, MoebiusMapsOfADiscKeepEquilibria) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Foam foam = random_foam_in(disc({-1, 1, -1, 1}, WallContact::Slip), 20, seed);
    expect_equilibrium(foam);
    Random random(seed);
    const std::complex<double> a =
        std::polar(0.5 * std::sqrt(random.uniform()), 2 * kPi * random.uniform());
    Foam mapped = foam;
    const auto image = [&](Vec2 p) {
      const std::complex<double> w = moebius({p.x, p.y}, a);
      return Vec2{w.real(), w.imag()};
    };
    for (const Junction j : foam.junction_slots()) {
      if (foam.on_wall(j)) {
        mapped.put_on_wall(j, wall_place(foam, Outside(0), image(foam.position[j])));
      } else {
        mapped.position[j] = image(foam.position[j]);
      }
    }
    for (const Film f : foam.film_slots()) {
      if (foam.bends(f)) {
        const Vec2 start = foam.position[foam.start(f.half())];
        const Vec2 middle =
            image(arc_point(start, foam.chord(f.half()), foam.half_angle(f.half()), 0.5));
        const Vec2 from = mapped.position[foam.start(f.half())];
        // The angle between the chords of the two halves of an arc is its half-angle.
        mapped.film_angle[f] =
            angle_from_to(middle - from, mapped.chord(f.half())) +
            angle_from_to(mapped.chord(f.half()), mapped.position[foam.end(f.half())] - middle);
      }
    }
    EXPECT_LT(max_angle_error(mapped), 1e-9) << seed;
    // Pressures that explain all curvatures: walk from bubble to bubble.
    for (const Junction j : mapped.junction_slots()) {
      if (!mapped.on_wall(j)) {
        double sum = 0; // of curvatures round a junction
        for (const Half h : mapped.junction_half[j]) {
          sum += arc_curvature(norm(mapped.chord(h)), mapped.half_angle(h));
        }
        EXPECT_LT(std::abs(sum), 1e-8) << seed;
      }
    }
  }
}

/// A bubble that goes round a channel has a film on both of whose sides it lies. The small bubbles
/// on that film, one at either wall, vanish, and leave the film straight across.
TEST(Walls, ABubbleThatGoesRoundAChannelStays) {
  FilmSet set;
  set.junctions = {{1.8, 0}, {2.2, 0}, {2, 0.3}, {2, 1.7}, {2.2, 2}, {1.8, 2}};
  set.films = {{1, 2, 1, 0, 0.5, {}}, {2, 0, 1, 0, 0.5, {}},    {0, 1, 1, -1, 0, {}},
               {2, 3, 0, 0, 0, {}},   {3, 4, 2, 0, 0.5, {}},    {4, 5, 2, -2, 0, {}},
               {5, 3, 2, 0, 0.5, {}}, {1, 0, 0, -1, 0, {1, 0}}, {5, 4, 0, -2, 0, {-1, 0}}};
  set.bubbles = {{0, 0, 7.8}, {1, 0, 0.08}, {2, 0, 0.12}};
  const Foam start = between_walls(set, channel({0, 4, 0, 2}, WallContact::Slip));
  for (const Stepping stepping : {Stepping::Events, Stepping::FixedSteps}) {
    CoarseningOptions options;
    options.stepping = stepping;
    options.time_step = 0.01;
    options.thresholds.kind = ThresholdKind::Absolute;
    options.thresholds.t1_length = 0.01;
    options.thresholds.t2_area = 0.01;
    const auto coarsening = make_coarsening(options);
    coarsening->restart(start);
    for (int frame = 0; frame < 10; ++frame) {
      ASSERT_TRUE(coarsening->advance({}));
      expect_valid(coarsening->foam());
      expect_equilibrium(coarsening->foam());
    }
    const Foam& foam = coarsening->foam();
    EXPECT_EQ(foam.bubble_count(), 1);
    EXPECT_NEAR(foam.energy(), 2, 1e-10);
    EXPECT_NEAR(gas(foam), 8, 1e-12);
    EXPECT_EQ(film_set(foam_of(film_set(foam))), film_set(foam));
  }
}

/// In a cleft as sharp as a heart's a film holds to the edge, at 195° to the wall ahead, and ends
/// on the floor as a quarter circle's half of radius 2√2.
TEST(Walls, AFilmHoldsToASharpEdge) {
  const double root = std::sqrt(3);
  const std::vector<Vec2> cleft{{-3, -2}, {3, -2},    {3, root}, {1, root},
                                {0, 0},   {-1, root}, {-3, root}};
  const double half = 3 * (2 + root) - root / 2;
  for (const double side : {-1.0, 1.0}) {
    const double gain = side * (kPi - 2);
    Foam foam = filled(outline({{cleft}}, WallContact::Slip), {{-1.5, -0.5}, {1.5, -0.5}},
                       {half + gain, half - gain});
    expect_equilibrium(foam);
    EXPECT_NEAR(foam.energy(), kPi / std::sqrt(2), 1e-10);
    EXPECT_NEAR(foam.pressure[Bubble(0)] - foam.pressure[Bubble(1)], side / (2 * std::sqrt(2)),
                1e-10);
  }
}

/// Three radii of a disc, mapped so that the middle goes to a on the first of them, which stays
/// straight; the others become arcs of curvature 2a·sin 120°/(1 − a²).
TEST(Walls, ThreeMappedRadiiOfADisc) {
  constexpr double kA = 0.3;
  const double curvature = 2 * kA * std::sin(2 * kPi / 3) / (1 - kA * kA);
  EXPECT_NEAR(curvature, 0.571005760737, 1e-12);
  const std::complex<double> mapped = moebius(std::polar(1.0, 2 * kPi / 3), kA);
  const Vec2 middle{kA, 0};
  const Vec2 end{mapped.real(), mapped.imag()};
  const double d = norm(end - middle);
  const double half_angle = std::asin(0.5 * curvature * d);
  const double turn = std::arg(mapped);
  // From the middle along the first radius, the wall and back along the arc, which bulges out.
  const double area = 0.5 * cross(middle, Vec2{1, 0}) + 0.5 * turn + 0.5 * cross(end, middle) +
                      segment_area(d, half_angle);
  EXPECT_NEAR(area, 0.653363562, 1e-9);
  Foam foam = filled(disc({-1, 1, -1, 1}, WallContact::Slip), {{0.5, 0.5}, {-0.5, 0}, {0.5, -0.5}},
                     {area, kPi - 2 * area, area});
  expect_equilibrium(foam);
  EXPECT_NEAR(arc_length(d, half_angle), 1.039000714, 1e-9);
  EXPECT_NEAR(foam.energy(), 1 - kA + 2 * arc_length(d, half_angle), 1e-10);
  EXPECT_NEAR(foam.pressure[Bubble(0)] - foam.pressure[Bubble(1)], curvature, 1e-10);
  EXPECT_NEAR(foam.pressure[Bubble(0)] - foam.pressure[Bubble(2)], 0, 1e-10);
}

/// A channel's foam and its image beyond the lower wall, on a torus. What lies on a wall becomes
/// one with its image.
Foam with_its_image(const Foam& foam, double period, double width) {
  FilmSet set;
  set.surroundings.boundary = Boundary::Periodic;
  set.surroundings.lattice = Lattice::rectangle(0, period, -width, width);
  set.surface_tension = foam.surface_tension;
  const auto image = static_cast<Index>(foam.bubble_half.size());
  const auto id = [&](Bubble b, bool mirrored) {
    return std::int64_t{b.index()} + (mirrored && !foam.bubble_on_outside(b) ? image : 0);
  };
  for (const bool mirrored : {false, true}) {
    for (const Bubble b : foam.bubble_slots()) {
      const bool on_wall = foam.bubble_on_outside(b);
      if (!mirrored || !on_wall) {
        set.bubbles.push_back(
            {id(b, mirrored), foam.pressure[b], foam.target_area[b] * (on_wall ? 2 : 1)});
      }
    }
  }
  std::vector<std::array<Index, 2>> number(foam.position.size());
  for (const Junction j : foam.junction_slots()) {
    if (foam.has_junction(j) && !foam.on_wall(j)) {
      for (const bool mirrored : {false, true}) {
        const Vec2 p = foam.position[j];
        number[j.place()][mirrored] = static_cast<Index>(set.junctions.size());
        set.junctions.push_back({p.x, mirrored ? -p.y : p.y});
      }
    }
  }
  for (const Film f : foam.film_slots()) {
    if (!foam.has_film(f) || foam.wall(f.half())) {
      continue;
    }
    const Half half = foam.on_wall(foam.start(f.half())) ? f.half().twin() : f.half();
    const auto start = number[foam.start(half).place()];
    const double alpha = foam.half_angle(half);
    const Wrap wrap = foam.wrap(half);
    if (foam.on_wall(foam.end(half))) { // from a junction through the wall to its image
      const bool upper = foam.position[foam.end(half)].y > 0.5 * width;
      set.films.push_back({start[0],
                           start[1],
                           id(foam.left(half), false),
                           id(foam.right(half), false),
                           2 * alpha,
                           {0, upper ? 1 : 0}});
      continue;
    }
    const auto end = number[foam.end(half).place()];
    set.films.push_back(
        {start[0], end[0], id(foam.left(half), false), id(foam.right(half), false), alpha, wrap});
    set.films.push_back(
        {start[1], end[1], id(foam.right(half), true), id(foam.left(half), true), -alpha, wrap});
  }
  return foam_of(set);
}

TEST(Walls, AFoamOnAStraightWallIsHalfOfItselfAndItsImage) {
  for (std::uint64_t seed = 1; seed <= 20; ++seed) {
    Foam foam = random_foam_in(channel({0, 4, 0, 4}, WallContact::Slip), 60, seed);
    expect_equilibrium(foam);
    const Foam whole = with_its_image(foam, 4, 4);
    expect_valid(whole);
    EXPECT_LT(measured_report(whole).residual, 1e-9) << seed;
    EXPECT_NEAR(whole.energy(), 2 * foam.energy(), 1e-10);
  }
}

TEST(Walls, ForcesOnAContainerAndItsObstaclesCancel) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    for (const auto& [name, container] : containers()) {
      Foam foam = random_foam_in(container, 40, seed);
      expect_equilibrium(foam, name);
      const std::vector<WallForce> forces = wall_forces(foam);
      Vec2 sum;
      for (const WallForce& force : forces) {
        sum += force.network + force.pressure;
      }
      EXPECT_LT(norm(sum), 1e-8) << name << ' ' << seed;
      for (double& pressure : foam.pressure) {
        pressure += 7;
      }
      const std::vector<WallForce> shifted = wall_forces(foam);
      for (std::size_t i = 0; i < forces.size() && container.period == 0; ++i) {
        EXPECT_LT(norm(shifted[i].pressure - forces[i].pressure), 1e-10) << name;
        EXPECT_EQ(shifted[i].network, forces[i].network) << name;
      }
    }
  }
}

TEST(Walls, GrowthIsVonNeumannsAndSumsToZero) {
  for (std::uint64_t seed = 1; seed <= 5; ++seed) {
    for (const auto& [name, container] : containers()) {
      const Foam foam = random_foam_in(container, 30, seed);
      expect_equilibrium(foam, name);
      const AreaRate rate = area_rate(view_of(foam), 1);
      double total = 0;
      for (const Bubble b : foam.bubble_slots()) {
        EXPECT_NEAR(rate(b), gas_transfer(foam, b, 1), 1e-8) << name << ' ' << seed;
        total += rate(b);
      }
      EXPECT_NEAR(total, 0, 1e-10) << name << ' ' << seed;
    }
  }
}

} // namespace
} // namespace foam::test
