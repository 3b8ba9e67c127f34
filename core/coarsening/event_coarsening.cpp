// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarsening/event_coarsening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "coarsening/end.h"
#include "coarsening/newton_rules.h"
#include "physics/gas.h"
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
constexpr double kFallbackTolerance = 1e-6;  // of a fallback frame's equilibria between events
constexpr int kEvents = 1024;                // in a frame,
constexpr int kEventsPerBubble = 16;         // and so many more for every bubble
constexpr int kRings = 3;                    // around an event that its operations look at

/// The films by which a bubble can lose a side, the shortest first, but those last whose other
/// bubble cannot well spare one.
std::vector<Film> films_to_swap(const Foam& foam, Bubble bubble) {
  std::vector<Film> films;
  for_each_half(foam, bubble, [&](Half h) {
    if (can_perform_t1(foam, h.film())) {
      films.push_back(h.film());
    }
  });
  std::ranges::stable_sort(
      films, {}, [&](Film f) { return std::pair(!spares_sides(foam, f), foam.length(f.half())); });
  return films;
}

} // namespace

EventCoarsening::EventCoarsening(const CoarseningOptions& options)
    : options_(options), newton_(options.equilibrator), in_need_(options) {}

void EventCoarsening::restart(Foam foam) {
  Field<Bubble, double> back_off(foam.bubble_half.size(), 1.0);
  foam_ = std::move(foam);
  back_off_ = std::move(back_off);
  motion_ = {};
  newton_.forget();
}

void EventCoarsening::undo(State state) {
  const std::uint64_t topology = foam_.topology + 1; // no one shall take it for one seen before
  foam_ = std::move(state.foam);
  foam_.topology = topology;
  motion_ = std::move(state.motion);
  back_off_ = std::move(state.back_off);
}

bool EventCoarsening::advance(const AbortCheck& aborted) {
  State before{foam_, {}, back_off_};
  iterations_ = 0;
  try {
    std::optional<Obstacle> obstacle = integrate(false, aborted);
    if (obstacle ? obstacle->cause != End::Cause::AllVanish : !foam_.report.converged) {
      undo(before);
      newton_.forget();
      obstacle = integrate(true, aborted);
    }
    if (!obstacle && !foam_.report.converged) {
      obstacle = {End::Cause::NoEquilibrium};
    }
    if (obstacle) {
      undo(before);
      newton_.forget();
      if (obstacle->cause != End::Cause::LastTwo && obstacle->cause != End::Cause::AllVanish) {
        in_need_.restart(foam_);
        if (in_need_.advance(aborted)) {
          foam_ = in_need_.foam();
          return true;
        }
        if (in_need_.foam().ended->cause == End::Cause::LastTwo) {
          obstacle = {End::Cause::LastTwo};
        }
      }
      foam_.ended = end_at(foam_, obstacle->cause, limit_, obstacle->bubble);
      return false;
    }
  } catch (...) {
    undo(std::move(before)); // a copy might not find the memory
    newton_.forget();
    throw;
  }
  foam_.time = before.foam.time + options_.time_step;
  foam_.report.iterations = iterations_;
  foam_.ended.reset();
  foam_.thresholds = limit_;
  return true;
}

