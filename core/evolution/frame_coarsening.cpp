// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/frame_coarsening.h"

#include <algorithm>
#include <utility>

#include "evolution/diffusion.h"
#include "junction/junction_step.h"
#include "topology/cascade.h"
#include "topology/operations.h"
#include "topology/thesis_algorithms.h"

namespace foam {
namespace {

template <class Visit> void for_each_bubble(const Foam& foam, Visit&& visit) {
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    if (foam.has_bubble(b)) {
      visit(b);
    }
  }
}

/// A^τ ← A^τ + dA/dt·Δt (3.7.1).
void diffuse(Foam& foam, double permeability, double time_step) {
  const std::vector<double> rate = area_rates(foam, permeability);
  for_each_bubble(
      foam, [&](Index b) { foam.target_area[Foam::size(b)] += rate[Foam::size(b)] * time_step; });
}

/// Whether a bubble has shrunk to nothing, in fact or in target (3.2.2).
bool vanishes(const Foam& foam, Index bubble, double area, double t2_area) {
  return foam.target_area[Foam::size(bubble)] <= t2_area || area <= t2_area;
}

/// A two-sided bubble on the wall of a container has no corner to slide to.
bool slides(const Foam& foam, Index bubble, TwoSidedBubbles choice) {
  return choice == TwoSidedBubbles::Slide &&
         !(foam.boundary == Boundary::Fixed && foam.bubble_on_world(bubble));
}

/// The film that a bubble slid to is to be found short enough for a T1 whatever rounding does.
constexpr double kWithinThreshold = 1 - 1e-9;

void slide_two_sided_bubbles(Foam& foam, double t1_length) {
  for_each_bubble(foam, [&](Index b) {
    if (foam.sides[Foam::size(b)] == 2 && slides(foam, b, TwoSidedBubbles::Slide)) {
      slide_two_sided_bubble(foam, b, t1_length * kWithinThreshold);
    }
  });
}

/// The thesis's conditions for a topological operation (3.2.2), and for T3 that of T2. Areas are
/// those of the pressures: the arcs' own angles lag behind while junctions are equilibrated between
/// the operations.
CollapseRules thesis_rules(const Thresholds& limit, TwoSidedBubbles two_sided) {
  const auto gone = [=](const Foam& foam, Index b) {
    const double area = junction::thesis_area(foam, foam.bubble_half[Foam::size(b)]);
    return vanishes(foam, b, area, limit.t2_area);
  };
  return {.t1 = [=](const Foam& foam,
                    Index film) { return norm(foam.chord(2 * film)) <= limit.t1_length; },
          .t2 = gone,
          .t3 = [=](const Foam& foam,
                    Index b) { return !slides(foam, b, two_sided) && gone(foam, b); }};
}

void perform_topological_operations(Foam& foam, const CollapseRules& rules,
                                    const CoarseningOptions& options) {
  switch (options.topological_algorithm) {
  case TopologicalAlgorithm::Final:
    topological_cascade(foam, rules);
    break;
  case TopologicalAlgorithm::Original:
    original_algorithm(foam, rules, [&](Foam& now, Index junction) {
      junction::equilibrate_junction(now, junction, options.equilibrator.junction);
    });
    break;
  case TopologicalAlgorithm::Improved:
    improved_algorithm(foam, rules);
    break;
  }
}

/// Target areas below this share of the mean are raised to it.
constexpr double kLeastTarget = 1e-6;

/// A bubble that ought to have vanished but could not be removed, a neighbour of its being
/// two-sided, say, goes on as a tiny one: no pressure gives a bubble an area of zero or less.
void keep_targets_above(Foam& foam, double least) {
  for_each_bubble(foam, [&](Index b) {
    double& target = foam.target_area[Foam::size(b)];
    target = std::max(target, least);
  });
}

/// Whether one of a double bubble's two vanishes.
bool comes_to_an_end(const Foam& foam, double t2_area) {
  bool end = false;
  if (foam.boundary == Boundary::Free && foam.bubble_count() == 2) {
    for_each_bubble(foam, [&](Index b) { end = end || vanishes(foam, b, foam.area(b), t2_area); });
  }
  return end;
}

} // namespace

FrameCoarsening::FrameCoarsening(const CoarseningOptions& options)
    : options_(options), equilibrator_(make_equilibrator(options.equilibrator)) {}

void FrameCoarsening::restart(Foam foam) {
  foam_ = std::move(foam);
  equilibrator_->forget();
}

bool FrameCoarsening::advance(const AbortCheck& aborted) {
  Foam next = foam_;
  const Thresholds limit = thresholds(next, options_.thresholds);
  const double spacing = next.mean_spacing();
  diffuse(next, options_.permeability, options_.time_step);
  if (comes_to_an_end(next, limit.t2_area)) {
    return false;
  }
  if (options_.two_sided_bubbles == TwoSidedBubbles::Slide) {
    slide_two_sided_bubbles(next, limit.t1_length);
  }
  perform_topological_operations(next, thesis_rules(limit, options_.two_sided_bubbles), options_);
  keep_targets_above(next, kLeastTarget * spacing * spacing);
  equilibrator_->equilibrate(next, limit.t1_length, aborted);
  next.time += options_.time_step;
  foam_ = std::move(next);
  return true;
}

} // namespace foam
