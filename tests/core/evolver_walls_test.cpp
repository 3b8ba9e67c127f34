// SPDX-License-Identifier: GPL-3.0-or-later
// Walls in files of Surface Evolver's, in all the ways in which they may be written.
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include "base/error.h"
#include "containers.h"
#include "datafiles.h"
#include "evolver/curve.h"
#include "evolver/read_foam.h"
#include "evolver/write_foam.h"
#include "foams.h"

namespace foam::test {
namespace {

constexpr double kPi = std::numbers::pi;

/// Two bubbles in a disc of radius 2 about (1, 0), of which the film between is straight.
const std::string kDisc = R"(STRING
SPACE_DIMENSION 2
PARAMETER R = 2
CONSTRAINT 1
FORMULA: (x - 1)^2 + y^2 = R^2
VERTICES
1 1 -2 CONSTRAINT 1
2 1 2 CONSTRAINT 1
3 3 0 CONSTRAINT 1
4 -1 0 CONSTRAINT 1
EDGES
1 1 2
2 1 3 CONSTRAINT 1 TENSION 0
3 3 2 CONSTRAINT 1 TENSION 0
4 2 4 CONSTRAINT 1 TENSION 0
5 4 1 CONSTRAINT 1 TENSION 0
FACES
1 1 4 5
2 2 3 -1
BODIES
1 1 VOLUME 2*pi
2 2 VOLUME 2*pi
)";

/// Two bubbles between x 0 and 3, y 0 and 1, beside each other.
const std::string kBox = R"(STRING
SPACE_DIMENSION 2
CONSTRAINT 1
FORMULA: y = 0
CONSTRAINT 2
FORMULA: x = 3
CONSTRAINT 3
FORMULA: y = 1
CONSTRAINT 4
FORMULA: x = 0
VERTICES
1 0 0 FIXED
2 3 0 FIXED
3 3 1 FIXED
4 0 1 FIXED
5 1 0 CONSTRAINT 1
6 1 1 CONSTRAINT 3
EDGES
1 1 5 CONSTRAINT 1 TENSION 0
2 5 2 CONSTRAINT 1 TENSION 0
3 2 3 CONSTRAINT 2 TENSION 0
4 3 6 CONSTRAINT 3 TENSION 0
5 6 4 CONSTRAINT 3 TENSION 0
6 4 1 CONSTRAINT 4 TENSION 0
7 5 6
FACES
1 1 7 5 6
2 2 3 4 -7
BODIES
1 1 VOLUME 1
2 2 VOLUME 2
)";

/// A foam of two halves of a container that a film of length 1 parts.
void expect_box(const std::string& text, WallContact contact, const std::string& where) {
  EXPECT_EQ(error_of(text), "no error") << where;
  if (error_of(text) != "no error") {
    return;
  }
  const Foam foam = read(text).foam;
  expect_valid(foam, where);
  EXPECT_EQ(foam.bubble_count(), 2) << where;
  EXPECT_NEAR(foam.energy(), 1, 1e-15) << where;
  EXPECT_NEAR(foam.area(Bubble(0)), 1, 1e-15) << where;
  EXPECT_NEAR(foam.area(Bubble(1)), 2, 1e-15) << where;
  ASSERT_EQ(foam.exterior.size(), 1u) << where;
  EXPECT_EQ(foam.exterior[Outside(0)].contact, contact) << where;
  EXPECT_EQ(foam.wall_piece.size(), 4u) << where;
  EXPECT_NEAR(foam.area_of_wall(Outside(0)), 3, 1e-15) << where;
  EXPECT_EQ(foam.target_area, (Field<Bubble, double>{1, 2})) << where;
}

void expect_disc(const std::string& text, const std::string& where) {
  EXPECT_EQ(error_of(text), "no error") << where;
  if (error_of(text) != "no error") {
    return;
  }
  const Foam foam = read(text).foam;
  expect_valid(foam, where);
  EXPECT_EQ(foam.bubble_count(), 2) << where;
  EXPECT_NEAR(foam.energy(), 4, 1e-14) << where;
  for (const Bubble b : foam.bubble_slots()) {
    EXPECT_NEAR(foam.area(b), 2 * kPi, 1e-13) << where;
    EXPECT_NEAR(foam.target_area[b], 2 * kPi, 1e-13) << where;
  }
  EXPECT_EQ(foam.surroundings.wall_symmetry, WallSymmetry::Circle) << where;
  EXPECT_LT(norm(foam.surroundings.centre - Vec2{1, 0}), 1e-14) << where;
  for (const WallPiece& piece : foam.wall_piece) {
    EXPECT_NEAR(piece.curvature(), 0.5, 1e-14) << where;
  }
}

