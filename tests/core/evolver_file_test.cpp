// SPDX-License-Identifier: GPL-3.0-or-later
// Files of Surface Evolver's, in all the ways in which they may be written.
#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <random>
#include <sstream>
#include <string>
#include <vector>

#include "base/error.h"
#include "base/number.h"
#include "datafiles.h"
#include "evolver/datafile.h"
#include "evolver/read_foam.h"
#include "evolver/write_foam.h"
#include "foams.h"
#include "reference.h"

namespace foam::test {
namespace {

/// Two bubbles, of which the film between is straight.
const std::string kDouble = R"(STRING
SPACE_DIMENSION 2
QUADRATIC
LENGTH_METHOD_NAME "circular_arc_length"
AREA_METHOD_NAME "circular_arc_area"
VERTICES
1 0 -0.75
2 0 0.75
3 0 0
4 -1.25 0
5 1.25 0
EDGES
1 1 2 3
2 2 1 4
3 1 2 5
FACES
1 1 2
2 -1 3
BODIES
1 1 VOLUME 1.5
2 2 VOLUME 1.25 LAGRANGE_MULTIPLIER 0.5
)";

/// A hexagon on a torus.
const std::string kTorus = R"(STRING
SPACE_DIMENSION 2
TORUS_FILLED
PERIODS
3 0
-1 3
VERTICES
1 0 0
2 1 0
EDGES
1 1 2 * *
2 2 1 + +
3 1 2 * -
FACES
1 1 2 3 -1 -2 -3
BODIES
1 1 VOLUME 9
)";

std::string each_replaced(const std::string& text, const std::string& what,
                          const std::string& with) {
  std::string result;
  std::size_t from = 0;
  for (auto at = text.find(what); at != std::string::npos; at = text.find(what, from)) {
    result += text.substr(from, at - from) + with;
    from = at + what.size();
  }
  return result + text.substr(from);
}

void expect_same(const std::string& text, const std::string& as, const std::string& where) {
  EXPECT_EQ(error_of(text), "no error") << where;
  if (error_of(text) == "no error") {
    EXPECT_TRUE(film_set(read(text).foam) == film_set(read(as).foam)) << where;
  }
}

TEST(EvolverFile, IsTheFoamThatItSays) {
  const EvolverFoam read_double = read(kDouble);
  const Foam& foam = read_double.foam;
  EXPECT_TRUE(read_double.warnings.empty());
  EXPECT_LT(read_double.largest_misfit, 1e-15);
  expect_valid(foam);
  ASSERT_EQ(foam.bubble_count(), 2);
  // Circles through (0, ±3/4) and (5/4, 0): of sagitta 5/4 over the chord 3/2.
  const double radius = (0.75 * 0.75 + 1.25 * 1.25) / 2.5;
  const double alpha = 2 * std::atan2(1.25, 0.75);
  EXPECT_NEAR(foam.energy(), 1.5 + 4 * radius * alpha, 1e-14);
  const double area = radius * radius * (alpha - std::sin(alpha) * std::cos(alpha));
  for (const Bubble b : foam.bubble_slots()) {
    EXPECT_NEAR(foam.area(b), area, 1e-14);
    EXPECT_EQ(foam.bubble_id[b], b.index() + 1);
  }
  EXPECT_EQ(foam.target_area, (Field<Bubble, double>{1.5, 1.25}));
  EXPECT_EQ(foam.pressure, (Field<Bubble, double>{0, 0.5}));
  EXPECT_EQ(foam.surface_tension, 0.5);

  const Foam torus = read(kTorus).foam;
  expect_valid(torus);
  EXPECT_TRUE(torus.surroundings.periodic());
  EXPECT_NEAR(torus.energy(), 1 + std::sqrt(10.0) + std::sqrt(13.0), 1e-14);
  EXPECT_NEAR(torus.area(Bubble(0)), 9, 1e-14);
}

