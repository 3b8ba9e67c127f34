// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/event_coarsening.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "mesh/validate.h"
#include "topology/cascade.h"
#include "topology/operations.h"
#include "topology/swap_rule.h"

namespace foam {
namespace {

constexpr double kReached = 1e-9;        // relative slack of a threshold that has been met
constexpr double kFinestStep = 1.0 / 64; // of a time step, towards a predicted T1
constexpr double kSmallestArea = 1e-6;   // of the mean area: no bubble gets smaller, no T2 area is
constexpr double kSmallestLength = 1e-3; // of the mean spacing: no T1 length is shorter
constexpr double kLargestChange = 0.25;  // of a film's chord along one response
constexpr double kCarefulTolerance = 1e-6; // of a careful frame's equilibria between events
constexpr int kRounds = 64;                // of events and relaxation in a frame,
constexpr int kRoundsPerBubble = 8;        // and so many more for every bubble

double smallest_area(const Foam& foam) {
  const double spacing = foam.mean_spacing();
  return kSmallestArea * spacing * spacing;
}

/// The films by which a bubble can lose a side, the shortest first, but those last whose other
/// bubble cannot well spare one.
std::vector<Index> films_to_swap(const Foam& foam, Index bubble) {
  std::vector<Index> films;
  for_each_half(foam, bubble, [&](Index h) {
    if (can_perform_t1(foam, Foam::film_of(h))) {
      films.push_back(Foam::film_of(h));
    }
  });
  std::ranges::stable_sort(
      films, {}, [&](Index f) { return std::pair(!spares_sides(foam, f), foam.length(2 * f)); });
  return films;
}

/// Whether a foam that is not in equilibrium may still be shown and gone on from.
bool is_a_foam(const Foam& foam) {
  const auto in_range = [](double alpha) { return std::abs(alpha) < std::numbers::pi; };
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    if (foam.has_bubble(b) && !(foam.target_area[Foam::size(b)] > 0)) {
      return false;
    }
  }
  return foam.report.converged ||
         (std::ranges::all_of(foam.film_angle, in_range) && validate_geometry(foam).empty());
}

} // namespace

void EventCoarsening::Motion::take(const Region& region, const Step& response) {
  for (std::size_t i = 0; i < region.junctions.size(); ++i) {
    junctions[Foam::size(region.junctions[i])] = response.junctions[i];
  }
  for (std::size_t i = 0; i < region.films.size(); ++i) {
    angles[Foam::size(region.films[i])] = response.angles[i];
  }
  for (std::size_t i = 0; i < region.bubbles.size(); ++i) {
    pressures[Foam::size(region.bubbles[i])] = response.pressures[i];
  }
}

void EventCoarsening::Motion::hold_wall(const Foam& foam) {
  for (Index f = 0; f < foam.film_capacity(); ++f) {
    if (foam.has_film(f) && foam.wall(2 * f)) {
      angles[Foam::size(f)] = 0;
      junctions[Foam::size(foam.start(2 * f))] = {};
      junctions[Foam::size(foam.end(2 * f))] = {};
    }
  }
}

Vec2 EventCoarsening::Motion::chord_rate(const Foam& foam, Index film) const {
  return junctions[Foam::size(foam.end(2 * film))] - junctions[Foam::size(foam.start(2 * film))];
}

EventCoarsening::EventCoarsening(const CoarseningOptions& options)
    : options_(options), newton_(options.equilibrator) {}

void EventCoarsening::restart(Foam foam) {
  foam_ = std::move(foam);
  newton_.forget();
  patience_.assign(foam_.bubble_half.size(), 1.0);
}

Thresholds EventCoarsening::limits() const {
  Thresholds t = thresholds(foam_, options_.thresholds);
  t.t1_length = std::max(t.t1_length, kSmallestLength * foam_.mean_spacing());
  t.t2_area = std::max(t.t2_area, smallest_area(foam_));
  return t;
}

void EventCoarsening::undo(State state) {
  foam_ = std::move(state.foam);
  motion_ = std::move(state.motion);
  patience_ = std::move(state.patience);
  newton_.forget();
}

bool EventCoarsening::advance(const AbortCheck& aborted) {
  const State before{foam_, motion_, patience_};
  iterations_ = 0;
  try {
    bool possible = integrate(false, aborted);
    if (!possible || !foam_.report.converged) {
      undo(before);
      possible = integrate(true, aborted);
    }
    if (!possible || !is_a_foam(foam_)) {
      undo(before);
      return false;
    }
  } catch (const Aborted&) {
    undo(before);
    throw;
  }
  foam_.time = before.foam.time + options_.time_step;
  foam_.report.iterations = iterations_;
  return true;
}

