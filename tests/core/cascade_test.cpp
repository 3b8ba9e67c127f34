// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "hand_made.h"
#include "thesis/algorithms.h"
#include "topology/cascade.h"
#include "topology/operations.h"

namespace foam {
namespace {

/// Rules that check the foam whenever they are asked, which is after every change.
CollapseRules checked(const CollapseRules& rules) {
  const auto check = [](auto rule) {
    return [rule](const Foam& foam, auto element) {
      expect_valid(foam);
      return rule && rule(foam, element);
    };
  };
  return {check(rules.t1), check(rules.t2), check(rules.t3)};
}

template <class Element> bool always(const Foam&, Element) {
  return true;
}
void nothing(Foam&, Junction) {}

bool small(const Foam& foam, Bubble bubble) {
  return foam.target_area[bubble] < 1;
}

/// The bubbles of Figure 4.5: C in a corner of B, which sits in a corner of A, which sits where
/// three large bubbles meet. A T2 of C makes B three-sided, and that of B makes A so.
struct Nested {
  static constexpr Bubble kA{3}, kB{4}, kC{5};
  Foam foam = foam_of_polygons({{0, 9},
                                {-8, -4.5},
                                {8, -4.5}, // 0–2, outside
                                {-0.6, -0.4},
                                {0.6, -0.4}, // 3, 4 of A
                                {-0.25, 0.4},
                                {0.25, 0.4}, // 5, 6 of A and B
                                {0, 0.9},
                                {-0.05, 0.8},
                                {0.05, 0.8}}, // 7 of C, 8 and 9 of B and C
                               {{7, 0, 1, 3, 5, 8},
                                {1, 2, 4, 3},
                                {2, 0, 7, 9, 6, 4},
                                {5, 3, 4, 6},
                                {8, 5, 6, 9},
                                {7, 8, 9}});
};

TEST(Cascade, FollowsT2AfterT2) { // Figure 4.5
  Nested nested;
  Foam& foam = nested.foam;
  const CascadeResult result =
      topological_cascade(foam, checked({.t1 = {}, .t2 = small, .t3 = {}}));
  EXPECT_EQ(foam.t2_count, 3);
  EXPECT_FALSE(foam.has_bubble(Nested::kA) || foam.has_bubble(Nested::kB) ||
               foam.has_bubble(Nested::kC));
  EXPECT_EQ(result.bubbles, (std::vector{Bubble(0), Bubble(1), Bubble(2)}));
  EXPECT_TRUE(result.changed());
  expect_valid(foam);
}

TEST(Cascade, StartsFromTheBubblesGiven) {
  Nested nested;
  const CollapseRules rules = checked({.t1 = {}, .t2 = small, .t3 = {}});
  const Bubble b[] = {Nested::kB}; // four-sided: nothing to do
  EXPECT_FALSE(topological_cascade(nested.foam, rules, {}, b).changed());
  const Bubble c[] = {Nested::kC};
  EXPECT_TRUE(topological_cascade(nested.foam, rules, {}, c).changed());
  EXPECT_EQ(nested.foam.t2_count, 3);
}

TEST(ImprovedAlgorithm, RepeatsUntilNothingGivesWay) {
  Nested nested;
  improved_algorithm(nested.foam, checked({.t1 = {}, .t2 = small, .t3 = {}}));
  EXPECT_EQ(nested.foam.t2_count, 3);
}

TEST(OriginalAlgorithm, MissesACascade) {
  Nested nested;
  Foam& foam = nested.foam;
  std::set<Junction> equilibrated;
  original_algorithm(foam, checked({.t1 = {}, .t2 = small, .t3 = {}}),
                     [&](Foam&, Junction j) { equilibrated.insert(j); });
  EXPECT_FALSE(foam.has_bubble(Nested::kC));
  EXPECT_TRUE(foam.has_bubble(Nested::kA)); // its junctions came before
  EXPECT_TRUE(equilibrated.contains(Junction(3)) && equilibrated.contains(Junction(4)));
  EXPECT_FALSE(equilibrated.contains(Junction(7))); // gave way instead
  expect_valid(foam);
}

/// The situation of Figure 4.7: a four-sided bubble, one of whose films wants a T1, and after it a
/// film that ends in the bubble.
struct TwoT1s {
  Foam foam = honeycomb(6, 3);
  Bubble bubble{8};
  Film first = kNone, second = kNone;
  std::set<Film> wanted;

  TwoT1s() {
    while (foam.sides[bubble] > 4) {
      perform_t1(foam, foam.bubble_half[bubble].film());
    }
    for_each_half(foam, bubble, [&](Half side) {
      for_each_half(foam, bubble, [&](Half h) {
        const Film side_film = side.film();
        const Film spoke = foam.previous_around_junction(h).film();
        if (foam.start(h) != foam.start(side) && foam.start(h) != foam.end(side) &&
            side_film < spoke) {
          first = side_film;
          second = spoke;
        }
      });
    });
    wanted = {first, second};
    foam.t1_count = 0;
  }