TEST(EvolverWalls, AreCurvesHoweverTheyAreWritten) {
  expect_disc(kDisc, "");
  for (const std::string formula :
       {"sqrt((x-1)**2 + y*y) = R", "x^2 - 2*x + y^2 - 3", "sqr(x - 1) + sqr(y) - sqr(R) = 0",
        "((x-1)^2 + y^2)^0.5 - R", "(x-1)*(x-1) + pow(y,2) = 4", "1 = R*R/((x-1)^2 + y^2)"}) {
    expect_disc(replaced(kDisc, "(x - 1)^2 + y^2 = R^2", formula), formula);
  }
  expect_disc(replaced(kDisc, "2 1 2 CON", "2 1 1.9 CON"), "near the circle");
  expect_disc(replaced(kDisc, "FORMULA: (x - 1)^2 + y^2 = R^2",
                       "CONVEX\nCONTENT: c1: x*y\nFUNCTION: (x-1)^2 + y^2 = R^2\nENERGY: E1: R"),
              "other parts");
  for (const std::string coordinates :
       {"X1: 1 + R*cos(P1)\nX2: R*sin(P1)", "x1: 1 + r*cos(-p1 + 0)\nx2: -r*sin(-p1)"}) {
    std::string text = replaced(kDisc, "CONSTRAINT 1\nFORMULA: (x - 1)^2 + y^2 = R^2",
                                "BOUNDARY 1 PARAMETERS 1\n" + coordinates);
    text = replaced(text, "1 1 -2 CONSTRAINT", "1 -pi/2 BOUNDARY");
    text = replaced(text, "2 1 2 CONSTRAINT", "2 pi/2 BOUNDARY");
    text = replaced(text, "3 3 0 CONSTRAINT", "3 0 BOUNDARY");
    text = replaced(text, "4 -1 0 CONSTRAINT", "4 pi BOUNDARY");
    for (int edge = 0; edge < 4; ++edge) {
      text = replaced(text, "CONSTRAINT 1 TENSION", "BOUNDARY 1 TENSION");
    }
    expect_disc(text, coordinates);
  }
  expect_box(kBox, WallContact::Slip, "");
  for (const std::string formula : {"2*y = 0", "x - x + y", "(y + 1)^1 = 1", "y/(2 + 1)"}) {
    expect_box(replaced(kBox, "FORMULA: y = 0", "FORMULA: " + formula), WallContact::Slip, formula);
  }
  std::string line =
      replaced(kBox, "CONSTRAINT 1\nFORMULA: y = 0", "BOUNDARY 1 PARAMETERS 1\nX1: 2*p1\nX2: 0");
  line = replaced(line, "5 1 0 CONSTRAINT 1", "5 0.5 BOUNDARY 1");
  line =
      replaced(replaced(line, "1 5 CONSTRAINT", "1 5 BOUNDARY"), "5 2 CONSTRAINT", "5 2 BOUNDARY");
  expect_box(line, WallContact::Slip, "a line of a parameter");
}

