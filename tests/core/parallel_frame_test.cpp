// SPDX-License-Identifier: GPL-3.0-or-later
#include "thesis/parallel_frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <numeric>

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
  CoarseningOptions options;
  options.two_sided_bubbles = setting.two_sided;
  options.topological_algorithm = TopologicalAlgorithm::Simultaneous;
  options.thresholds.relative = setting.relative;
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
  Foam foam = test::jittered_foam(GetParam().boundary, 60, 3);
  FrameCoarsening serial(options, make_equilibrator(options.equilibrator));
  serial.restart(foam);
  Host host;
  ParallelFrame<Host> parallel(host, options);
  // In a container rates are sums in another order, and the constraints make a step of any
  // difference.
  const bool to_rounding = GetParam().boundary != Boundary::Fixed;
  for (int frame = 0; frame < (to_rounding ? 15 : 3); ++frame) {
    const FrameResult result = parallel.advance([&] { return view_of(foam); }, {});
    ASSERT_EQ(result.performed, serial.advance({}));
    count(foam, result.operations);
    const Foam& expected = serial.foam();
    ASSERT_EQ(foam.t1_count, expected.t1_count) << frame;
    ASSERT_EQ(foam.t2_count, expected.t2_count) << frame;
    ASSERT_EQ(foam.t3_count, expected.t3_count) << frame;
    ASSERT_EQ(foam.half_junction, expected.half_junction) << frame;
    EXPECT_EQ(result.report.iterations, expected.report.iterations);
    EXPECT_EQ(result.report.converged, expected.report.converged);
    for (Index f = 0; f < foam.film_capacity(); ++f) {
      if (foam.has_film(f)) {
        ASSERT_NEAR(foam.length(2 * f), expected.length(2 * f), to_rounding ? 1e-10 : 1e-8);
      }
    }
  }
  EXPECT_TRUE(!to_rounding || foam.t1_count + foam.t2_count > 0);
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
      EXPECT_TRUE(frame.advance([&] { return view_of(foam); }, {}).performed);
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
      ParallelFrame<Host>(host, options).advance([&] { return view_of(foam); }, {}).performed);
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
  Foam foam = test::jittered_foam(Boundary::Free, 2000, 1);
  const FoamView mesh = view_of(foam);
  Host host;
  thesis::UpdateOrder<Host> order(host);
  for (const int reach : {1, 2}) {
    order.find(mesh, reach);
    EXPECT_LT(order.waves(), 60);
    for (Index j = 0; j < mesh.junctions; ++j) {
      for (const Index half : mesh.junction_half[j]) {
        const Index near = mesh.end(half);
        EXPECT_NE(order.wave()[j], order.wave()[near]);
        for (const Index second : mesh.junction_half[near]) {
          const Index far = mesh.end(second);
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
    std::vector<thesis::JunctionStep> step;
    std::vector<Index> order(serial.position.size());
    std::iota(order.begin(), order.end(), Index{0});
    for (const Index j : order) {
      step.push_back(thesis::junction_step(serial, j, options));
    }
    std::ranges::sort(order, {}, [](Index j) { // the hash that gives the order
      return thesis::scattered(static_cast<std::uint32_t>(j));
    });
    for (const Index j : order) {
      thesis::move_junction(serial, j, step[Foam::size(j)], options);
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
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    EXPECT_EQ(view.area(b), foam.area(b));
  }
  for (Index h = 0; h < 2 * foam.film_capacity(); ++h) {
    EXPECT_EQ(view.next_in_bubble(h), foam.next_in_bubble(h));
    EXPECT_EQ(view.tangent(h), foam.tangent(h));
  }
  for (Index j = 0; j < foam.junction_capacity(); ++j) {
    EXPECT_EQ(thesis::junction_step(view, j, options).position,
              thesis::junction_step(foam, j, options).position);
  }
}

} // namespace
} // namespace foam
