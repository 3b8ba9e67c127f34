// SPDX-License-Identifier: GPL-3.0-or-later
#include "thesis/frame_coarsening.h"

#include <algorithm>
#include <optional>
#include <utility>

#include "coarsening/end.h"
#include "parallel/host.h"
#include "physics/gas.h"
#include "thesis/algorithms.h"
#include "thesis/junction_step.h"
#include "thesis/one_tension.h"
#include "thesis/rules.h"
#include "topology/cascade.h"
#include "topology/collapse_operations.h"
#include "topology/operations.h"

namespace foam {
namespace {

template <class Visit> void for_each_bubble(const Foam& foam, Visit&& visit) {
  for (const Bubble b : foam.bubble_slots()) {
    if (foam.has_bubble(b)) {
      visit(b);
    }
  }
}

/// A^τ ← A^τ + dA/dt·Δt (3.7.1).
void diffuse(Foam& foam, double permeability, double time_step) {
  const Field<Bubble, double> rate = area_rates(foam, permeability);
  for_each_bubble(foam, [&](Bubble b) { foam.target_area[b] += rate[b] * time_step; });
}

void slide_two_sided_bubbles(Foam& foam, const ThesisRules& rules) {
  for_each_bubble(foam, [&](Bubble b) {
    if (foam.sides[b] == 2 && rules.slides(foam, b)) {
      slide_two_sided_bubble(foam, b, rules.two_sided().sliding_distance());
    }
  });
}

CollapseRules collapse_rules(const ThesisRules& rules) {
  return {.t1 = [=](const Foam& foam, Film film) { return rules.shrunk(foam, film); },
          .t2 = [=](const Foam& foam, Bubble b) { return rules.vanishes(foam, b); },
          .t3 = [=](const Foam& foam,
                    Bubble b) { return !rules.slides(foam, b) && rules.vanishes(foam, b); }};
}

/// All operations in the rounds of topology/reservations.h.
void perform_in_rounds(Foam& foam, const ThesisRules& rules) {
  Host host;
  Field<Film, std::uint8_t> swappable(foam.film_angle.size(), 1);
  Reservations<Host> reservations(host);
  reservations.run(view_of(foam), CollapseOperations<ThesisRules>{
                                      rules, FieldView<Film, std::uint8_t>(swappable.data())});
  note_performed(foam, reservations.take_performed());
}

void perform_topological_operations(Foam& foam, const ThesisRules& rules,
                                    const CoarseningOptions& options) {
  switch (options.topological_algorithm) {
  case TopologicalAlgorithm::Final:
    topological_cascade(foam, collapse_rules(rules));
    break;
  case TopologicalAlgorithm::Original:
    original_algorithm(foam, collapse_rules(rules), [&](Foam& now, Junction junction) {
      thesis::equilibrate_junction(now, junction, options.equilibrator.junction);
    });
    break;
  case TopologicalAlgorithm::Improved:
    improved_algorithm(foam, collapse_rules(rules));
    break;
  case TopologicalAlgorithm::Simultaneous:
    perform_in_rounds(foam, rules);
    break;
  }
}

/// A bubble that ought to have vanished but could not be removed, a neighbour of its being
/// two-sided, say, goes on as a tiny one: no pressure gives a bubble an area of zero or less.
void keep_targets_above(Foam& foam, double least) {
  for_each_bubble(foam, [&](Bubble b) {
    double& target = foam.target_area[b];
    target = std::max(target, least);
  });
}

/// Whether one of a double bubble's two vanishes.
bool comes_to_an_end(const Foam& foam, double t2_area) {
  bool end = false;
  if (!foam.surroundings.closed() && foam.bubble_count() == 2) {
    for_each_bubble(foam, [&](Bubble b) {
      end = end || std::min(foam.target_area[b], foam.area(b)) <= t2_area;
    });
  }
  return end;
}

/// The bubble of the smallest area, if that is negative, of those that are not to vanish: one whose
/// target is below the T2 area may be flat or folded before it does, a film of it not being short.
std::optional<Obstacle> inside_out(const Foam& foam, double t2_area) {
  std::optional<Obstacle> found;
  for_each_bubble(foam, [&](Bubble b) {
    const double area = foam.area(b);
    if (foam.target_area[b] > t2_area && area < (found ? found->area_ahead : 0)) {
      found = Obstacle{End::Cause::NoEquilibrium, b, area};
    }
  });
  return found;
}

} // namespace

FrameCoarsening::FrameCoarsening(const CoarseningOptions& options,
                                 std::unique_ptr<Equilibrator> equilibrator)
    : options_(options), equilibrator_(std::move(equilibrator)) {}

void FrameCoarsening::restart(Foam foam) {
  thesis::require_one_tension(foam);
  foam.thresholds = thresholds(foam, options_.thresholds);
  foam_ = std::move(foam);
  equilibrator_->forget();
}

bool FrameCoarsening::advance(const AbortCheck& aborted) {
  Foam next = foam_;
  const Thresholds limit = thresholds(next, options_.thresholds);
  const double spacing = next.mean_spacing();
  diffuse(next, options_.permeability, options_.time_step);
  next.time += options_.time_step;
  next.operations.clear();
  next.ended.reset();
  if (comes_to_an_end(next, limit.t2_area)) {
    foam_.ended = end_at(foam_, {End::Cause::LastTwo}, limit, options_.thresholds);
    return false;
  }
  const ThesisRules rules{limit, options_.two_sided_bubbles};
  slide_two_sided_bubbles(next, rules);
  perform_topological_operations(next, rules, options_);
  keep_targets_above(next, kLeastTarget * spacing * spacing);
  equilibrator_->equilibrate(next, limit.t1_length, aborted);
  next.thresholds = thresholds(next, options_.thresholds);
  if (const auto obstacle = inside_out(next, next.thresholds.t2_area)) {
    foam_.ended = end_at(foam_, *obstacle, limit, options_.thresholds);
    return false;
  }
  foam_ = std::move(next);
  return true;
}

} // namespace foam