TEST(EvolverWalls, HoldFilmsAsTheyAreSaidTo) {
  expect_box(replaced(replaced(kBox, "5 1 0 CONSTRAINT 1", "5 1 0 FIXED"), "6 1 1 CONSTRAINT 3",
                      "6 1 1 FIXED"),
             WallContact::Pinned, "vertices that are fixed");
  std::string fixed =
      kBox.substr(0, kBox.find("CONSTRAINT 1")) + kBox.substr(kBox.find("VERTICES"));
  for (const std::string on : {"CONSTRAINT 1", "CONSTRAINT 3"}) {
    fixed = replaced(fixed, on, "FIXED");
  }
  for (const std::string edge : {"1 1 5", "2 5 2", "3 2 3", "4 3 6", "5 6 4", "6 4 1"}) {
    const auto at = fixed.find(edge);
    fixed = fixed.substr(0, at) + edge + " FIXED TENSION 0" + fixed.substr(fixed.find('\n', at));
  }
  EXPECT_EQ(error_of(fixed), "no error");
  const Foam pinned = read(fixed).foam;
  expect_valid(pinned);
  EXPECT_EQ(pinned.exterior[Outside(0)].contact, WallContact::Pinned);
  EXPECT_EQ(pinned.wall_piece.size(), 6u); // as many as there are edges
  EXPECT_NEAR(pinned.area(Bubble(1)), 2, 1e-15);
  // Corners on both of their sides, and edges that are on a wall because their ends are.
  expect_box(replaced(kBox, "1 0 0 FIXED", "1 0 0 CONSTRAINTS 1 4"), WallContact::Slip, "corner");
  expect_box(replaced(replaced(kBox, "1 0 0 FIXED", "1 0 0.01 CONSTRAINTS 1 4"),
                      "1 1 5 CONSTRAINT 1", "1 1 5"),
             WallContact::Slip, "edge between two on a wall");
  // One bubble has what the others leave, and pressures are above its: their mean is 0.
  const Foam rest = read(replaced(replaced(kBox, "2 2 VOLUME 2", "2 2"), "VOLUME 1",
                                  "VOLUME 1 LAGRANGE_MULTIPLIER 3"))
                        .foam;
  EXPECT_EQ(rest.target_area, (Field<Bubble, double>{1, 2}));
  EXPECT_EQ(rest.pressure, (Field<Bubble, double>{1.5, -1.5}));
  const EvolverFoam tense = read([] {
    std::string text = kBox;
    for (int edge = 0; edge < 6; ++edge) {
      text = replaced(text, "TENSION 0", "density 1");
    }
    return text;
  }());
  EXPECT_EQ(tense.foam.energy(), 1);
  ASSERT_EQ(tense.warnings.size(), 1u);
  EXPECT_EQ(tense.warnings[0].find("line 19: the tension of edge 1 and of all its wall"), 0u);
}

/// Faces that are closed by what their walls add to the area.
TEST(EvolverWalls, MayBeLeftOutOfFaces) {
  std::string disc = replaced(kDisc, "1 1 4 5\n2 2 3 -1", "1 1\n2 -1");
  for (const std::string edge : {"2 1 3", "3 3 2", "4 2 4", "5 4 1"}) {
    disc = replaced(disc, edge + " CONSTRAINT 1 TENSION 0\n", "");
  }
  expect_disc(replaced(disc, "= R^2\n", "= R^2\nCONTENT: c1: x*y\n"), "two halves");
  expect_disc(replaced(replaced(disc, "1 1\n2 -1", "1 -1\n2 -1"), "1 1 VOLUME", "1 -1 VOLUME"),
              "one half from behind");
  // Half a disc of radius 2 on a line, halved.
  const std::string half = R"(STRING
SPACE_DIMENSION 2
CONSTRAINT 1
FORMULA: y = 0
CONSTRAINT 2
FORMULA: x^2 + y^2 = 4
VERTICES
1 0.1 0 CONSTRAINT 1
2 0 2 CONSTRAINT 2
EDGES
1 1 2
FACES
1 1
2 -1
BODIES
1 1 VOLUME pi
2 2
)";
  EXPECT_EQ(error_of(half), "no error");
  Foam foam = read(half).foam;
  expect_valid(foam);
  EXPECT_NEAR(foam.area(Bubble(0)) + foam.area(Bubble(1)), 2 * kPi, 1e-13);
  EXPECT_NEAR(foam.area(Bubble(0)), kPi + 0.1, 1e-13);
  equilibrate(foam, 1e-12);
  EXPECT_NEAR(foam.energy(), 2, 1e-12);
}

