// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/event_coarsening.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "topology/cascade.h"
#include "topology/operations.h"
#include "topology/swap_rule.h"

namespace foam {
namespace {

constexpr double kReached = 1e-9;        // relative slack of a threshold that has been met
constexpr double kFinestStep = 1.0 / 64; // of a time step, towards a predicted T1
constexpr double kSmallestArea = 1e-6;   // of the mean area: no bubble gets smaller, no T2 area is
constexpr double kSmallestLength = 1e-4; // of the mean spacing: no T1 length is shorter
constexpr double kLargestChange = 0.25;  // of a film's chord in one step between events
constexpr double kToleranceBetweenEvents = 1e-6; // within a frame; its end meets the user's
constexpr int kLargestCascade = 64;              // rounds of events and relaxation at one instant

double smallest_area(const Foam& foam) {
  const double spacing = foam.mean_spacing();
  return kSmallestArea * spacing * spacing;
}

/// The films by which a bubble can lose a side to a neighbour that can spare one too, the shortest
/// first.
std::vector<Index> films_to_swap(const Foam& foam, Index bubble) {
  std::vector<Index> films;
  for_each_half(foam, bubble, [&](Index h) {
    const Index neighbour = foam.right(h);
    const bool spares = neighbour == kWorld || foam.sides[Foam::size(neighbour)] > 3;
    if (spares && can_perform_t1(foam, Foam::film_of(h))) {
      films.push_back(Foam::film_of(h));
    }
  });
  std::ranges::stable_sort(films, {}, [&](Index f) { return foam.length(2 * f); });
  return films;
}

/// Three-sided bubbles keep their sides: they vanish by T2.
bool spares_sides(const Foam& foam, Index film) {
  const auto spares = [&](Index b) { return b == kWorld || foam.sides[Foam::size(b)] > 3; };
  return spares(foam.left(2 * film)) && spares(foam.right(2 * film));
}

} // namespace

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

bool EventCoarsening::advance(const AbortCheck& aborted) {
  const Foam before = foam_;
  const std::vector<double> patience = patience_;
  const auto undo = [&] {
    foam_ = before;
    patience_ = patience;
    newton_.forget();
  };
  iterations_ = 0;
  try {
    if (!integrate(aborted)) {
      undo();
      return false;
    }
  } catch (const Aborted&) {
    undo();
    throw;
  }
  foam_.time = before.time + options_.time_step;
  foam_.report.iterations = iterations_;
  return true;
}

bool EventCoarsening::integrate(const AbortCheck& aborted) {
  if (options_.two_sided_bubbles == TwoSidedBubbles::Slide) {
    slide_two_sided_bubbles(aborted);
  }
  std::vector<char> shrinking(foam_.film_angle.size(), 0);
  if (!settle_events(shrinking, aborted)) {
    return false;
  }
  for (double left = options_.time_step; left > 0;) {
    const Thresholds limit = limits();
    const std::vector<double> rates = area_rates(foam_, options_.permeability);
    const Step& response = newton_.response(foam_, rates);
    const double step = std::min(left, time_to_next_event(rates, response, limit));
    for (const Index f : newton_.region().films) {
      shrinking[Foam::size(f)] =
          dot(foam_.chord(2 * f), newton_.chord_change(foam_, f, response)) < 0;
    }
    move(step, rates, response);
    left = step < left ? left - step : 0;
    relax_around({}, tolerance_between_events(), aborted);
    if (!settle_events(shrinking, aborted)) {
      return false;
    }
  }
  relax_around({}, options_.equilibrator.tolerance, aborted);
  return true;
}

double EventCoarsening::tolerance_between_events() const {
  return std::max(options_.equilibrator.tolerance, kToleranceBetweenEvents);
}

double EventCoarsening::time_to_next_event(const std::vector<double>& rates, const Step& response,
                                           const Thresholds& limit) const {
  double time = std::numeric_limits<double>::infinity();
  for (const Index b : newton_.region().bubbles) {
    const double rate = rates[Foam::size(b)];
    if (rate < 0) {
      const double excess = foam_.target_area[Foam::size(b)] - collapse_area(b, limit);
      time = std::min(time, std::max(excess, 0.0) / -rate);
    }
  }
  double t1_time = std::numeric_limits<double>::infinity();
  const Region& region = newton_.region();
  for (std::size_t i = 0; i < region.films.size(); ++i) {
    const Index f = region.films[i];
    const Vec2 chord = foam_.chord(2 * f);
    const double d = norm(chord);
    const Vec2 change = newton_.chord_change(foam_, f, response);
    const ArcShape shape = arc_shape(foam_.half_angle(2 * f));
    const double length = d * shape.f;
    const double growth = shape.f * dot(chord, change) / d + d * shape.f1 * response.angles[i];
    if (growth < 0 && length > limit.t1_length && spares_sides(foam_, f)) {
      t1_time = std::min(t1_time, (length - limit.t1_length) / -growth);
    }
    if (norm(change) > 0) {
      t1_time = std::min(t1_time, kLargestChange * d / norm(change));
    }
  }
  return std::min(time, std::max(t1_time, kFinestStep * options_.time_step));
}

void EventCoarsening::move(double time, const std::vector<double>& rates, const Step& response) {
  const Region& region = newton_.region();
  for (std::size_t i = 0; i < region.junctions.size(); ++i) {
    foam_.position[Foam::size(region.junctions[i])] += time * response.junctions[i];
  }
  for (std::size_t i = 0; i < region.films.size(); ++i) {
    foam_.film_angle[Foam::size(region.films[i])] += time * response.angles[i];
  }
  for (std::size_t i = 0; i < region.bubbles.size(); ++i) {
    const auto b = Foam::size(region.bubbles[i]);
    foam_.pressure[b] += time * response.pressures[i];
    foam_.target_area[b] += time * rates[b];
  }
}

void EventCoarsening::relax_around(const std::vector<Index>& bubbles, double tolerance,
                                   const AbortCheck& aborted) {
  iterations_ +=
      newton_.equilibrate_around(foam_, bubbles, tolerance, limits().t1_length, aborted).iterations;
}

/// Performs what is due at this instant, relaxes, and looks again. \returns false if a bubble would
/// vanish that cannot.
bool EventCoarsening::settle_events(const std::vector<char>& shrinking, const AbortCheck& aborted) {
  for (int round = 0; round < kLargestCascade; ++round) {
    const Thresholds limit = limits();
    const auto small = [&](const Foam& foam, Index b) {
      return foam.target_area[Foam::size(b)] <= limit.t2_area * (1 + kReached);
    };
    CollapseRules rules;
    rules.t1 = [&](const Foam& foam, Index f) {
      return round == 0 && shrinking[Foam::size(f)] &&
             foam.length(2 * f) <= limit.t1_length * (1 + kReached) && spares_sides(foam, f) &&
             pulled_shut(foam, f);
    };
    rules.t2 = small;
    rules.t3 = small;
    const CascadeResult result = topological_cascade(foam_, rules);
    if (result.changed()) {
      relax_around(result.bubbles, tolerance_between_events(), aborted);
    } else if (!reduce_remnants(aborted)) {
      break;
    }
  }
  const double end = limits().t2_area * (1 + kReached);
  for (Index b = 0; b < foam_.bubble_capacity(); ++b) {
    if (foam_.has_bubble(b) && foam_.sides[Foam::size(b)] <= 3 &&
        foam_.target_area[Foam::size(b)] <= end) {
      return false;
    }
  }
  return true;
}

/// The area at which the bubble is to give way.
double EventCoarsening::collapse_area(Index bubble, const Thresholds& limit) const {
  return foam_.sides[Foam::size(bubble)] <= 3
             ? limit.t2_area
             : std::max(limit.t2_area * patience_[Foam::size(bubble)], smallest_area(foam_));
}

/// Takes a side from every bubble that is at the T2 area with four or five, so that three are left
/// in the end. \returns whether anything changed.
bool EventCoarsening::reduce_remnants(const AbortCheck& aborted) {
  bool changed = false;
  const Thresholds limit = limits();
  for (Index b = 0; b < foam_.bubble_capacity(); ++b) {
    const auto i = Foam::size(b);
    if (foam_.has_bubble(b) && (foam_.sides[i] == 4 || foam_.sides[i] == 5) &&
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
  const Foam before = foam_;
  for (const Index film : films_to_swap(before, bubble)) {
    std::vector<Index> around{foam_.left(2 * film), foam_.right(2 * film)};
    perform_t1(foam_, film);
    around.insert(around.end(), {foam_.left(2 * film), foam_.right(2 * film)});
    relax_around(around, tolerance_between_events(), aborted);
    if (foam_.report.converged && foam_.sides[i] < before.sides[i]) {
      return true;
    }
    foam_ = before;
    newton_.forget();
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
    relax_around(around, tolerance_between_events(), aborted);
  }
}

} // namespace foam
