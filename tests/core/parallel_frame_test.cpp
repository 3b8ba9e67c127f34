// SPDX-License-Identifier: GPL-3.0-or-later
#include "thesis/parallel_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

#include "base/error.h"
#include "engines/engines.h"
#include "foams.h"
#include "junction_foams.h"
#include "parallel/host.h"
#include "thesis/frame_coarsening.h"

namespace foam {
namespace {

struct Setting {
  Boundary boundary;
  TwoSidedBubbles two_sided;
  bool energy_decay, orientation_invariant, relative;
  RootSearch root_search = RootSearch::Angles;
};

CoarseningOptions options_of(const Setting& setting) {
  CoarseningOptions options = test::thesis_options();
  options.two_sided_bubbles = setting.two_sided;
  options.topological_algorithm = TopologicalAlgorithm::Simultaneous;
  if (setting.relative) {
    options.thresholds.kind = ThresholdKind::Relative;
  }
  options.equilibrator.kind = EquilibratorKind::Junction;
  options.equilibrator.maximum_iterations = 32;
  options.equilibrator.junction.energy_decay = setting.energy_decay;
  options.equilibrator.junction.orientation_invariant = setting.orientation_invariant;
  options.equilibrator.junction.root_search = setting.root_search;
  return options;
}

class ParallelFrames : public testing::TestWithParam<Setting> {};

/// The serial frame, written for one foam in one memory, is an independent account of the same.
TEST_P(ParallelFrames, DoWhatSerialOnesDo) {
  const CoarseningOptions options = options_of(GetParam());
  Foam foam = test::jittered_foam(GetParam().boundary, 64, 3);
  FrameCoarsening serial(options, make_equilibrator(options.equilibrator));
  serial.restart(foam);
  Host host;
  ParallelFrame<Host> parallel(host, options);
  for (int frame = 0; frame < 15; ++frame) {
    const FrameResult result = parallel.advance([&] { return view_of(foam); }, {});
    ASSERT_EQ(result.performed(), serial.advance({}));
    if (!result.performed()) {
      EXPECT_GT(frame, 5);
      EXPECT_EQ(result.end->cause, serial.foam().ended->cause);
      EXPECT_NEAR(result.end->area_ahead, serial.foam().ended->area_ahead,
                  1e-6 * std::abs(result.end->area_ahead));
      break;
    }
    note_operations(foam, result);
    const Foam& expected = serial.foam();
    ASSERT_EQ(foam.t1_count, expected.t1_count) << frame;
    ASSERT_EQ(foam.t2_count, expected.t2_count) << frame;
    ASSERT_EQ(foam.t3_count, expected.t3_count) << frame;
    ASSERT_EQ(foam.half_junction, expected.half_junction) << frame;
    EXPECT_EQ(result.report.iterations, expected.report.iterations);
    EXPECT_EQ(result.report.converged, expected.report.converged);
    for (const Film f : foam.film_slots()) {
      if (foam.has_film(f)) {
        ASSERT_NEAR(foam.length(f.half()), expected.length(f.half()), 1e-10);
      }
    }
  }
  EXPECT_GT(foam.t1_count + foam.t2_count, 0);
}

INSTANTIATE_TEST_SUITE_P(
    ParallelFrame, ParallelFrames,
    testing::Values(Setting{Boundary::Free, TwoSidedBubbles::Remove, true, false, false},
                    Setting{Boundary::Free, TwoSidedBubbles::Slide, true, true, false},
                    Setting{Boundary::Free, TwoSidedBubbles::Remove, true, false, false,
                            RootSearch::Energies},
                    Setting{Boundary::Periodic, TwoSidedBubbles::Remove, false, false, true},
                    Setting{Boundary::Periodic, TwoSidedBubbles::Slide, true, false, false},
                    Setting{Boundary::Fixed, TwoSidedBubbles::Remove, true, false, false},
                    Setting{Boundary::Fixed, TwoSidedBubbles::Slide, false, true, true}));

TEST(ParallelFrame, DoesNotDependOnTheNumberOfThreads) {
  const CoarseningOptions options =
      options_of({Boundary::Free, TwoSidedBubbles::Remove, true, true, false});
  const auto coarsened = [&](int threads) {
    Foam foam = test::jittered_foam(Boundary::Free, 500, 1);
    Host host(threads, 128);
    ParallelFrame<Host> frame(host, options);
    for (int i = 0; i < 3; ++i) {
      EXPECT_TRUE(frame.advance([&] { return view_of(foam); }, {}).performed());
    }
    return foam;
  };
  const Foam one = coarsened(1);
  for (const int threads : {2, 7}) {
    const Foam many = coarsened(threads);
    EXPECT_EQ(one.position, many.position);
    EXPECT_EQ(one.pressure, many.pressure);
    EXPECT_EQ(one.half_bubble, many.half_bubble);
  }
}

TEST(ParallelFrame, EndsWithADoubleBubble) {
  CoarseningOptions options =
      options_of({Boundary::Free, TwoSidedBubbles::Remove, true, false, false});
  options.thresholds.t2_area = 2;
  FilmSet set;
  set.surface_tension = 0.25;
  set.junctions = {{0, -0.5}, {0, 0.5}};
  set.films = {{0, 1, 0, 1, 0.0, {}}, {1, 0, 0, -1, 1.3, {}}, {0, 1, 1, -1, 1.3, {}}};
  set.bubbles = {{0, 0.0, 1}, {1, 0.0, 3}};
  Foam foam = foam_of(set);
  Host host;
  EXPECT_FALSE(
      ParallelFrame<Host>(host, options).advance([&] { return view_of(foam); }, {}).performed());
}

TEST(ParallelFrame, RefusesFilmsOfTheirOwnTension) {
  Foam foam = test::jittered_foam(Boundary::Free, 30, 1);
  foam.film_tension.assign(foam.film_angle.size(), 0.6);
  Host host;
  ParallelFrame<Host> frame(
      host, options_of({Boundary::Free, TwoSidedBubbles::Remove, true, false, false}));
  EXPECT_THROW(frame.advance([&] { return view_of(foam); }, {}), FoamError);
}

TEST(ParallelFrame, StopsWhenAborted) {
  Foam foam = test::jittered_foam(Boundary::Free, 30, 1);
  Host host;
  ParallelFrame<Host> frame(
      host, options_of({Boundary::Free, TwoSidedBubbles::Remove, true, false, false}));
  EXPECT_THROW(frame.advance([&] { return view_of(foam); }, [] { return true; }), Aborted);
}

// The order in which junctions move.

TEST(UpdateOrder, NobodyWithinReachIsInTheSameWave) {
  const Foam foam = test::jittered_foam(Boundary::Free, 2000, 1);
  const ConstFoamView mesh = view_of(foam);
  Host host;
  thesis::UpdateOrder<Host> order(host);
  for (const int reach : {1, 2}) {
    order.find(mesh, reach);
    EXPECT_LT(order.waves(), 60);
    for (const Junction j : mesh.junction_slots()) {
      for (const Half half : mesh.junction_half[j]) {
        const Junction near = mesh.end(half);
        EXPECT_NE(order.wave()[j], order.wave()[near]);
        for (const Half second : mesh.junction_half[near]) {
          const Junction far = mesh.end(second);
          EXPECT_TRUE(reach == 1 || far == j || order.wave()[j] != order.wave()[far]);
        }
      }
    }
  }
  order.find(mesh, 0);
  EXPECT_EQ(order.waves(), 1);
}

TEST(UpdateOrder, WavesDoWhatMovingOneAfterTheOtherDoes) {
  JunctionOptions options;
  for (const bool orientation : {false, true}) {
    options.orientation_invariant = orientation;
    Foam waves = test::jittered_foam(Boundary::Free, 300, 2);
    disturb(waves, 0.1, 3);
    Foam serial = waves;
    Field<Junction, thesis::JunctionStep> step;
    std::vector<Junction> order;
    for (const Junction j : serial.junction_slots()) {
      step.push_back(thesis::junction_step(serial, j, options));
      order.push_back(j);
    }
    std::ranges::sort(order, {}, thesis::rank);
    for (const Junction j : order) {
      thesis::move_junction(serial, j, step[j], options);
    }
    Host host;
    thesis::JacobiSweep<Host> sweep(host, options);
    sweep.prepare(view_of(waves));
    sweep.sweep(view_of(waves));
    EXPECT_EQ(waves.position, serial.position);
  }
}

TEST(FoamView, GivesWhatTheFoamGives) {
  Foam foam = test::jittered_foam(Boundary::Periodic, 50, 1);
  disturb(foam, 0.05, 1);
  set_half_angles(foam);
  const FoamView view = view_of(foam);
  const JunctionOptions options;
  for (const Bubble b : foam.bubble_slots()) {
    EXPECT_EQ(view.area(b), foam.area(b));
  }
  for (const Half h : foam.half_slots()) {
    EXPECT_EQ(view.next_in_bubble(h), foam.next_in_bubble(h));
    EXPECT_EQ(view.tangent(h), foam.tangent(h));
  }
  for (const Junction j : foam.junction_slots()) {
    EXPECT_EQ(thesis::junction_step(view, j, options).position,
              thesis::junction_step(foam, j, options).position);
  }
}

} // namespace
} // namespace foam