TEST(EvolverWalls, OfAnObstacleMayBeTouchedOrNot) {
  const std::string square = "6 1 1 CONSTRAINT 3\n"
                             "7 2 .4 fixed\n8 2.2 .4 fixed\n9 2.2 .6 fixed\n10 2 .6 fixed\n";
  const std::string edges = "7 5 6\n8 7 8 fixed tension 0\n9 8 9 fixed tension 0\n"
                            "10 9 10 fixed tension 0\n11 10 7 fixed tension 0\n";
  const std::string text =
      replaced(replaced(kBox, "6 1 1 CONSTRAINT 3\n", square), "7 5 6\n", edges);
  for (const auto& [given, target] : std::vector<std::pair<std::string, double>>{
           {"VOLUME 2", 1.96}, {"VOLUME 1.96 VOLCONST -0.04", 1.96}, {"", 1.96}}) {
    const std::string with = replaced(text, "2 2 VOLUME 2", "2 2 " + given);
    EXPECT_EQ(error_of(with), "no error");
    const Foam foam = read(with).foam;
    expect_valid(foam);
    ASSERT_EQ(foam.exterior.size(), 2u);
    EXPECT_EQ(foam.exterior[Outside(1)].host, Bubble(1));
    EXPECT_EQ(foam.exterior[Outside(1)].contact, WallContact::Pinned);
    EXPECT_NEAR(foam.area_of_wall(Outside(1)), -0.04, 1e-15);
    EXPECT_NEAR(foam.area(Bubble(1)), 1.96, 1e-14);
    EXPECT_NEAR(foam.target_area[Bubble(1)], target, 1e-14);
  }
  // As a face without a body, too.
  EXPECT_EQ(error_of(replaced(text, "BODIES", "3 8 9 10 11\nBODIES")), "no error");
}

TEST(EvolverWalls, OfAChannelRunAlongX) {
  const std::string channel = R"(STRING
SPACE_DIMENSION 2
TORUS
PERIODS
2 0
0 5
CONSTRAINT 1
FORMULA: y = 1
CONSTRAINT 2
FORMULA: y = 2
VERTICES
1 0.5 1 CONSTRAINT 1
2 1.25 1 CONSTRAINT 1
3 0.5 2 CONSTRAINT 2
4 1.25 2 CONSTRAINT 2
EDGES
1 1 3 * *
2 2 4 * *
3 1 2 * * CONSTRAINT 1 TENSION 0
4 2 1 + * CONSTRAINT 1 TENSION 0
5 4 3 * * CONSTRAINT 2 TENSION 0
6 3 4 - * CONSTRAINT 2 TENSION 0
FACES
1 3 2 5 -1
2 4 1 6 -2
BODIES
1 1 VOLUME 0.75
2 2 VOLUME 1.25
)";
  EXPECT_EQ(error_of(channel), "no error");
  const Foam foam = read(channel).foam;
  expect_valid(foam);
  EXPECT_EQ(foam.surroundings.wall_symmetry, WallSymmetry::Line);
  EXPECT_EQ(foam.surroundings.lattice.first, (Vec2{2, 0}));
  EXPECT_NEAR(foam.area(Bubble(0)), 0.75, 1e-15);
  EXPECT_NEAR(foam.area(Bubble(1)), 1.25, 1e-15);
  EXPECT_EQ(foam.energy(), 2);
  const std::string across = error_of(replaced(channel, "2 0\n0 5", "2 1\n0 5"));
  EXPECT_EQ(across.find("line 19: the wall of edge 3 is that of a channel, which"), 0u) << across;
}

struct Damage {
  std::string what;
  std::string with;
  std::string error;
};

