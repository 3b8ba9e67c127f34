// SPDX-License-Identifier: GPL-3.0-or-later
// Foams of few bubbles, to their end.
#include "../small_foams.h"

#include "topology/operations.h"

namespace foam::test {
namespace {

TEST(SmallFoams, AreInEquilibriumToTheirEnd) {
  int runs = 0;
  for (std::uint64_t seed = 1; seed <= 40; ++seed) {
    runs += run_at_random(seed, 20, 120) > 0 ? 1 : 0;
  }
  EXPECT_GT(runs, 30);
}

/// In each of these a bubble between a wall and a film is so thin, and all but done with growing
/// and shrinking, that it has less gas than a bubble elsewhere that is to vanish loses in a step.
TEST(SmallFoams, ThinBubblesOnWallsLoseNoMoreThanTheyHave) {
  for (const std::uint64_t seed : {2070034, 2090054}) {
    EXPECT_GT(run_at_random(seed, 300, 400), 0);
  }
}

Foam on_a_square(Index bubbles, std::uint64_t seed) {
  BuildOptions options;
  options.boundary = Boundary::Periodic;
  const double side = std::ceil(std::sqrt(bubbles));
  options.torus = Lattice::rectangle(0, side, 0, side);
  return build_from_points(jittered_grid(bubbles, 1, 1, seed), options);
}

/// Whether a bubble lies on both sides of a film.
bool touches_itself(const Foam& foam, Film film) {
  return foam.left(film.half()) == foam.right(film.half());
}

TEST(SmallTorus, ABubbleMayTouchItsOwnImages) {
  int touching = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    const Foam foam = on_a_square(3 + static_cast<Index>(seed % 4), seed);
    for (const Film f : foam.film_slots()) {
      if (!can_perform_t1(foam, f)) {
        continue;
      }
      Foam swapped = foam;
      perform_t1(swapped, f);
      EXPECT_TRUE(validate(swapped).empty()) << seed << ": " << validate(swapped).front();
      EXPECT_NEAR(sum(swapped, [&](Bubble b) { return swapped.area(b); }),
                  foam.surroundings.lattice.area(), 1e-12);
      touching += touches_itself(swapped, f) ? 1 : 0;
      if (can_perform_t1(swapped, f)) {
        perform_t1(swapped, f);
        for (const Half h : foam.half_slots()) {
          EXPECT_TRUE(swapped.left(h) == foam.left(h) || swapped.left(h) == foam.left(h.twin()));
        }
        EXPECT_EQ(swapped.sides, foam.sides);
      }
    }
  }
  EXPECT_GT(touching, 20);
}

/// A frame may be longer than all that happens in the foam, be it a second for bubbles of a
/// micrometre.
TEST(SmallTorus, ComesToRestInAFrameOfAnyLength) {
  for (const double time_step : {1e3, 1e9, 1e300}) {
    Foam foam = on_a_square(8, 3);
    equilibrate(foam);
    CoarseningOptions options;
    options.time_step = time_step;
    const auto coarsening = make_coarsening(options);
    coarsening->restart(foam);
    ASSERT_TRUE(coarsening->advance({}));
    expect_equilibrium(coarsening->foam());
    EXPECT_LT(coarsening->foam().bubble_count(), 8);
    for (const Bubble b : coarsening->foam().bubble_slots()) {
      EXPECT_TRUE(!coarsening->foam().has_bubble(b) || coarsening->foam().sides[b] == 6);
    }
  }
}

/// The last bubble of a torus is a hexagon, whose three films join the corners of a triangle of
/// periods to its Fermat point. With sides a, b, c and area Δ their length is √((a² + b² + c²)/2 +
/// 2√3·Δ), and with right angles and the periods s, s, √2·s it is √(2 + √3)·s.
TEST(SmallTorus, TheLastBubbleIsAHexagon) {
  int hexagons = 0;
  for (const Stepping stepping : {Stepping::Events, Stepping::FixedSteps}) {
    for (std::uint64_t seed = 1; seed <= 12; ++seed) {
      Foam foam = on_a_square(9, seed);
      equilibrate(foam);
      CoarseningOptions options;
      options.stepping = stepping;
      options.time_step = 0.1;
      const auto coarsening = make_coarsening(options);
      coarsening->restart(foam);
      for (int frame = 0; frame < 300 && coarsening->foam().bubble_count() > 1; ++frame) {
        ASSERT_TRUE(coarsening->advance({})) << reason(*coarsening->foam().ended);
      }
      const Foam& last = coarsening->foam();
      if (last.bubble_count() == 1) {
        ++hexagons;
        expect_equilibrium(last);
        expect_valid(last);
        EXPECT_EQ(*std::ranges::max_element(last.sides), 6);
        EXPECT_NEAR(last.energy(), 0.5 * std::sqrt(2 + std::sqrt(3.0)) * 3, 1e-9);
        ASSERT_TRUE(coarsening->advance({}));
        EXPECT_NEAR(coarsening->foam().energy(), last.energy(), 1e-12) << "it stays what it is";
      }
    }
  }
  EXPECT_GT(hexagons, 4);
}

TEST(SmallFoams, AnEndSaysWhatStandsInTheWay) {
  for (const Stepping stepping : {Stepping::Events, Stepping::FixedSteps}) {
    CoarseningOptions options;
    options.stepping = stepping;
    options.time_step = 0.01;
    options.thresholds.kind = ThresholdKind::Absolute;
    const auto coarsening = make_coarsening(options);
    coarsening->restart(random_foam(6, Boundary::Free, 2));
    EXPECT_FALSE(coarsening->foam().ended);
    while (coarsening->advance({})) {
    }
    const Foam& foam = coarsening->foam();
    ASSERT_TRUE(foam.ended);
    const End& end = *foam.ended;
    EXPECT_EQ(end.bubbles, 2);
    EXPECT_EQ(end.sides, 2);
    EXPECT_EQ(end.limit.t2_area, 0.05);
    EXPECT_GT(end.area, 0.05);
    EXPECT_LT(end.area, 0.05 + 4 * von_neumann_constant(0.25, 1) * 0.01) << "one step away";
    const std::string text = reason(end);
    for (const char* part : {"bubble ", "2 sides", "0.05 cm²", "one of the last two", "T2Area"}) {
      EXPECT_NE(text.find(part), std::string::npos) << text;
    }
  }
}

/// How long a foam lives, s.
double life(const Foam& foam, const CoarseningOptions& options, End& end) {
  const auto coarsening = make_coarsening(options);
  coarsening->restart(foam);
  for (int frame = 0; frame < 20000 && coarsening->advance({}); ++frame) {
  }
  EXPECT_TRUE(coarsening->foam().ended);
  end = coarsening->foam().ended.value_or(End{});
  return coarsening->foam().time;
}

TEST(SmallFoams, LiveLongerIfTheirEndsAdviceIsTaken) {
  struct Advice {
    const char* words;
    Foam foam;
    ThresholdOptions asked;
    double time_step;
    ThresholdOptions taken;
    double shorter_step;
  };
  const ThresholdOptions small{ThresholdKind::Absolute, 0.025, 1e-3, 0.05};
  const ThresholdOptions large{ThresholdKind::Absolute, 0.025, 0.2, 0.05};
  const ThresholdOptions relative{ThresholdKind::Relative, 0, 0, 0.5};
  const ThresholdOptions less{ThresholdKind::Relative, 0, 0, 0.05};
  const ThresholdOptions least{ThresholdKind::Absolute, 0, 0, 0.05};
  const Foam six = random_foam(6, Boundary::Free, 2);
  Foam two = double_bubble(1, 0.01);
  equilibrate(two);
  const std::array cases{
      Advice{". A smaller T2Area lets", six, large, 1e-3, small, 1e-3},
      Advice{". A smaller TimeStep shows more", six, small, 0.1, small, 0.01},
      Advice{". A smaller Alpha lets", six, relative, 1e-3, less, 1e-3},
      Advice{". A smaller T2Area, with Thresholds Absolute, lets", two, {}, 2e-5, least, 2e-5},
      Advice{"other bubbles as well: a smaller TimeStep", six, small, 5, small, 0.1}};
  for (const Advice& advice : cases) {
    SCOPED_TRACE(advice.words);
    CoarseningOptions options;
    options.thresholds = advice.asked;
    options.time_step = advice.time_step;
    End end;
    const double before = life(advice.foam, options, end);
    EXPECT_EQ(end.cause, End::Cause::LastTwo);
    EXPECT_NE(reason(end).find(advice.words), std::string::npos) << reason(end);
    options.thresholds = advice.taken;
    options.time_step = advice.shorter_step;
    EXPECT_GT(life(advice.foam, options, end), before);
  }
}

/// A threshold that is the least there is cannot be smaller.
TEST(SmallFoams, AnEndKnowsTheLeastThresholds) {
  CoarseningOptions options;
  options.thresholds = {ThresholdKind::Absolute, 0, 0, 0.05};
  options.time_step = 1e-5;
  Foam start = double_bubble(1, 3e-4);
  equilibrate(start);
  End end;
  life(start, options, end);
  EXPECT_EQ(end.cause, End::Cause::LastTwo);
  EXPECT_TRUE(end.least_t2_area);
  EXPECT_GT(end.limit.t2_area, 0);
  EXPECT_EQ(reason(end).find("T2Area"), std::string::npos) << reason(end);
}

} // namespace
} // namespace foam::test