  /// Each film wants its T1 once; the bubble wants to vanish.
  CollapseRules rules() {
    return checked({.t1 = [this](const Foam&, Film film) { return wanted.erase(film) > 0; },
                    .t2 = [this](const Foam&, Bubble b) { return b == bubble; },
                    .t3 = {}});
  }
};

TEST(Cascade, PrefersAT2ToTheNextT1) { // Figure 4.7
  TwoT1s t;
  ASSERT_NE(t.first, kNone);
  topological_cascade(t.foam, t.rules());
  EXPECT_EQ(t.foam.t2_count, 1);
  EXPECT_FALSE(t.foam.has_bubble(t.bubble));
  expect_valid(t.foam);
}

TEST(ImprovedAlgorithm, LosesAT2BetweenTwoT1s) { // Figure 4.7
  TwoT1s t;
  ASSERT_NE(t.first, kNone);
  improved_algorithm(t.foam, t.rules());
  EXPECT_EQ(t.foam.t1_count, 2);
  EXPECT_EQ(t.foam.t2_count, 0);
  EXPECT_EQ(t.foam.sides[t.bubble], 4);
  expect_valid(t.foam);
}

TEST(Cascade, ReportsTheBubblesAroundAT1) {
  Foam foam = honeycomb(6, 3);
  const Film film[] = {Film(5)};
  const Half h = film[0].half();
  std::vector<Bubble> around{foam.left(h), foam.right(h), foam.left(foam.next_around_junction(h)),
                             foam.left(foam.next_around_junction(h.twin()))};
  std::ranges::sort(around);
  const CascadeResult result =
      topological_cascade(foam, checked({.t1 = always<Film>, .t2 = {}, .t3 = {}}), film, {});
  EXPECT_EQ(foam.t1_count, 1);
  EXPECT_EQ(result.bubbles, around);
}

/// A bubble of a honeycomb that has lost all but two of its sides.
Foam with_two_sided_bubble(Bubble bubble) {
  Foam foam = honeycomb(6, 3);
  while (foam.sides[bubble] > 2) {
    perform_t1(foam, foam.bubble_half[bubble].film());
  }
  foam.t1_count = 0;
  return foam;
}

TEST(Cascade, PerformsT3OnlyWhereTheRuleAsks) {
  Foam foam = with_two_sided_bubble(Bubble(8));
  expect_valid(foam);
  EXPECT_FALSE(
      topological_cascade(foam, checked({.t1 = {}, .t2 = always<Bubble>, .t3 = {}})).changed());
  const CascadeResult result =
      topological_cascade(foam, checked({.t1 = {}, .t2 = {}, .t3 = always<Bubble>}));
  EXPECT_EQ(foam.t3_count, 1);
  EXPECT_FALSE(foam.has_bubble(Bubble(8)));
  EXPECT_EQ(result.bubbles.size(), 2U);
  expect_valid(foam);
}

TEST(Cascade, TestsAgainTheFilmThatAT3Leaves) {
  Foam foam = with_two_sided_bubble(Bubble(8));
  const Bubble bubble[] = {Bubble(8)};
  std::set<Film> swapped;
  const auto once = [&](const Foam&, Film film) { return swapped.insert(film).second; };
  topological_cascade(foam, checked({.t1 = once, .t2 = {}, .t3 = always<Bubble>}), {}, bubble);
  EXPECT_EQ(foam.t3_count, 1);
  EXPECT_EQ(foam.t1_count, 1);
}

TEST(Cascade, EndsWhateverTheRulesSay) {
  for (const bool t3 : {false, true}) {
    Foam foam = honeycomb(8, 4);
    const Index films = foam.film_count();
    const Index bubbles = foam.bubble_count();
    topological_cascade(foam,
                        checked({.t1 = always<Film>,
                                 .t2 = always<Bubble>,
                                 .t3 = t3 ? always<Bubble> : decltype(&always<Bubble>){nullptr}}));
    EXPECT_LE(foam.t1_count, films + 3 * bubbles);
    EXPECT_GT(foam.t2_count + foam.t3_count, 0);
    expect_valid(foam);
  }
}

TEST(ThesisAlgorithms, EndWhateverTheRulesSay) {
  Foam original = honeycomb(8, 4);
  Foam improved = original;
  const CollapseRules rules =
      checked({.t1 = always<Film>, .t2 = always<Bubble>, .t3 = always<Bubble>});
  original_algorithm(original, rules, nothing);
  improved_algorithm(improved, rules);
  expect_valid(original);
  expect_valid(improved);
}

TEST(Cascade, DoesNothingWithoutRules) {
  Foam foam = honeycomb(4, 2);
  EXPECT_FALSE(topological_cascade(foam, {}).changed());
  EXPECT_EQ(foam.topology, honeycomb(4, 2).topology);
}

} // namespace
} // namespace foam