TEST(EvolverFile, ReadsTheStartOfTheReference) {
  std::ifstream file(std::filesystem::path(FOAM_TEST_DATA) / "evolver-100/foam100_arc.fe");
  std::stringstream text;
  text << file.rdbuf();
  const EvolverFoam start = read(text.str());
  EXPECT_TRUE(start.warnings.empty());
  expect_valid(start.foam);
  EXPECT_EQ(start.foam.bubble_count(), 100);
  EXPECT_EQ(start.foam.film_count(), 300);
  EXPECT_NEAR(start.foam.energy(), 206.296975169638, 1e-12); // as Surface Evolver prints it
  EXPECT_NEAR(gas(start.foam), 100, 1e-12);
}

std::string place(Vec2 p) {
  return foam::number(p.x) + " " + foam::number(p.y) + "\n";
}

/// The reference as a file of straight edges without pressures.
std::string reference_file() {
  const FilmSet set = evolver_foam();
  std::string text = "STRING\nspace_dimension 2\ntorus_filled\nperiods\n10 0\n0 10\nvertices\n";
  for (std::size_t j = 0; j < set.junctions.size(); ++j) {
    text += std::to_string(j + 1) + " " + place(set.junctions[j]);
  }
  const auto sign = [](int wrap) { return wrap < 0 ? " -" : wrap > 0 ? " +" : " *"; };
  text += "edges\n";
  for (std::size_t f = 0; f < set.films.size(); ++f) {
    const auto& film = set.films[f];
    text += std::to_string(f + 1) + " " + std::to_string(film.start + 1) + " " +
            std::to_string(film.end + 1) + sign(film.wrap.x) + sign(film.wrap.y) + "\n";
  }
  std::string bodies = "bodies\n";
  text += "faces\n";
  for (const auto& row : read_csv("evolver-100/foam100_eq_cells.csv")) {
    const std::string name = std::to_string(std::stoi(row.at("cell")) + 1);
    text += name;
    std::istringstream loop(row.at("edge_loop"));
    for (std::string edge; loop >> edge;) {
      text += " " + edge.substr(0, 1) + std::to_string(std::stoi(edge.substr(1)) + 1);
    }
    text += "\n";
    bodies += name + " " + name + " volume " + row.at("area_target") + "\n";
  }
  return text + bodies;
}

TEST(EvolverFile, ReferenceRelaxesToItsLength) {
  EvolverFoam reference = read(reference_file());
  EXPECT_GT(std::abs(reference.foam.energy() - 189.399110096385), 0.1);
  equilibrate(reference.foam, 1e-12);
  EXPECT_TRUE(reference.foam.report.converged);
  EXPECT_NEAR(reference.foam.energy(), 189.399110096385, 1e-9);
  EXPECT_EQ(reference.foam.t1_count, 0);
}

