// SPDX-License-Identifier: GPL-3.0-or-later
// Newton's frames against von Neumann's law, the conservation of gas, and the coarsening from event
// to event, a program of its own.
#include "coarsening/newton_frame_coarsening.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numeric>
#include <set>

#include "engines/engines.h"
#include "foams.h"

namespace foam::test {
namespace {

CoarseningOptions frames(double time_step = 1.0 / 30) {
  CoarseningOptions options = thesis_options();
  options.time_step = time_step;
  options.stepping = Stepping::FixedSteps;
  return options;
}

double room(const Foam& foam) {
  return sum(foam, [&](Bubble b) { return foam.area(b); });
}

/// A bubble and its neighbours.
std::set<Bubble> around(const Foam& foam, Bubble bubble) {
  std::set<Bubble> bubbles{bubble};
  for_each_half(foam, bubble, [&](Half h) { bubbles.insert(foam.right(h)); });
  return bubbles;
}

/// Bubbles with the same neighbours, of as many sides, in both foams: nothing has happened there.
std::vector<Bubble> undisturbed(const Foam& before, const Foam& after) {
  std::vector<Bubble> bubbles;
  for (const Bubble b : after.bubble_slots()) {
    if (after.has_bubble(b) && around(before, b) == around(after, b) &&
        std::ranges::all_of(around(after, b), [&](Bubble n) {
          return n.is_outside() || before.sides[n] == after.sides[n];
        })) {
      bubbles.push_back(b);
    }
  }
  return bubbles;
}

struct Setting {
  Boundary boundary;
  ThresholdOptions thresholds;
  double time_step = 1.0 / 30;
};

const ThresholdOptions kThesis = thesis_options().thresholds;

class NewtonFrames : public testing::TestWithParam<Setting> {};

TEST_P(NewtonFrames, AreEquilibriaThatKeepTheGas) {
  const Boundary boundary = GetParam().boundary;
  CoarseningOptions options = frames(GetParam().time_step);
  options.thresholds = GetParam().thresholds;
  NewtonFrameCoarsening coarsening(options);
  coarsening.restart(random_foam(100, boundary, 7));
  const double step = von_neumann_constant(0.25, 1) * options.time_step;
  const double start = gas(coarsening.foam());
  int law = 0;
  int bubbles = 0;
  for (int frame = 0; frame < 100; ++frame) {
    const std::string where = "frame " + std::to_string(frame) + ": ";
    const Foam before = coarsening.foam();
    ASSERT_TRUE(coarsening.advance({})) << where;
    const Foam& foam = coarsening.foam();
    expect_equilibrium(foam, where);
    expect_valid(foam, where);
    if (boundary != Boundary::Free) {
      EXPECT_NEAR(gas(foam) / room(foam), 1, 1e-12) << where;
    }
    bubbles += foam.bubble_count();
    for (const Bubble b : undisturbed(before, foam)) {
      if (boundary != Boundary::Fixed || !foam.bubble_on_outside(b)) {
        ++law;
        EXPECT_NEAR(foam.target_area[b] - before.target_area[b], step * (foam.sides[b] - 6), 1e-12)
            << where << "bubble " << b.index();
      }
    }
  }
  const Foam& foam = coarsening.foam();
  EXPECT_GT(law, bubbles / 4);
  EXPECT_GT(foam.t2_count, 25);
  EXPECT_GT(foam.t1_count, 25);
  // Where the last bubble between two contacts goes, the wall is straightened.
  if (boundary != Boundary::Free && (boundary == Boundary::Periodic || foam.t3_count == 0)) {
    EXPECT_NEAR(gas(foam) / start, 1, 1e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(
    NewtonFrame, NewtonFrames,
    testing::Values(Setting{Boundary::Free, kThesis}, Setting{Boundary::Periodic, kThesis},
                    Setting{Boundary::Fixed, kThesis}, Setting{Boundary::Periodic, {}},
                    Setting{Boundary::Free, {.kind = ThresholdKind::Relative}},
                    Setting{Boundary::Periodic, {.kind = ThresholdKind::Relative}},
                    Setting{Boundary::Fixed, {.kind = ThresholdKind::Relative}},
                    Setting{Boundary::Periodic,
                            {.kind = ThresholdKind::Absolute, .t1_length = 0, .t2_area = 0}},
                    Setting{Boundary::Fixed,
                            {.kind = ThresholdKind::Absolute, .t1_length = 0, .t2_area = 0}},
                    Setting{Boundary::Periodic,
                            {.kind = ThresholdKind::Absolute, .t1_length = 0.2, .t2_area = 0.3},
                            1.0 / 10}));

/// Both do the same as their steps get shorter: the difference is of the first order in the step.
TEST(NewtonFrame, GoesWhereStepsFromEventToEventGo) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic, Boundary::Fixed}) {
    const Foam start = random_foam(100, boundary, 3);
    const auto coarsened = [&](Stepping stepping, int steps) {
      CoarseningOptions options = frames(0.5 / steps);
      options.stepping = stepping;
      options.thresholds.t2_area = 0.002; // small: where a bubble's last gas goes is not the same
      const auto coarsening = make_coarsening(options);
      coarsening->restart(start);
      for (int frame = 0; frame < steps; ++frame) {
        EXPECT_TRUE(coarsening->advance({}));
      }
      return coarsening->foam();
    };
    const Foam expected = coarsened(Stepping::Events, 60);
    const auto difference = [&](int steps) {
      const Foam foam = coarsened(Stepping::FixedSteps, steps);
      EXPECT_EQ(foam.sides, expected.sides);
      EXPECT_EQ(foam.t2_count, expected.t2_count);
      return sum(foam, [&](Bubble b) { return std::abs(foam.area(b) - expected.area(b)); });
    };
    const double coarse = difference(15);
    EXPECT_LT(coarse, 0.1);
    EXPECT_LT(difference(120), coarse / 5);
    EXPECT_GT(expected.t2_count, 2);
  }
}

TEST(NewtonFrame, GivesTheSameBitsForAnyNumberOfThreads) {
  const Foam start = random_foam(80, Boundary::Periodic, 2);
  std::vector<Foam> foams;
  for (const int threads : {1, 2, 5}) {
    NewtonFrameCoarsening coarsening(frames(), threads, 40);
    coarsening.restart(start);
    for (int frame = 0; frame < 12; ++frame) {
      ASSERT_TRUE(coarsening.advance({}));
    }
    foams.push_back(coarsening.foam());
    EXPECT_EQ(foams.back().position, foams.front().position);
    EXPECT_EQ(foams.back().pressure, foams.front().pressure);
    EXPECT_EQ(foams.back().film_angle, foams.front().film_angle);
    EXPECT_EQ(foams.back().target_area, foams.front().target_area);
    EXPECT_EQ(foams.back().half_bubble, foams.front().half_bubble);
  }
  EXPECT_GT(foams.front().t1_count, 0);
  EXPECT_GT(foams.front().t2_count, 0);
}

TEST(NewtonFrame, GoesToTheLastTwoBubbles) {
  NewtonFrameCoarsening coarsening(frames(1.0 / 60));
  coarsening.restart(random_foam(40, Boundary::Free, 1));
  int frame = 0;
  while (coarsening.advance({})) {
    const std::string where = "frame " + std::to_string(++frame) + ": ";
    expect_valid(coarsening.foam(), where);
    expect_equilibrium(coarsening.foam(), where);
    ASSERT_LT(frame, 3000);
  }
  EXPECT_EQ(coarsening.foam().bubble_count(), 2);
  ASSERT_TRUE(coarsening.foam().ended);
  EXPECT_EQ(coarsening.foam().ended->cause, End::Cause::LastTwo);
}

TEST(NewtonFrame, DoubleBubbleLivesItsTime) {
  Foam foam = double_bubble(0.5, 1);
  equilibrate(foam);
  const double lifetime = 0.5 / (4 * von_neumann_constant(0.5, 1));
  CoarseningOptions options = frames(lifetime / 100);
  options.thresholds.t2_area = 0;
  NewtonFrameCoarsening coarsening(options);
  coarsening.restart(foam);
  while (coarsening.advance({})) {
    const double gone = 0.5 * coarsening.foam().time / lifetime;
    EXPECT_NEAR(coarsening.foam().area(Bubble(0)), 0.5 - gone, 1e-9);
    EXPECT_NEAR(coarsening.foam().area(Bubble(1)), 1 - gone, 1e-9);
  }
  EXPECT_NEAR(coarsening.foam().time, lifetime, 1.01 * lifetime / 100);
}

TEST(NewtonFrame, LeavesTheFoamAsItWasWhenItIsAborted) {
  const Foam start = random_foam(50, Boundary::Periodic, 1);
  NewtonFrameCoarsening coarsening(frames());
  coarsening.restart(start);
  EXPECT_THROW(coarsening.advance([] { return true; }), Aborted);
  EXPECT_EQ(coarsening.foam().position, start.position);
  EXPECT_EQ(coarsening.foam().target_area, start.target_area);
}

/// A double bubble with a lens, bubble 2, on the film between its two, in equilibrium.
Foam double_bubble_with_lens() {
  FilmSet set;
  set.surface_tension = 0.25;
  set.junctions = {{0, -0.6}, {0, 0.6}, {0, -0.25}, {0, 0.25}};
  set.films = {{0, 2, 0, 1, 0.0, {}}, {3, 1, 0, 1, 0.0, {}},  {2, 3, 0, 2, -1.0, {}},
               {2, 3, 2, 1, 1.0, {}}, {1, 0, 0, -1, 1.3, {}}, {0, 1, 1, -1, 1.3, {}}};
  set.bubbles = {{0, 0.0, 1}, {1, 0.0, 1.2}, {2, 0.0, 0.2}};
  Foam foam = foam_of(set);
  make_equilibrator({})->equilibrate(foam, 0, {});
  return foam;
}

TEST(NewtonFrame, RemovesTwoSidedBubblesAtTheirTime) {
  const Foam start = double_bubble_with_lens();
  expect_equilibrium(start);
  NewtonFrameCoarsening coarsening(frames(0.004));
  coarsening.restart(start);
  const double step = 4 * von_neumann_constant(0.25, 1) * 0.004;
  for (int frame = 0; coarsening.foam().has_bubble(Bubble(2)); ++frame) {
    EXPECT_EQ(coarsening.foam().sides[Bubble(2)], 2);
    EXPECT_NEAR(coarsening.foam().target_area[Bubble(2)], 0.2 - frame * step, 1e-12);
    const double before = coarsening.foam().target_area[Bubble(2)];
    ASSERT_TRUE(coarsening.advance({}));
    expect_equilibrium(coarsening.foam());
    expect_valid(coarsening.foam());
    EXPECT_EQ(coarsening.foam().has_bubble(Bubble(2)), before > 0.05) << before;
  }
  EXPECT_EQ(coarsening.foam().t3_count, 1);
}

TEST(NewtonFrame, SlidesTwoSidedBubblesToACorner) {
  CoarseningOptions options = frames(0.004);
  options.two_sided_bubbles = TwoSidedBubbles::Slide;
  NewtonFrameCoarsening coarsening(options);
  coarsening.restart(double_bubble_with_lens());
  ASSERT_TRUE(coarsening.advance({}));
  expect_equilibrium(coarsening.foam());
  expect_valid(coarsening.foam());
  EXPECT_EQ(coarsening.foam().sides, (Field<Bubble, Index>{3, 3, 3})) << "a triple bubble";
}

/// A bubble that cannot give way, here because nobody asks it to, keeps its gas, which is taken
/// from all others in proportion to theirs.
TEST(NewtonFrame, ABubbleThatWouldLoseTooMuchKeepsItsGas) {
  Foam foam = random_foam(50, Boundary::Periodic, 1);
  const auto five = std::ranges::find(foam.sides, 5) - foam.sides.begin();
  const Bubble small(static_cast<Index>(five));
  foam.target_area[small] = 1e-4;
  const Field<Bubble, double> before = foam.target_area;
  const ConstFoamView mesh = const_view(view_of(foam));
  const NewtonRules rules{.rate = area_rate(mesh, 1), .time_step = 0.01};
  const detail::AdmissibleRate rate{rules};
  Host host;
  const double step = von_neumann_constant(0.25, 1) * 0.01;
  diffuse(host, view_of(foam), rate, sum_bubbles(host, mesh, rate), 0.01);
  const double others = std::accumulate(before.begin(), before.end(), -before[small]);
  for (const Bubble b : foam.bubble_slots()) {
    EXPECT_NEAR(foam.target_area[b] - before[b],
                b == small ? 0 : step * (foam.sides[b] - 6 - before[b] / others), 1e-15);
  }
}

TEST(NewtonFrame, IsNewtonsCoarseningAtFixedSteps) {
  const Foam start = random_foam(50, Boundary::Free, 1);
  NewtonFrameCoarsening expected(frames());
  const auto made = make_coarsening(frames());
  for (Evolution* coarsening : {static_cast<Evolution*>(&expected), made.get()}) {
    coarsening->restart(start);
    EXPECT_TRUE(coarsening->advance({}));
  }
  EXPECT_EQ(made->foam().position, expected.foam().position);
  EXPECT_EQ(made->foam().time, 1.0 / 30);
}

} // namespace
} // namespace foam::test