std::optional<EventCoarsening::Obstacle> EventCoarsening::integrate(bool fallback,
                                                                    const AbortCheck& aborted) {
  fallback_ = fallback;
  lost_ = false;
  now_ = 0;
  const double spacing = foam_.mean_spacing();
  limit_ = newton_thresholds(thresholds(foam_, options_.thresholds), spacing);
  smallest_area_ = kSmallestArea * spacing * spacing;

  if (end_at(foam_, End::Cause::AllVanish, limit_).area <= limit_.t2_area &&
      foam_.bubble_count() > 2) {
    return Obstacle{End::Cause::AllVanish};
  }
  if (!foam_.report.converged) { // what follows is the response of an equilibrium
    iterations_ += newton_.equilibrate(foam_, limit_.t1_length, aborted).iterations;
  }
  predict_whole();
  queue_.clear(foam_);
  if (options_.two_sided_bubbles == TwoSidedBubbles::Slide) {
    slide_two_sided_bubbles(aborted);
  }
  schedule_all();
  for (const Film f : foam_.film_slots()) {
    if (foam_.bends(f) && film_is_due(f)) {
      schedule({.time = now_, .kind = Event::Kind::Close, .film = f});
    }
  }
  int events_left = kEvents + kEventsPerBubble * foam_.bubble_count();
  while (const auto event = queue_.next()) {
    if (aborted && aborted()) {
      throw Aborted();
    }
    now_ = event->time;
    const std::uint64_t topology = foam_.topology;
    if (events_left < 0 || lost_) {
      return Obstacle{End::Cause::NoEquilibrium};
    }
    if (const auto obstacle = handle(*event, aborted)) {
      return obstacle;
    }
    events_left -= foam_.topology != topology || event->kind == Event::Kind::Strain ? 1 : 0;
  }
  now_ = options_.time_step;
  motion_.finish(foam_, now_);
  balance_gas();
  relax_whole(options_.equilibrator.tolerance, aborted);
  return std::nullopt;
}

/// Gives a closed foam's bubbles back what has been lost on the way: by rounding and, where rates
/// are measured, by what they were off. The bubbles take part whose rates those are; on a torus
/// all.
void EventCoarsening::balance_gas() {
  if (!foam_.surroundings.closed()) {
    return;
  }
  const AreaRate rate = area_rate(view_of(std::as_const(foam_)), options_.permeability);
  double lost = 0;
  double share = 0; // the gas of those that take part
  std::vector<Bubble> taking_part;
  for (const Bubble b : foam_.bubble_slots()) {
    if (foam_.has_bubble(b)) {
      const double gas = foam_.target_area[b];
      lost += foam_.area(b) - gas;
      if (foam_.surroundings.periodic() || rate.takes_a_share(b)) {
        share += gas;
        taking_part.push_back(b);
      }
    }
  }
  for (const Bubble b : taking_part) {
    foam_.target_area[b] *= 1 + lost / share;
  }
}

/// \pre the whole foam stands at this instant
void EventCoarsening::predict_whole() {
  Field<Bubble, double> rates = area_rates(foam_, options_.permeability);
  const newton::StepView* response = newton_.response(foam_, rates, motion_.expected(), drift());
  motion_.begin(foam_, std::move(rates), now_);
  if (response != nullptr) {
    motion_.take_whole(newton_.region(), *response, !fallback_);
  } else {
    motion_.rest();
  }
}

void EventCoarsening::schedule_all() {
  queue_.clear(foam_);
  for (const Bubble b : foam_.bubble_slots()) {
    if (foam_.has_bubble(b)) {
      schedule_bubble(b);
    }
  }
  for (const Film f : foam_.film_slots()) {
    if (foam_.has_film(f)) {
      schedule_film(f);
    }
  }
}

/// \pre the bubble stands at this instant
void EventCoarsening::schedule_bubble(Bubble bubble) {
  queue_.cancel(bubble);
  const double rate = motion_.area_rate(bubble);
  if (rate < 0) {
    const double excess = foam_.target_area[bubble] - collapse_area(bubble);
    schedule({.time = now_ + std::max(excess, 0.0) / -rate,
              .kind = Event::Kind::Collapse,
              .bubble = bubble});
  }
}

/// \pre the film stands at this instant
void EventCoarsening::schedule_film(Film film) {
  queue_.cancel(film);
  if (foam_.wall(film.half())) {
    return;
  }
  const Vec2 chord = foam_.chord(film.half());
  const Vec2 change = motion_.chord_rate(foam_, film);
  const double d = norm(chord);
  Event event{
      .time = std::numeric_limits<double>::infinity(), .kind = Event::Kind::Close, .film = film};
  const double alpha = foam_.half_angle(film.half());
  const double growth = arc_growth(chord, change, alpha, motion_.angle_rate(film));
  if (growth < 0 && spares_sides(foam_, film)) {
    const double excess = std::max(arc_shape(alpha).f * d - limit_.t1_length, 0.0);
    event.time = now_ + std::max(excess / -growth, kFinestStep * options_.time_step);
  }
  if (norm(change) > 0) {
    const double strained =
        now_ + std::max(kLargestChange * d / norm(change), kFinestStrain * options_.time_step);
    if (strained < event.time) {
      event.time = strained;
      event.kind = Event::Kind::Strain;
    }
  }
  schedule(event);
}