TEST(EvolverFile, MayBeSpelledInManyWays) {
  const auto torus = [](const std::string& what, const std::string& with) {
    expect_same(replaced(kTorus, what, with), kTorus, with);
  };
  torus("2 2 1 + +", "2 2 1 ++");
  torus("2 2 1 + +", "2 2 1 + + tension 1");
  torus("2 2 1 + +", "2 2 1 wrap 65");
  torus("2 2 1 + +", "2 2 1 WRAP 0x41 TENSION 2*0.5");
  torus("3 1 2 * -", "3 1 2 *-");
  torus("3 1 2 * -", "3 1 2 wrap 1984");
  torus("1 1 2 * *", "1 1 2 **");
  torus("1 1 2 * *", "1 1 2");
  torus("2 1 0\n", "2 3 - 2 0\n");
  torus("2 1 0\n", "2 3-2,0\n");
  torus("2 1 0\n", "\t2: .1e1; 0.D-7 bare original 7\n\n");
  torus("3 0\n-1 3", "3, 0 // a period\n-1 /* and\n another */ 3");
  torus("TORUS_FILLED", "torus");
  torus("PERIODS\n3 0\n", "PARAMETER Side = 3 on_assign_call nothing\nPERIODS\nside 0*SIDE\n");
  torus("VERTICES\n1 0", "#define origin_x 0\nVERTICES\n1 origin_x");
  torus("VOLUME 9", "VOLUME (4 > 3 && !0 ? 3^2 : 2**3)");
  torus("VOLUME 9", "VOLUME sqr(SQRT(9)) * cos(pi - pi) + 1.0d0 = 1e0");
  torus("VOLUME 9", "volume 1001b");
  torus("VOLUME 9", "VOLUME 9 \\\n VOLCONST 18 centerofmass"); // as Evolver dumps it
  torus("1 1 VOLUME 9", "1 1");                                // what is left of the torus
  torus("STRING", "// comment\n\nstring keep_originals");
  torus("BODIES\n", "facetedges\n1 2 3\nBODIES\n");
  expect_same(each_replaced(kTorus, "\n", "\r\n"), kTorus, "CR LF");
  expect_same(each_replaced(kTorus, "\n", "\r"), kTorus, "CR");
  expect_same(kTorus + "READ\ng 5\n1 2 3 (", kTorus, "commands");
  expect_same(replaced(kDouble, "SPACE_DIMENSION 2\n", ""), kDouble, "three dimensions");
  expect_same(replaced(each_replaced(kDouble, "0.75\n", "0.75 0\n"), "SPACE_DIMENSION 2\n", ""),
              kDouble, "z is 0");
  expect_same(replaced(kDouble, "BODIES\n", "3 -2 -3\nBODIES\n"), kDouble, "a face outside");
  expect_same(replaced(kDouble, "1 1 VOLUME 1.5", "1 1 VOLUME 2.5 VOLCONST 1"), kDouble,
              "constant");
  expect_same(replaced(replaced(kDouble, "2 -1 3", "2 -3 1"), "2 2 VOLUME", "2 -2 VOLUME"), kDouble,
              "a face that is its body's from behind");
}

TEST(EvolverFile, IncludesOthers) {
  const std::string vertices = "VERTICES\n1 0 0\n2 1 0\n";
  const std::string text = replaced(kTorus, vertices, "#include \"vertices.inc\"\n");
  EXPECT_EQ(error_of(text), "cannot read vertices.inc");
  const EvolverFoam whole = read_evolver(text, [&](const std::string&) { return vertices; });
  EXPECT_TRUE(film_set(whole.foam) == film_set(read(kTorus).foam));
  const auto itself = [](const std::string&) { return std::string("#include \"it\"\n"); };
  EXPECT_THROW(read_evolver(text, itself), FoamError);
}

TEST(EvolverFile, PeriodsMayGoRoundClockwise) {
  std::string text = replaced(kTorus, "3 0\n-1 3", "-1 3\n3 0");
  text = replaced(text, "* -", "- *");
  expect_same(text, kTorus, "clockwise");
}

TEST(EvolverFile, BubblesHaveTheNamesThatTheyAreGiven) {
  const auto ids = [](const std::string& text) { return read(text).foam.bubble_id; };
  using Names = Field<Bubble, std::int64_t>;
  EXPECT_EQ(ids(kDouble), (Names{1, 2}));
  const std::string original =
      replaced(replaced(kDouble, "VOLUME 1.5", "VOLUME 1.5 ORIGINAL 7"), "2 2 V", "9 2 V");
  EXPECT_EQ(ids(original), (Names{7, 9}));
  EXPECT_EQ(ids(replaced(original, "ORIGINAL 7", "ORIGINAL 9")), (Names{1, 9})); // one was split
  const std::string named =
      replaced(original, "VERTICES", "define body attribute bubbleid real\nVERTICES");
  EXPECT_EQ(ids(replaced(named, "ORIGINAL 7", "ORIGINAL 7 BubbleId 0")), (Names{0, 9}));
}

TEST(EvolverFile, TensionsAreThoseOfFilms) {
  const Foam uneven = read(replaced(kDouble, "1 1 2 3", "1 1 2 3 DENSITY 1.25")).foam;
  EXPECT_EQ(uneven.surface_tension, 0.5);
  EXPECT_EQ(uneven.film_tension, (Field<Film, double>{1.25, 1, 1}));
  std::string even = kDouble;
  for (const char* edge : {"1 1 2 3\n", "2 2 1 4\n", "3 1 2 5\n"}) {
    even = replaced(even, edge, replaced(edge, "\n", " tension 3\n"));
  }
  EXPECT_TRUE(read(even).foam.has_uniform_tension());
  EXPECT_EQ(read(even).foam.surface_tension, 1.5);
}