TEST(EvolverWalls, ThatCannotBeHereAreAnErrorWithTheirLine) {
  const std::vector<Damage> of_box = {
      {"FORMULA: y = 0", "FORMULA: y = 0.1*x^2", "no error"}, // see below: it is a parabola
      {"FORMULA: y = 0", "FORMULA: y = z1", "line 4: expected a number or a PARAMETER, not 'z1'"},
      {"FORMULA: y = 0", "NONNEGATIVE\nFORMULA: y = 0",
       "line 17: 'constraint': vertex 5 lies on constraint 1, which it may leave"},
      {"FORMULA: y = 0", "GLOBAL\nFORMULA: y = 0", "line 4: 'global' makes constraint 1 that of"},
      {"FORMULA: y = 0", "FORMULA: y = 0\nENERGY: E1: 0.5*x",
       "line 17: 'constraint': vertex 5 lies on constraint 1, which has ENERGY"},
      {"CONSTRAINT 2\n", "CONSTRAINT 1\n", "line 5: constraint 1 is declared twice"},
      {"5 1 0 CONSTRAINT 1", "5 1 0 CONSTRAINT 7",
       "line 16: 'constraint': vertex 5 lies on constraint 7, which is not declared"},
      {"5 1 0 CONSTRAINT 1", "5 1 0", "line 16: 'constraint': vertex 5 does not keep to"},
      {"5 1 0 CONSTRAINT 1", "5 1 0 FIXED",
       "line 16: 'fixed': vertex 5 does not move, and vertex "
       "6"},
      {"2 3 0 FIXED", "2 3 0.1 FIXED",
       "line 13: 'constraint': vertex 2 does not keep to the curve"},
      {"7 5 6", "7 5 6 CONSTRAINT 1", "line 25: 'constraint': edge 7 does not move, and has"},
      {"3 2 3 CONSTRAINT 2 TENSION 0", "3 2 3 TENSION 1",
       "line 24: 'constraint': edge 6 does not move, but edge 3 beside gas does"},
      {"3 2 3 CONSTRAINT 2 TENSION 0", "3 2 3 CONSTRAINT 2 TENSION 1",
       "line 21: edge 3 and edge 1 are one wall, but differ in their tensions"},
      {"VOLUME 2", "VOLUME 3", "the target areas add up to 4, but the area of the container is 3"},
      {"VOLUME 1", "", "no error"},
      {"1 VOLUME 1\n2 2 VOLUME 2", "1\n2 2", "no error"}, // as grains, which keep theirs
      {"1 1 7 5 6\n2 2 3 4 -7", "1 1 7 5 6\n2 2 3 4",
       "line 28: face 2 is open after edge 4, and no walls close it"},
  };
  for (const auto& [what, with, error] : of_box) {
    const std::string found = error_of(replaced(kBox, what, with));
    if (what == "FORMULA: y = 0" && error == "no error") {
      EXPECT_EQ(
          found.find("line 16: 'constraint': vertex 5 lies on constraint 1, which is neither"), 0u)
          << found;
    } else {
      EXPECT_EQ(found.find(error), 0u) << error << " / " << found;
    }
  }
  const std::string ellipse = replaced(kDisc, "y^2 = R^2", "y^2/4 = R^2");
  EXPECT_EQ(error_of(ellipse).find("line 7: 'constraint': vertex 1 lies on constraint 1, which is "
                                   "neither"),
            0u)
      << error_of(ellipse);
  EXPECT_EQ(error_of(replaced(kDisc, "(x - 1)^2 + y^2 = R^2", "(x - 1)*(y + 2)*(y - 2) = 0"))
                .find("line "),
            0u);
}

TEST(EvolverWalls, RoundTripKeepsTheFoam) {
  for (const auto& [shape, container] : containers()) {
    for (const WallContact contact : {WallContact::Slip, WallContact::Pinned}) {
      Container with = container;
      for (Wall& wall : with.walls) {
        wall.contact = contact;
      }
      const Foam foam = random_foam_in(with, 12, 5);
      const Foam back = read(write_evolver(foam)).foam;
      expect_valid(back, shape);
      for (const Junction j : foam.junction_slots()) {
        EXPECT_LT(norm(back.position[j] - foam.position[j]), 1e-15) << shape;
      }
      EXPECT_EQ(back.half_bubble, foam.half_bubble) << shape;
      EXPECT_EQ(back.bubble_id, foam.bubble_id) << shape;
      EXPECT_EQ(back.exterior, foam.exterior) << shape;
      EXPECT_NEAR(back.energy(), foam.energy(), 1e-13 * foam.energy()) << shape;
      for (const Bubble b : foam.bubble_slots()) {
        EXPECT_NEAR(back.area(b), foam.area(b), 1e-13) << shape;
        EXPECT_NEAR(back.target_area[b], foam.target_area[b], 1e-13) << shape;
        EXPECT_NEAR(back.pressure[b], foam.pressure[b], 1e-12) << shape;
      }
    }
  }
  const Foam fixed = jittered_foam(Boundary::Fixed, 30, 1);
  const Foam back = read(write_evolver(fixed)).foam;
  EXPECT_EQ(back.position, fixed.position);
  EXPECT_EQ(back.wall_piece.size(), fixed.wall_piece.size());
  EXPECT_NEAR(back.energy(), fixed.energy(), 1e-13 * fixed.energy());
}

} // namespace
} // namespace foam::test
