// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/validate.h"

#include <gtest/gtest.h>

#include <functional>
#include <limits>
#include <random>
#include <string>

#include "base/error.h"
#include "construct/jittered_grid.h"
#include "hand_made.h"

namespace foam {
namespace {

Foam sample(Boundary boundary) {
  BuildOptions options;
  options.boundary = boundary;
  return build_from_points(jittered_grid(20, 1, 1, 1), options);
}

struct Damage {
  std::string name;
  std::function<void(Foam&)> do_it;
};

const std::vector<Damage>& damages() {
  static const std::vector<Damage> list = {
      {"bubble's half-film of another bubble",
       [](Foam& f) { f.bubble_half[Bubble(3)] = f.bubble_half[Bubble(4)]; }},
      {"bubble's half-film out of range", [](Foam& f) { f.bubble_half[Bubble(3)] = Half(10000); }},
      {"bubble gone, films left", [](Foam& f) { f.bubble_half[Bubble(3)] = kNone; }},
      {"wrong number of sides", [](Foam& f) { f.sides[Bubble(5)] += 1; }},
      {"sides too short", [](Foam& f) { f.sides.pop_back(); }},
      {"pressure too short", [](Foam& f) { f.pressure.pop_back(); }},
      {"target area too long", [](Foam& f) { f.target_area.push_back(1); }},
      {"ids too short", [](Foam& f) { f.bubble_id.pop_back(); }},
      {"half-film of another junction",
       [](Foam& f) { f.half_junction[Half(8)] = f.half_junction[Half(9)]; }},
      {"half-film's junction out of range",
       [](Foam& f) { f.half_junction[Half(8)] = Junction(10000); }},
      {"half-film's junction far below zero",
       [](Foam& f) { f.half_junction[Half(8)] = Junction(-7); }},
      {"half a film gone", [](Foam& f) { f.half_junction[Half(8)] = kNone; }},
      {"film gone, junctions left",
       [](Foam& f) { f.half_junction[Half(8)] = f.half_junction[Half(9)] = kNone; }},
      {"half-films' junctions too short", [](Foam& f) { f.half_junction.pop_back(); }},
      {"bubbles along a film exchanged",
       [](Foam& f) { std::swap(f.half_bubble[Half(8)], f.half_bubble[Half(9)]); }},
      {"half-film's bubble out of range", [](Foam& f) { f.half_bubble[Half(8)] = Bubble(10000); }},
      {"half-film's bubble far below zero", [](Foam& f) { f.half_bubble[Half(8)] = Bubble(-7); }},
      {"half-film beside an outside that there is not",
       [](Foam& f) { f.half_bubble[Half(8)] = Bubble(Outside(1)); }},
      {"half-films' bubbles too short", [](Foam& f) { f.half_bubble.pop_back(); }},
      {"film angles too short", [](Foam& f) { f.film_angle.pop_back(); }},
      {"fewer tensions than films", [](Foam& f) { f.film_tension.assign(3, 0.5); }},
      {"wraps too short", [](Foam& f) { f.film_wrap.pop_back(); }},
      {"film wrapped around the torus", [](Foam& f) { f.film_wrap[Film(4)].y += 1; }},
      {"positions too short", [](Foam& f) { f.position.pop_back(); }},
      {"clockwise junction",
       [](Foam& f) {
         std::swap(f.junction_half[Junction(6)][0], f.junction_half[Junction(6)][1]);
       }},
      {"half-film twice in a junction",
       [](Foam& f) { f.junction_half[Junction(6)][0] = f.junction_half[Junction(6)][1]; }},
      {"junction with a half-film out of range",
       [](Foam& f) { f.junction_half[Junction(6)][2] = Half(10000); }},
      {"junction with a half-film below zero",
       [](Foam& f) { f.junction_half[Junction(6)][2] = Half(-7); }},
      {"junction gone, films left",
       [](Foam& f) {
         f.junction_half[Junction(6)] = {kNone, kNone, kNone};
       }},
      {"junctions too short", [](Foam& f) { f.junction_half.pop_back(); }},
  };
  return list;
}

class AnyBoundary : public testing::TestWithParam<Boundary> {};
INSTANTIATE_TEST_SUITE_P(Boundaries, AnyBoundary,
                         testing::Values(Boundary::Free, Boundary::Periodic, Boundary::Fixed));

TEST_P(AnyBoundary, ReportsDamageToEachArray) {
  const Foam valid = sample(GetParam());
  EXPECT_TRUE(validate(valid).empty());
  for (const Damage& damage : damages()) {
    Foam foam = valid;
    damage.do_it(foam);
    const auto problems = validate(foam);
    EXPECT_FALSE(problems.empty()) << damage.name;
    for (const auto& problem : problems) {
      EXPECT_FALSE(problem.empty()) << damage.name;
    }
  }
}

TEST_P(AnyBoundary, SurvivesRandomDamage) {
  const Foam valid = sample(GetParam());
  std::mt19937 random(1);
  const auto value = [&]() { return static_cast<Index>(random() % 80) - 3; };
  const auto any = [&]<class Element, class T>(Field<Element, T>& field) -> T& {
    return field[Element(static_cast<Index>(random() % field.size()))];
  };
  for (int trial = 0; trial < 5000; ++trial) {
    Foam foam = valid;
    for (unsigned n = random() % 4; n-- > 0;) {
      switch (random() % 5) {
      case 0:
        any(foam.bubble_half) = Half(value());
        break;
      case 1:
        any(foam.half_junction) = Junction(value());
        break;
      case 2:
        any(foam.half_bubble) = Bubble(value());
        break;
      case 3:
        any(foam.junction_half)[random() % 3] = Half(value());
        break;
      default:
        any(foam.sides) = value();
      }
    }
    validate(foam);
  }
}

TEST(Validate, APlaneIsNoTorus) {
  Foam foam = sample(Boundary::Free);
  foam.surroundings = {Boundary::Periodic, Lattice::rectangle(0, 10, 0, 10)};
  EXPECT_FALSE(validate(foam).empty());
}

TEST(Validate, ABubbleOfTwoLoopsIsReported) {
  // Two separate foams that share a bubble's number.
  FilmSet set;
  set.surface_tension = 0.25;
  set.junctions = {{0, -1}, {0, 1}, {5, -1}, {5, 1}};
  set.films = {{0, 1, 0, 1, 0, {}}, {1, 0, 0, -1, 1, {}}, {0, 1, 1, -1, 1, {}},
               {2, 3, 0, 2, 0, {}}, {3, 2, 0, -1, 1, {}}, {2, 3, 2, -1, 1, {}}};
  set.bubbles = {{0, 0, 1}, {1, 0, 1}, {2, 0, 1}};
  try {
    foam_of(set);
    FAIL();
  } catch (const FoamError& error) {
    EXPECT_STREQ(error.what(), "bubble 0 is bounded by more than one loop of films");
  }
}

TEST(ValidateGeometry, ReportsFilmsOutOfOrder) {
  Foam foam = honeycomb(4, 2);
  EXPECT_TRUE(validate_geometry(foam).empty());
  foam.film_angle[Film(5)] = 2.5; // turns the film's ends past their neighbours
  EXPECT_FALSE(validate_geometry(foam).empty());
}

TEST(ValidateGeometry, ReportsABubbleInsideOut) {
  Foam foam = honeycomb(4, 2);
  for_each_half(foam, Bubble(3), [&](Half h) { foam.set_half_angle(h, -2); });
  const auto problems = validate_geometry(foam);
  EXPECT_TRUE(std::ranges::any_of(
      problems, [](const auto& p) { return p.find("the area of bubble 3 is -") == 0; }));
}

TEST(ValidateGeometry, ReportsAPlaceThatIsNoNumber) {
  Foam foam = honeycomb(4, 2);
  foam.position[Junction(2)].x = std::numeric_limits<double>::quiet_NaN();
  EXPECT_FALSE(validate_geometry(foam).empty());
}

} // namespace
} // namespace foam