/// A film of many edges has the area of these, and is as long when they are many.
TEST(EvolverFile, RefinedEdgesAreOneFilm) {
  const Foam whole = read(kDouble).foam;
  double last = 1;
  for (const int n : {8, 64, 512}) {
    std::string text = replaced(kDouble, "3 0 0\n4 -1.25 0\n5 1.25 0\n", "");
    text = replaced(text, "QUADRATIC\n", "");
    std::string vertices;
    std::string edges = "1 1 2\n";
    std::string loops[2];
    int vertex = 2;
    int edge = 1;
    for (const int side : {0, 1}) {
      const Half h = Film(1 + side).half();
      for (int k = 1; k <= n; ++k) {
        const std::string from = std::to_string(k == 1 ? (side == 0 ? 2 : 1) : vertex);
        std::string to = side == 0 ? "1" : "2";
        if (k < n) {
          to = std::to_string(++vertex);
          const Vec2 p = arc_point(whole.position[whole.start(h)], whole.chord(h),
                                   whole.half_angle(h), static_cast<double>(k) / n);
          vertices += to + " " + place(p);
        }
        const bool backwards = k % 3 == 0; // an edge may run against its film
        edges +=
            std::to_string(++edge) + " " + (backwards ? to + " " + from : from + " " + to) + "\n";
        loops[side] += (backwards ? " -" : " ") + std::to_string(edge);
      }
    }
    text = replaced(text, "EDGES\n1 1 2 3\n2 2 1 4\n3 1 2 5\n", vertices + "EDGES\n" + edges);
    text = replaced(text, "1 1 2\n2 -1 3\n", "1 1" + loops[0] + "\n2 -1" + loops[1] + "\n");
    const EvolverFoam chained = read(text);
    EXPECT_EQ(chained.foam.film_count(), 3);
    // Polygons in circles: their area lacks a part of 1/n², and so do the arcs that have it.
    const double lacking = 1 - chained.foam.area(Bubble(0)) / whole.area(Bubble(0));
    EXPECT_LT(lacking, last / (n == 8 ? 1 : 60));
    EXPECT_GT(lacking, 0);
    EXPECT_NEAR(chained.foam.energy(), whole.energy(), 3 * lacking * whole.energy());
    EXPECT_LT(chained.largest_misfit, 3 * lacking);
    last = lacking;
  }
  EXPECT_LT(last, 1e-4);
}

struct Damage {
  std::string what;
  std::string with;
  std::string error;
};