void EventCoarsening::schedule(const Event& event) {
  if (event.time < options_.time_step) {
    queue_.schedule(event);
  }
}

std::optional<EventCoarsening::Obstacle> EventCoarsening::handle(const Event& event,
                                                                 const AbortCheck& aborted) {
  if (event.kind == Event::Kind::Collapse) {
    return foam_.has_bubble(event.bubble) ? handle_collapse(event.bubble, aborted) : std::nullopt;
  }
  const Film film = event.film;
  if (!foam_.has_film(film)) {
    return std::nullopt;
  }
  const std::array bubbles{foam_.left(film.half()), foam_.right(film.half())};
  motion_.bring(foam_, rings_around(foam_, bubbles, kRings), now_);
  if (event.kind == Event::Kind::Strain) {
    relax_around(bubbles, aborted);
    return std::nullopt;
  }
  if (film_is_due(film)) {
    const CascadeResult result = topological_cascade(foam_, rules(), std::array{film}, {});
    if (result.changed()) {
      relax_around(result.bubbles, aborted);
      return std::nullopt;
    }
  }
  schedule_film(film);
  return std::nullopt;
}

std::optional<EventCoarsening::Obstacle>
EventCoarsening::handle_collapse(Bubble bubble, const AbortCheck& aborted) {
  motion_.bring(foam_, rings_around(foam_, std::array{bubble}, kRings), now_);
  const double target = foam_.target_area[bubble];
  if (std::abs(foam_.area(bubble) - target) > kLargestChange * target) {
    relax_around(std::array{bubble}, aborted);
    if (motion_.area_rate(bubble) >= 0) {
      return std::nullopt;
    }
  }
  if (foam_.sides[bubble] <= 3) {
    const CascadeResult result = topological_cascade(foam_, rules(), {}, std::array{bubble});
    if (!result.changed()) {
      return cannot_vanish(bubble);
    }
    relax_around(result.bubbles, aborted);
    return std::nullopt;
  }
  if (reduce_sides(bubble, aborted)) {
    return std::nullopt;
  }
  if (foam_.target_area[bubble] <= smallest_area_ * (1 + kReached)) {
    return cannot_vanish(bubble);
  }
  back_off_[bubble] *= 0.25;
  schedule_bubble(bubble);
  return std::nullopt;
}

EventCoarsening::Obstacle EventCoarsening::cannot_vanish(Bubble bubble) const {
  const bool last_two = !foam_.surroundings.periodic() && foam_.bubble_count() == 2;
  return {last_two ? End::Cause::LastTwo : End::Cause::CannotVanish, bubble};
}

/// Takes a side from a bubble that is at its end with more than three, so that three are left at
/// last: swaps the shortest of its films with which the foam finds an equilibrium. \returns whether
/// there is one.
bool EventCoarsening::reduce_sides(Bubble bubble, const AbortCheck& aborted) {
  const State before{foam_, motion_, back_off_};
  for (const Film film : films_to_swap(before.foam, bubble)) {
    std::vector<Bubble> around{foam_.left(film.half()), foam_.right(film.half())};
    perform_t1(foam_, film);
    around.insert(around.end(), {foam_.left(film.half()), foam_.right(film.half())});
    if (relax_patch(around, aborted) && foam_.sides[bubble] < before.foam.sides[bubble]) {
      move_on();
      return true;
    }
    undo(before);
  }
  return false;
}

