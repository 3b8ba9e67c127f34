// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarsening/event_coarsening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "coarsening/newton_rules.h"
#include "mesh/validate.h"
#include "physics/step_limits.h"
#include "physics/swap_rule.h"
#include "topology/cascade.h"
#include "topology/operations.h"

namespace foam {
namespace {

constexpr double kReached = 1e-9;            // relative slack of a threshold that has been met
constexpr double kFinestStep = 1.0 / 64;     // of a time step, towards a predicted T1
constexpr double kFinestStrain = 1.0 / 4096; // of a time step, from one renewal to the next
constexpr double kLargestChange = 0.25;      // of a chord or an area before the response is renewed
constexpr double kCarefulTolerance = 1e-6;   // of a careful frame's equilibria between events
constexpr int kEvents = 1024;                // in a frame,
constexpr int kEventsPerBubble = 16;         // and so many more for every bubble
constexpr int kRings = 3;                    // around an event that its operations look at

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

EventCoarsening::EventCoarsening(const CoarseningOptions& options)
    : options_(options), newton_(options.equilibrator) {}

void EventCoarsening::restart(Foam foam) {
  foam_ = std::move(foam);
  motion_ = {};
  newton_.forget();
  patience_.assign(foam_.bubble_half.size(), 1.0);
}

void EventCoarsening::undo(State state) {
  const std::uint64_t topology = foam_.topology + 1; // no one shall take it for one seen before
  foam_ = std::move(state.foam);
  foam_.topology = topology;
  motion_ = std::move(state.motion);
  patience_ = std::move(state.patience);
}

bool EventCoarsening::advance(const AbortCheck& aborted) {
  const State before{foam_, {}, patience_};
  iterations_ = 0;
  try {
    bool possible = integrate(false, aborted);
    if (!possible || !foam_.report.converged) {
      undo(before);
      newton_.forget();
      possible = integrate(true, aborted);
    }
    if (!possible || !is_a_foam(foam_)) {
      undo(before);
      newton_.forget();
      return false;
    }
  } catch (...) {
    undo(before);
    newton_.forget();
    throw;
  }
  foam_.time = before.foam.time + options_.time_step;
  foam_.report.iterations = iterations_;
  return true;
}

bool EventCoarsening::integrate(bool careful, const AbortCheck& aborted) {
  careful_ = careful;
  now_ = 0;
  const double spacing = foam_.mean_spacing();
  limit_ = newton_thresholds(thresholds(foam_, options_.thresholds), spacing);
  smallest_area_ = kSmallestArea * spacing * spacing;

  predict_whole();
  queue_.clear(foam_);
  if (options_.two_sided_bubbles == TwoSidedBubbles::Slide) {
    slide_two_sided_bubbles(aborted);
  }
  expect_all();
  for (Index f = 0; f < foam_.film_capacity(); ++f) {
    if (foam_.has_film(f) && !foam_.wall(2 * f) && film_is_due(f)) {
      expect({now_, Event::Kind::Close, f});
    }
  }
  int events_left = kEvents + kEventsPerBubble * foam_.bubble_count();
  while (const auto event = queue_.next()) {
    if (aborted && aborted()) {
      throw Aborted();
    }
    now_ = event->time;
    const std::uint64_t topology = foam_.topology;
    if (events_left < 0 || !settle(*event, aborted)) {
      return false;
    }
    events_left -= foam_.topology != topology || event->kind == Event::Kind::Strain ? 1 : 0;
  }
  now_ = options_.time_step;
  motion_.finish(foam_, now_);
  balance_gas();
  relax_whole(options_.equilibrator.tolerance, aborted);
  return true;
}

/// Gives a closed container's bubbles back what has been lost on the way: on a torus by rounding,
/// to all of them; in a box also at its walls, to the bubbles there, as von Neumann's law is not
/// theirs.
void EventCoarsening::balance_gas() {
  if (foam_.boundary == Boundary::Free) {
    return;
  }
  double lost = 0;
  double share = 0; // the gas of those that take part
  std::vector<Index> taking_part;
  for (Index b = 0; b < foam_.bubble_capacity(); ++b) {
    if (foam_.has_bubble(b)) {
      const double gas = foam_.target_area[Foam::size(b)];
      lost += foam_.area(b) - gas;
      if (foam_.boundary == Boundary::Periodic || foam_.bubble_on_world(b)) {
        share += gas;
        taking_part.push_back(b);
      }
    }
  }
  for (const Index b : taking_part) {
    foam_.target_area[Foam::size(b)] *= 1 + lost / share;
  }
}

/// \pre the whole foam stands at this instant
void EventCoarsening::predict_whole() {
  std::vector<double> rates = area_rates(foam_, options_.permeability);
  const Step* response = newton_.response(foam_, rates, motion_.expected(), drift());
  motion_.begin(foam_, std::move(rates), now_);
  if (response != nullptr) {
    motion_.take_whole(newton_.region(), *response, !careful_);
  } else {
    motion_.rest();
  }
}

void EventCoarsening::expect_all() {
  queue_.clear(foam_);
  for (Index b = 0; b < foam_.bubble_capacity(); ++b) {
    if (foam_.has_bubble(b)) {
      expect_bubble(b);
    }
  }
  for (Index f = 0; f < foam_.film_capacity(); ++f) {
    if (foam_.has_film(f)) {
      expect_film(f);
    }
  }
}

/// \pre the bubble stands at this instant
void EventCoarsening::expect_bubble(Index bubble) {
  queue_.cancel_bubble(bubble);
  const double rate = motion_.area_rate(bubble);
  if (rate < 0) {
    const double excess = foam_.target_area[Foam::size(bubble)] - collapse_area(bubble);
    expect({now_ + std::max(excess, 0.0) / -rate, Event::Kind::Collapse, bubble});
  }
}

/// \pre the film stands at this instant
void EventCoarsening::expect_film(Index film) {
  queue_.cancel_film(film);
  if (foam_.wall(2 * film)) {
    return;
  }
  const Vec2 chord = foam_.chord(2 * film);
  const Vec2 change = motion_.chord_rate(foam_, film);
  const double d = norm(chord);
  Event event{std::numeric_limits<double>::infinity(), Event::Kind::Close, film};
  const double alpha = foam_.half_angle(2 * film);
  const double growth = arc_growth(chord, change, alpha, motion_.angle_rate(film));
  if (growth < 0 && spares_sides(foam_, film)) {
    const double excess = std::max(arc_shape(alpha).f * d - limit_.t1_length, 0.0);
    event.time = now_ + std::max(excess / -growth, kFinestStep * options_.time_step);
  }
  if (norm(change) > 0) {
    const double strained =
        now_ + std::max(kLargestChange * d / norm(change), kFinestStrain * options_.time_step);
    if (strained < event.time) {
      event = {strained, Event::Kind::Strain, film};
    }
  }
  expect(event);
}

void EventCoarsening::expect(const Event& event) {
  if (event.time < options_.time_step) {
    queue_.expect(event);
  }
}

/// \returns false if a bubble would vanish that cannot.
bool EventCoarsening::settle(const Event& event, const AbortCheck& aborted) {
  if (event.kind == Event::Kind::Collapse) {
    return !foam_.has_bubble(event.element) || settle_collapse(event.element, aborted);
  }
  if (!foam_.has_film(event.element)) {
    return true;
  }
  const Index film = event.element;
  const std::array bubbles{foam_.left(2 * film), foam_.right(2 * film)};
  motion_.bring(foam_, rings_around(foam_, bubbles, kRings), now_);
  if (event.kind == Event::Kind::Strain) {
    relax_around(bubbles, aborted);
    return true;
  }
  if (film_is_due(film)) {
    const CascadeResult result = topological_cascade(foam_, rules(), std::array{film}, {});
    if (result.changed()) {
      relax_around(result.bubbles, aborted);
      return true;
    }
  }
  expect_film(film);
  return true;
}

bool EventCoarsening::settle_collapse(Index bubble, const AbortCheck& aborted) {
  motion_.bring(foam_, rings_around(foam_, std::array{bubble}, kRings), now_);
  const auto i = Foam::size(bubble);
  const double target = foam_.target_area[i];
  if (std::abs(foam_.area(bubble) - target) > kLargestChange * target) {
    relax_around(std::array{bubble}, aborted);
    if (motion_.area_rate(bubble) >= 0) {
      return true;
    }
  }
  if (foam_.sides[i] <= 3) {
    const CascadeResult result = topological_cascade(foam_, rules(), {}, std::array{bubble});
    if (result.changed()) {
      relax_around(result.bubbles, aborted);
    }
    return result.changed();
  }
  if (reduce_remnant(bubble, aborted)) {
    return true;
  }
  if (foam_.target_area[i] <= smallest_area_ * (1 + kReached)) {
    return false;
  }
  patience_[i] *= 0.25;
  expect_bubble(bubble);
  return true;
}

/// Takes a side from a bubble that is at its end with more than three, so that three are left at
/// last: swaps the shortest of its films with which the foam finds an equilibrium. \returns whether
/// there is one.
bool EventCoarsening::reduce_remnant(Index bubble, const AbortCheck& aborted) {
  const auto i = Foam::size(bubble);
  const State before{foam_, motion_, patience_};
  for (const Index film : films_to_swap(before.foam, bubble)) {
    std::vector<Index> around{foam_.left(2 * film), foam_.right(2 * film)};
    perform_t1(foam_, film);
    around.insert(around.end(), {foam_.left(2 * film), foam_.right(2 * film)});
    if (relax_patch(around, aborted) && foam_.sides[i] < before.foam.sides[i]) {
      move_on();
      return true;
    }
    undo(before);
  }
  return false;
}

/// Thesis 3.6.1: each two-sided bubble goes to the nearest corner and takes a side there.
void EventCoarsening::slide_two_sided_bubbles(const AbortCheck& aborted) {
  for (Index b = 0; b < foam_.bubble_capacity(); ++b) {
    if (!can_perform_t3(foam_, b)) {
      continue;
    }
    slide_two_sided_bubble(foam_, b, limit_.t1_length);
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

CollapseRules EventCoarsening::rules() const {
  CollapseRules rules;
  rules.t1 = [this](const Foam&, Index f) { return film_is_due(f); };
  rules.t2 = [this](const Foam& foam, Index b) {
    return foam.target_area[Foam::size(b)] <= limit_.t2_area * (1 + kReached);
  };
  rules.t3 = rules.t2;
  return rules;
}

/// Whether the film is to be swapped: short, shrinking and pulled shut.
bool EventCoarsening::film_is_due(Index film) const {
  return foam_.length(2 * film) <= limit_.t1_length * (1 + kReached) &&
         dot(foam_.chord(2 * film), motion_.chord_rate(foam_, film)) < 0 &&
         spares_sides(foam_, film) && pulled_shut(foam_, film);
}

/// The area at which the bubble is to give way. With more than three sides it does so while there
/// is still room for a swap, unless it was tried in vain.
double EventCoarsening::collapse_area(Index bubble) const {
  if (foam_.sides[Foam::size(bubble)] <= 3) {
    return limit_.t2_area;
  }
  const double room = std::max(limit_.t2_area, kRemnantArea / kSmallestArea * smallest_area_);
  return std::max(room * patience_[Foam::size(bubble)], smallest_area_);
}

/// After an event at these bubbles.
void EventCoarsening::relax_around(std::span<const Index> bubbles, const AbortCheck& aborted) {
  relax_patch(bubbles, aborted);
  move_on();
}

/// \returns whether an equilibrium was found.
bool EventCoarsening::relax_patch(std::span<const Index> bubbles, const AbortCheck& aborted) {
  const auto bring = [this](const Region& region) {
    motion_.bring(foam_, region.bubbles, now_);
    motion_.bring(foam_, region.rim, now_);
  };
  const bool converged = newton_.relax_patch(foam_, bubbles, limit_.t1_length, bring, aborted);
  iterations_ += newton_.iterations();
  if (!careful_) {
    return converged;
  }
  motion_.bring_all(foam_, now_);
  relax_whole(kCarefulTolerance, aborted);
  return foam_.report.converged;
}

void EventCoarsening::relax_whole(double tolerance, const AbortCheck& aborted) {
  const double goal = std::max(tolerance, options_.equilibrator.tolerance);
  iterations_ += newton_.equilibrate_to(foam_, goal, limit_.t1_length, aborted).iterations;
}

/// Predicts how what has relaxed goes on.
void EventCoarsening::move_on() {
  if (careful_) {
    predict_whole();
    expect_all();
    return;
  }
  const Region& region = newton_.patch_region();
  for (const Index b : region.bubbles) {
    motion_.set_area_rate(b, area_rate(foam_, b, options_.permeability));
    motion_.hold_wall(foam_, b);
  }
  if (const Step* response =
          newton_.patch_response(foam_, motion_.area_rates(), motion_.rates(), drift())) {
    motion_.take_patch(region, *response);
  }
  std::ranges::for_each(region.bubbles, [this](Index b) { expect_bubble(b); });
  std::ranges::for_each(region.films, [this](Index f) { expect_film(f); });
}

} // namespace foam