TEST(EvolverFile, WhatIsNoFoamIsAnErrorWithItsLine) {
  const std::vector<Damage> of_double = {
      {"STRING\n", "",
       "this is no two-dimensional foam of Surface Evolver's: it does not say STRING"},
      {"STRING", "SOAPFILM", "line 1: 'soapfilm' is not the STRING model"},
      {"QUADRATIC", "LAGRANGE 4", "line 3: 'lagrange' makes edges of many points"},
      {"QUADRATIC", "pressure 1", "line 3: 'pressure' makes gas compressible"},
      {"QUADRATIC", "quantity q energy method m global", "line 3: 'quantity' q adds energy"},
      {"circular_arc_length", "edge_length_power",
       "line 4: 'length_method_name' gives films another"},
      {"DIMENSION 2", "DIMENSION 4", "line 2: 'space_dimension' is 4"},
      {"1 0 -0.75", "1 0 -0.75 fixed", "no error"},
      {"1 0 -0.75\n2 0 0.75", "1 0 -0.75 fixed\n2 0 0.75 fixed",
       "line 8: 'fixed': vertex 2 and vertex 1"},
      {"1 0 -0.75", "1 0 -0.75 constraint 1",
       "line 7: 'constraint': vertex 1 lies on constraint 1, which"},
      {"1 0 -0.75", "1 0 +0.75", "line 7: vertex 1 has 1 coordinates, not 2"},
      {"1 0 -0.75", "1 0", "line 7: vertex 1 has 1 coordinates, not 2"},
      {"1 0 -0.75", "1 0 -0.75 4", "line 7: unexpected 4 after vertex 1"},
      {"1 0 -0.75", "1 0 1/0", "the position of junction 0 is inf"},
      {"1 0 -0.75", "1 0 hight", "line 7: vertex 1 has 1 coordinates"},
      {"1 0 -0.75", "2 0 -0.75", "line 8: vertex 2 is listed twice"},
      {"1 1 2 3\n2 2 1 4", "1 1 2 3\n2 2 6 4", "line 14: vertex 6 is not listed"},
      {"1 1 2 3\n2 2 1 4", "1 1 2 3\n2 2 1 4 fixed", "line 14: 'fixed': edge 2 does not move"},
      {"1 1 2 3\n", "1 1 2 3 + *\n", "line 13: edge 1 wraps, but there is no TORUS"},
      {"1 1 2 3\n", "1 1 2 3 tension -1\n", "the tension of film 0 must be positive, but is -1"},
      {"1 1 2 3\n", "1 1 2 3 tension 2\n", "junction 0 cannot hold films"},
      {"1 1 2\n2 -1 3", "1 1 2\n2 -1", "line 18: face 2 is open after edge 1"},
      {"1 1 2\n2 -1 3", "1 1 2\n2 1 -3", "line 18: edge 1 has face 2 and face 1 on the same side"},
      {"1 1 2\n2 -1 3", "1 -1 -2\n2 -3 1", "the area of bubble 1 is -1.78"},
      {"1 1 VOLUME 1.5\n", "", "line 17: face 1 belongs to no body with a VOLUME"},
      {"VOLUME 1.5", "VOLUME -1.5", "line 20: the area of body 1 must be positive, but is -1.5"},
      {"VOLUME 1.5", "", "line 20: body 1 has no VOLUME"},
      {"VOLUME 1.5", "VOLUME 1.5 PRESSURE 2", "line 20: 'pressure': body 1 has a given pressure"},
      {"VOLUME 1.5", "VOLUME 1.5 DENSITY 2", "line 20: 'density': body 1 has 2"},
      {"1 1 VOLUME", "1 1 2 VOLUME", "line 20: body 1 has several faces"},
      {"2 2 VOLUME", "2 1 VOLUME", "line 21: face 1 belongs to two bodies"},
      {"2 2 VOLUME", "2 3 VOLUME", "line 21: face 3 is not listed"},
      {"5 1.25 0\n", "5 1.25 0\n6 3 0\n7 4 0\n8 4 1\n", "no error"},
      {"3 1 2 5\n", "3 1 2 5\n4 1 2\n", "line 7: more than three edges meet in vertex 1"},
  };
  for (const auto& [what, with, error] : of_double) {
    EXPECT_EQ(error_of(replaced(kDouble, what, with)).find(error), 0u)
        << error << " / " << error_of(replaced(kDouble, what, with));
  }
  const std::vector<Damage> of_torus = {
      {"2 2 1 + +", "2 2 1 + + +", "line 12: edge 2 has 3 wraps, not 2"},
      {"2 2 1 + +", "2 2 1 wrap 5000", "line 12: 'wrap' 5000 has more than two dimensions"},
      {"1 1 2 3 -1 -2 -3", "1 1 2 3", "line 15: face 1 is open after edge 3"},
      {"PERIODS\n3 0\n-1 3", "PERIODS\n3 0\n-1 0", "the periods"},
      {"VOLUME 9", "VOLUME 8", "the target areas add up to 8, but the area of the torus is 9"},
      {"SPACE_DIMENSION 2\n", "", "a torus must have SPACE_DIMENSION 2, but has 3"},
  };
  for (const auto& [what, with, error] : of_torus) {
    EXPECT_EQ(error_of(replaced(kTorus, what, with)).find(error), 0u)
        << error << " / " << error_of(replaced(kTorus, what, with));
  }
  for (const auto& [file, error] : std::vector<std::pair<std::string, std::string>>{
           {"", "this is no two-dimensional foam"},
           {"STRING\n", "the file has no edges"},
           {"STRING\n#define a a\na\n", "line 3: #include or #define are nested too deeply"},
           {"STRING \"x", "line 1: a text in quotes does not end"},
           {"STRING\nscale " + std::string(1000, '(') + "1",
            "line 2: an expression is nested too deeply"},
           {"STRING\nscale " + std::string(100000, '-') + "1",
            "line 2: an expression is nested"}}) {
    EXPECT_EQ(error_of(file).find(error), 0u) << error << " / " << error_of(file);
  }
}