bool EventCoarsening::integrate(bool careful, const AbortCheck& aborted) {
  careful_ = careful;
  rounds_left_ = kRounds + kRoundsPerBubble * foam_.bubble_count();
  predict_whole();
  if (options_.two_sided_bubbles == TwoSidedBubbles::Slide) {
    slide_two_sided_bubbles(aborted);
  }
  if (!settle_events(aborted)) {
    return false;
  }
  for (double left = options_.time_step; left > 0;) {
    if (aborted && aborted()) {
      throw Aborted();
    }
    const double step = std::min(left, time_to_next_event());
    const std::uint64_t topology = foam_.topology;
    const std::vector<Index> strained = strained_bubbles(step);
    move(step);
    left = step < left ? left - step : 0;
    if (careful_) {
      relax_whole(kCarefulTolerance, aborted);
      predict_whole();
    } else if (!strained.empty()) {
      relax_around(strained, aborted);
    }
    const bool stuck = !settle_events(aborted) || (step <= 0 && foam_.topology == topology);
    if (stuck) {
      return false;
    }
  }
  balance_gas();
  relax_whole(options_.equilibrator.tolerance, aborted);
  return true;
}

/// Gives a closed container's bubbles back what rough equilibria and rounding have lost.
void EventCoarsening::balance_gas() {
  if (foam_.boundary == Boundary::Free) {
    return;
  }
  double space = 0;
  double gas = 0;
  for (Index b = 0; b < foam_.bubble_capacity(); ++b) {
    if (foam_.has_bubble(b)) {
      space += foam_.area(b);
      gas += foam_.target_area[Foam::size(b)];
    }
  }
  for (double& area : foam_.target_area) {
    area *= space / gas;
  }
}

void EventCoarsening::predict_whole() {
  motion_.junctions.assign(foam_.position.size(), {});
  motion_.angles.assign(foam_.film_angle.size(), 0.0);
  motion_.pressures.assign(foam_.pressure.size(), 0.0);
  motion_.areas = area_rates(foam_, options_.permeability);
  const Step& response = newton_.response(foam_, motion_.areas);
  motion_.take(newton_.region(), response);
}

void EventCoarsening::move(double time) {
  for (std::size_t j = 0; j < foam_.position.size(); ++j) {
    foam_.position[j] += time * motion_.junctions[j];
  }
  for (std::size_t f = 0; f < foam_.film_angle.size(); ++f) {
    foam_.film_angle[f] += time * motion_.angles[f];
  }
  for (std::size_t b = 0; b < foam_.pressure.size(); ++b) {
    foam_.pressure[b] += time * motion_.pressures[b];
    foam_.target_area[b] += time * motion_.areas[b];
  }
}

double EventCoarsening::time_to_next_event() const {
  const Thresholds limit = limits();
  double time = std::numeric_limits<double>::infinity();
  for (Index b = 0; b < foam_.bubble_capacity(); ++b) {
    const double rate = motion_.areas[Foam::size(b)];
    if (foam_.has_bubble(b) && rate < 0) {
      const double excess = foam_.target_area[Foam::size(b)] - collapse_area(b, limit);
      time = std::min(time, std::max(excess, 0.0) / -rate);
    }
  }
  double t1_time = std::numeric_limits<double>::infinity();
  for (Index f = 0; f < foam_.film_capacity(); ++f) {
    if (!foam_.has_film(f) || foam_.wall(2 * f)) {
      continue;
    }
    const Vec2 chord = foam_.chord(2 * f);
    const double d = norm(chord);
    const Vec2 change = motion_.chord_rate(foam_, f);
    const ArcShape shape = arc_shape(foam_.half_angle(2 * f));
    const double length = d * shape.f;
    const double growth =
        shape.f * dot(chord, change) / d + d * shape.f1 * motion_.angles[Foam::size(f)];
    if (growth < 0 && length > limit.t1_length && spares_sides(foam_, f)) {
      t1_time = std::min(t1_time, (length - limit.t1_length) / -growth);
    }
    if (norm(change) > 0) {
      t1_time = std::min(t1_time, kLargestChange * d / norm(change));
    }
  }
  return std::min(time, std::max(t1_time, kFinestStep * options_.time_step));
}

/// The bubbles around films that change so much in a step that the response does not carry on.
std::vector<Index> EventCoarsening::strained_bubbles(double time) const {
  std::vector<Index> bubbles;
  for (Index f = 0; f < foam_.film_capacity(); ++f) {
    if (foam_.has_film(f) && !foam_.wall(2 * f) &&
        time * norm(motion_.chord_rate(foam_, f)) >
            (1 - kReached) * kLargestChange * norm(foam_.chord(2 * f))) {
      bubbles.insert(bubbles.end(), {foam_.left(2 * f), foam_.right(2 * f)});
    }
  }
  return bubbles;
}

void EventCoarsening::relax_whole(double tolerance, const AbortCheck& aborted) {
  const double goal = std::max(tolerance, options_.equilibrator.tolerance);
  iterations_ += newton_.equilibrate_to(foam_, goal, limits().t1_length, aborted).iterations;
}

/// After an event at these bubbles. \returns whether an equilibrium was found.
bool EventCoarsening::relax_around(std::span<const Index> bubbles, const AbortCheck& aborted) {
  bool converged = newton_.relax_patch(foam_, bubbles, limits().t1_length, aborted);
  iterations_ += newton_.iterations();
  if (careful_) {
    relax_whole(kCarefulTolerance, aborted);
    converged = foam_.report.converged;
    predict_whole();
  } else {
    motion_.areas = area_rates(foam_, options_.permeability);
    const Step& response = newton_.patch_response(foam_, motion_.areas);
    motion_.take(newton_.patch_region(), response);
    motion_.hold_wall(foam_);
  }
  return converged;
}

