// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <gtest/gtest.h>

#include <array>

#include "coarsening/end.h"
#include "core/foams.h"
#include "random_runs.h"

namespace foam::test {

/// Expects that events are what happened to a foam since its record was this.
inline void expect_events_of(const Evolution& evolution, const FoamRecord& before,
                             const std::string& where) {
  const Foam& foam = evolution.foam();
  std::array<std::int64_t, 4> counts{}; // by kind
  double time = before.time;
  for (const TopologicalEvent& event : evolution.events()) {
    ++counts[static_cast<std::size_t>(event.kind)];
    EXPECT_GE(event.time, time * (1 - 1e-12)) << where;
    time = event.time;
    if (event.kind != TopologicalOperation::Kind::T1) {
      for (const Bubble b : foam.bubble_slots()) {
        EXPECT_FALSE(foam.has_bubble(b) && foam.bubble_id[b] == event.bubbles[0]) << where;
      }
    }
  }
  EXPECT_LE(time, foam.time * (1 + 1e-12)) << where;
  EXPECT_EQ(counts[1], foam.t1_count - before.t1_count) << where;
  EXPECT_EQ(counts[2], foam.t2_count - before.t2_count) << where;
  EXPECT_EQ(counts[3], foam.t3_count - before.t3_count) << where;
}

/// A run of a small foam at random, every frame of which has to be an equilibrium that keeps its
/// gas, and that ends only where its model does: a free foam at its last two bubbles, one on a
/// torus never. \returns the bubbles that are left; 0 if there is no equilibrium to begin with.
inline Index run_at_random(std::uint64_t seed, double most, int frames) {
  const RandomRun run(seed, 5, most);
  const std::string where = run.text() + ": ";
  Foam start = run.start();
  if (!make_equilibrator({})->equilibrate(start, 0.05 * start.mean_spacing(), {}).converged) {
    return 0;
  }
  const double gas_before = gas(start);
  const auto coarsening = make_coarsening(run.options());
  coarsening->restart(start);
  for (int frame = 1; frame <= frames; ++frame) {
    const FoamRecord before = coarsening->foam();
    const double time = before.time;
    const bool goes_on = coarsening->advance({});
    const Foam& foam = coarsening->foam();
    EXPECT_EQ(goes_on, !foam.ended) << where;
    if (!goes_on) {
      EXPECT_EQ(foam.time, time) << where;
      EXPECT_EQ(foam.ended->bubbles, foam.bubble_count()) << where;
      EXPECT_NE(foam.ended->cause, End::Cause::NoEquilibrium) << where << reason(*foam.ended);
      EXPECT_NE(run.boundary(), Boundary::Periodic) << where << reason(*foam.ended);
      if (run.boundary() == Boundary::Free) {
        const End::Cause cause = foam.ended->cause;
        EXPECT_TRUE(cause == End::Cause::LastTwo || cause == End::Cause::AllVanish)
            << where << reason(*foam.ended);
      }
      break;
    }
    EXPECT_NEAR(foam.time - time, run.options().time_step, 1e-9 * foam.time) << where;
    expect_valid(foam, where);
    expect_events_of(*coarsening, before, where);
    // Between pinned ends films may get so short that rounding keeps a frame from the tolerance.
    const bool near = run.boundary() == Boundary::Fixed && foam.report.residual < 1e-6;
    EXPECT_TRUE(foam.report.converged || near) << where << "residual " << foam.report.residual;
    if (run.boundary() == Boundary::Periodic) {
      EXPECT_NEAR(gas(foam) / gas_before, 1, 1e-10) << where;
    }
  }
  return coarsening->foam().bubble_count();
}

} // namespace foam::test