/// Grains have no VOLUME, be they on a torus or free; and Evolver's scale may be fixed.
TEST(EvolverFile, WithoutVolumesAreasAreThoseThatItHas) {
  Foam foam = random_foam(30, Boundary::Periodic, 4);
  std::string text = write_evolver(foam);
  text = replaced(text, "QUADRATIC\n",
                  "autopop\nautochop 0.015\narea_normalization\nscale 5e-006 fixed\nQUADRATIC\n");
  std::istringstream lines(text);
  std::string grains;
  for (std::string line; std::getline(lines, line);) {
    const auto volume = line.find(" VOLUME");
    grains += line.substr(0, volume) + "\n";
  }
  const EvolverFoam read_grains = read(grains);
  ASSERT_EQ(read_grains.warnings.size(), 1u) << read_grains.warnings[1];
  EXPECT_NE(read_grains.warnings[0].find("no body has a VOLUME"), std::string::npos);
  expect_valid(read_grains.foam);
  for (const Bubble b : foam.bubble_slots()) {
    EXPECT_NEAR(read_grains.foam.target_area[b], foam.area(b), 1e-13);
  }
}

TEST(EvolverFile, WhatIsSkippedIsTold) {
  const auto warning_of = [](const std::string& text) {
    const auto warnings = read(text).warnings;
    return warnings.size() == 1 ? warnings[0] : std::to_string(warnings.size()) + " warnings";
  };
  EXPECT_EQ(warning_of(kDouble + "read\ng 5\n"), "line 22: the commands after READ are not obeyed");
  EXPECT_EQ(warning_of(kDouble + "read\n"), "0 warnings");
  EXPECT_EQ(
      warning_of(replaced(kDouble, "VERTICES", "hovering { 1, vertices\n edges\n 3\n }\nVERTICES")),
      "line 6: 'hovering' is not known and was skipped");
  EXPECT_EQ(warning_of(replaced(replaced(kDouble, "1 0 -0.75", "1 0 -0.75 weight { 2,\n3 }"),
                                "2 0 0.75", "2 0 0.75 weight 4")),
            "line 7: 'weight' is not known and was skipped, here and in 1 more places");
  const std::string declared = "define vertex attribute weight real[2]\n"
                               "constraint 1\nformula: x^2 + y^2 = 1\nenergy:\ne1: y\ne2: 0\n"
                               "quantity q info_only method m global\n"
                               "view_matrix\n1 0 0\n0 1 0\n0 0 1\nVERTICES";
  EXPECT_EQ(warning_of(replaced(replaced(kDouble, "VERTICES", declared), "1 0 -0.75",
                                "1 0 -0.75 weight { 2,\n3 } color 4")),
            "0 warnings");
  EXPECT_EQ(warning_of(replaced(kDouble, "1 0 -0.75", "1 0 -0.75 fixed")),
            "line 7: 'fixed' is not kept: vertex 1 moves with the foam");
  EXPECT_EQ(warning_of(replaced(kTorus, "1 1 2 * *", "1 1 2")),
            "line 11: edge 1 says nothing of its wraps, which is taken as none");
  EXPECT_EQ(warning_of(replaced(kTorus, "2 2 1 + +", "2 2 1 ++"))
                .find("line 12: ++ is read as two wraps"),
            0u);
  EXPECT_EQ(warning_of(replaced(kTorus, "VOLUME 9", "VOLUME 8.95"))
                .find("the VOLUMEs of the bodies do not fill"),
            0u);
}