/// Whether the film is to be swapped: short, shrinking and pulled shut.
bool EventCoarsening::film_is_due(Index film, const Thresholds& limit) const {
  return foam_.length(2 * film) <= limit.t1_length * (1 + kReached) &&
         dot(foam_.chord(2 * film), motion_.chord_rate(foam_, film)) < 0 &&
         spares_sides(foam_, film) && pulled_shut(foam_, film);
}

/// The area at which the bubble is to give way.
double EventCoarsening::collapse_area(Index bubble, const Thresholds& limit) const {
  return foam_.sides[Foam::size(bubble)] <= 3
             ? limit.t2_area
             : std::max(limit.t2_area * patience_[Foam::size(bubble)], smallest_area(foam_));
}

/// Performs what is due at this instant, relaxes, and looks again. \returns false if a bubble would
/// vanish that cannot, or if there is no end to it.
bool EventCoarsening::settle_events(const AbortCheck& aborted) {
  for (bool first = true; rounds_left_ > 0; first = false, --rounds_left_) {
    const Thresholds limit = limits();
    const auto small = [&](const Foam& foam, Index b) {
      return foam.target_area[Foam::size(b)] <= limit.t2_area * (1 + kReached);
    };
    CollapseRules rules;
    rules.t1 = [&](const Foam&, Index f) { return first && film_is_due(f, limit); };
    rules.t2 = small;
    rules.t3 = small;
    const CascadeResult result = topological_cascade(foam_, rules);
    if (result.changed()) {
      relax_around(result.bubbles, aborted);
    } else if (!reduce_remnants(aborted)) {
      return !cannot_go_on();
    }
  }
  return false;
}

/// Whether a bubble is at its end, but cannot be removed.
bool EventCoarsening::cannot_go_on() const {
  const Thresholds limit = limits();
  for (Index b = 0; b < foam_.bubble_capacity(); ++b) {
    const double end = foam_.sides[Foam::size(b)] <= 3 ? limit.t2_area : smallest_area(foam_);
    if (foam_.has_bubble(b) && motion_.areas[Foam::size(b)] < 0 &&
        foam_.target_area[Foam::size(b)] <= end * (1 + kReached)) {
      return true;
    }
  }
  return false;
}

/// Takes a side from every shrinking bubble that is at the T2 area with more than three, so that
/// three are left in the end. \returns whether anything changed.
bool EventCoarsening::reduce_remnants(const AbortCheck& aborted) {
  bool changed = false;
  const Thresholds limit = limits();
  for (Index b = 0; b < foam_.bubble_capacity(); ++b) {
    const auto i = Foam::size(b);
    if (foam_.has_bubble(b) && foam_.sides[i] > 3 && motion_.areas[i] < 0 &&
        foam_.target_area[i] <= collapse_area(b, limit) * (1 + kReached)) {
      changed = reduce_remnant(b, aborted) || changed;
    }
  }
  return changed;
}

/// Swaps the shortest of the bubble's films with which the foam finds an equilibrium. Where there
/// is none, the bubble may shrink to a quarter before the next attempt.
bool EventCoarsening::reduce_remnant(Index bubble, const AbortCheck& aborted) {
  const auto i = Foam::size(bubble);
  const State before{foam_, motion_, patience_};
  for (const Index film : films_to_swap(before.foam, bubble)) {
    std::vector<Index> around{foam_.left(2 * film), foam_.right(2 * film)};
    perform_t1(foam_, film);
    around.insert(around.end(), {foam_.left(2 * film), foam_.right(2 * film)});
    if (relax_around(around, aborted) && foam_.sides[i] < before.foam.sides[i]) {
      return true;
    }
    undo(before);
  }
  patience_[i] *= 0.25;
  return false;
}

/// Thesis 3.6.1: each two-sided bubble goes to the nearest corner and takes a side there.
void EventCoarsening::slide_two_sided_bubbles(const AbortCheck& aborted) {
  const double distance = limits().t1_length;
  for (Index b = 0; b < foam_.bubble_capacity(); ++b) {
    if (!can_perform_t3(foam_, b)) {
      continue;
    }
    slide_two_sided_bubble(foam_, b, distance);
    std::vector<Index> around{b};
    Index shortest = kNone;
    for_each_half(foam_, b, [&](Index h) {
      const Index film = Foam::film_of(foam_.previous_around_junction(h));
      if (shortest == kNone || foam_.length(2 * film) < foam_.length(2 * shortest)) {
        shortest = film;
      }
    });
    if (can_perform_t1(foam_, shortest) && spares_sides(foam_, shortest)) {
      for (const Index bubble : perform_t1(foam_, shortest)) {
        around.push_back(bubble);
      }
    }
    relax_around(around, aborted);
  }
}

} // namespace foam