/// Thesis 3.6.1: each two-sided bubble goes to the nearest corner and takes a side there.
void EventCoarsening::slide_two_sided_bubbles(const AbortCheck& aborted) {
  for (const Bubble b : foam_.bubble_slots()) {
    if (!can_perform_t3(foam_, b)) {
      continue;
    }
    slide_two_sided_bubble(foam_, b, limit_.t1_length);
    std::vector<Bubble> around{b};
    Film shortest = kNone;
    for_each_half(foam_, b, [&](Half h) {
      const Film film = foam_.previous_around_junction(h).film();
      if (shortest == kNone || foam_.length(film.half()) < foam_.length(shortest.half())) {
        shortest = film;
      }
    });
    if (can_perform_t1(foam_, shortest) && spares_sides(foam_, shortest)) {
      for (const Bubble bubble : perform_t1(foam_, shortest)) {
        around.push_back(bubble);
      }
    }
    relax_around(around, aborted);
  }
}

CollapseRules EventCoarsening::rules() const {
  CollapseRules rules;
  rules.t1 = [this](const Foam&, Film f) { return film_is_due(f); };
  rules.t2 = [this](const Foam& foam, Bubble b) {
    return foam.target_area[b] <= limit_.t2_area * (1 + kReached);
  };
  rules.t3 = rules.t2;
  return rules;
}

/// Whether the film is to be swapped: short, shrinking and pulled shut.
bool EventCoarsening::film_is_due(Film film) const {
  return foam_.length(film.half()) <= limit_.t1_length * (1 + kReached) &&
         dot(foam_.chord(film.half()), motion_.chord_rate(foam_, film)) < 0 &&
         spares_sides(foam_, film) && unstable_to_t1(foam_, film);
}

/// The area at which the bubble is to give way. With more than three sides it does so while there
/// is still room for a swap, unless it was tried in vain.
double EventCoarsening::collapse_area(Bubble bubble) const {
  if (foam_.sides[bubble] <= 3) {
    return limit_.t2_area;
  }
  const double room = std::max(limit_.t2_area, kManySidedArea / kSmallestArea * smallest_area_);
  return std::max(room * back_off_[bubble], smallest_area_);
}

/// After an event at these bubbles.
void EventCoarsening::relax_around(std::span<const Bubble> bubbles, const AbortCheck& aborted) {
  const bool found = relax_patch(bubbles, aborted);
  lost_ = fallback_ && !found;
  move_on();
}

/// \returns whether an equilibrium was found.
bool EventCoarsening::relax_patch(std::span<const Bubble> bubbles, const AbortCheck& aborted) {
  const auto bring = [this](const Region& region) {
    motion_.bring(foam_, region.bubbles, now_);
    motion_.bring(foam_, region.rim, now_);
  };
  const bool converged = newton_.relax_patch(foam_, bubbles, limit_.t1_length, bring, aborted);
  iterations_ += newton_.iterations();
  if (!fallback_) {
    return converged;
  }
  motion_.bring_all(foam_, now_);
  relax_whole(kFallbackTolerance, aborted);
  return foam_.report.converged;
}

void EventCoarsening::relax_whole(double tolerance, const AbortCheck& aborted) {
  const double goal = std::max(tolerance, options_.equilibrator.tolerance);
  iterations_ += newton_.equilibrate_to(foam_, goal, limit_.t1_length, aborted).iterations;
}

/// Predicts how what has relaxed goes on.
void EventCoarsening::move_on() {
  if (fallback_) {
    predict_whole();
    schedule_all();
    return;
  }
  const Region& region = newton_.patch_region();
  const AreaRate rate = area_rate(view_of(std::as_const(foam_)), options_.permeability);
  for (const Bubble b : region.bubbles) {
    motion_.set_area_rate(b, rate(b));
    motion_.hold_wall(foam_, b);
  }
  if (const newton::StepView* response =
          newton_.patch_response(foam_, motion_.area_rates(), motion_.rates(), drift())) {
    motion_.take_patch(region, *response);
  }
  std::ranges::for_each(region.bubbles, [this](Bubble b) { schedule_bubble(b); });
  std::ranges::for_each(region.films, [this](Film f) { schedule_film(f); });
}

} // namespace foam