TEST(EvolverFile, RoundTripKeepsTheFoam) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic}) {
    Foam foam = random_foam(40, boundary, 3);
    foam.time = 1.5;
    pull_unevenly(foam, 0.1, 2);
    equilibrate(foam);
    const EvolverFoam back = read(write_evolver(foam));
    EXPECT_TRUE(back.warnings.empty());
    EXPECT_EQ(back.foam.position, foam.position);
    EXPECT_EQ(back.foam.half_bubble, foam.half_bubble);
    EXPECT_EQ(back.foam.bubble_id, foam.bubble_id);
    EXPECT_EQ(back.foam.film_tension, foam.film_tension);
    EXPECT_EQ(back.foam.surroundings, foam.surroundings);
    EXPECT_EQ(back.foam.time, 1.5);
    EXPECT_NEAR(back.foam.energy(), foam.energy(), 1e-13 * foam.energy());
  }
}

TEST(EvolverFile, IsKnownByItsHeader) {
  using evolver::is_string_model;
  EXPECT_TRUE(is_string_model(kDouble));
  EXPECT_TRUE(is_string_model(kTorus.substr(0, kTorus.find("EDGES"))));
  EXPECT_FALSE(is_string_model(replaced(kDouble, "STRING", "SOAPFILM")));
  EXPECT_FALSE(is_string_model("STRING\n"));
  EXPECT_FALSE(is_string_model("ITEM: TIMESTEP\n0\nstring \"\n"));
  EXPECT_FALSE(is_string_model(""));
}

/// Whatever a file holds, it is an error that is told or a foam that is one.
TEST(EvolverFile, DamageIsAnErrorOrAFoam) {
  std::mt19937 random(1);
  const auto pick = [&](std::size_t n) { return static_cast<std::size_t>(random() % n); };
  const std::vector<std::string> pieces = {"-",
                                           "+",
                                           "*",
                                           "(",
                                           ")",
                                           "{",
                                           "}",
                                           "\"",
                                           "\\\n",
                                           "\n",
                                           "//",
                                           "/*",
                                           "*/",
                                           "#define a a\n",
                                           "1e999",
                                           "-1",
                                           "0",
                                           "99999999999999999999",
                                           "1 / 0",
                                           "wrap 65",
                                           "volume",
                                           "faces\n",
                                           "edges\n",
                                           "read\n",
                                           "torus\n",
                                           "periods\n",
                                           "tension 2",
                                           "fixed",
                                           ".",
                                           "0x",
                                           "1b",
                                           "? 1 :",
                                           "=",
                                           std::string(1, '\0'),
                                           "\xff",
                                           "define",
                                           "quadratic\n",
                                           "original 1",
                                           "lagrange_multiplier nan"};
  int foams = 0;
  const std::vector<std::string> valid = {kDouble, kTorus,
                                          write_evolver(random_foam(6, Boundary::Periodic))};
  for (int trial = 0; trial < 20000; ++trial) {
    std::string text = valid[pick(valid.size())];
    for (auto strikes = 1 + pick(3); strikes > 0; --strikes) {
      const std::size_t from = pick(text.size());
      const std::size_t length = std::min(pick(12), text.size() - from);
      switch (pick(4)) {
      case 0:
        text[from] = static_cast<char>(pick(256));
        break;
      case 1:
        text.erase(from, length);
        break;
      case 2:
        text.insert(from, pieces[pick(pieces.size())]);
        break;
      default:
        text.insert(pick(text.size()), text.substr(from, length));
      }
    }
    try {
      const EvolverFoam damaged = read(text);
      EXPECT_TRUE(validate(damaged.foam).empty()) << text;
      write_evolver(damaged.foam);
      ++foams;
    } catch (const FoamError& error) {
      EXPECT_NE(std::string(error.what()), "");
    }
  }
  EXPECT_GT(foams, 1000); // else nothing but errors was tried
}

} // namespace
} // namespace foam::test
