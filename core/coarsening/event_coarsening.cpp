// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarsening/event_coarsening.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "coarsening/end.h"
#include "coarsening/newton_rules.h"
#include "mesh/neighbourhood.h"
#include "physics/gas.h"
#include "physics/step_limits.h"
#include "physics/swap_rule.h"
#include "topology/operations.h"
#include "topology/wall_contact.h"

namespace foam {
namespace {

constexpr double kReached = 1e-9;            // relative slack of a threshold that has been met
constexpr double kFinestStep = 1.0 / 64;     // of a step, towards a predicted T1
constexpr double kFinestStrain = 1.0 / 4096; // of a step, from one renewal to the next
constexpr double kLargestChange = 0.25;      // of a chord or an area before the response is renewed
constexpr int kEvents = 1024;                // in a step,
constexpr int kEventsPerBubble = 16;         // and so many more for every bubble
constexpr int kRings = 3;                    // around an event that its operations look at

// In units of the time in which a seventh side brings a bubble the mean area:
constexpr double kLongestStep = 0.0125;
constexpr double kSameTime = 1e-7;  // to which T1s are found where the whole foam relaxes
constexpr double kLookAgain = 1e-4; // at a short film that is not pulled shut

constexpr double kGasError = 1e-7; // of the mean area, that rates may be off by in an interval

// Of the mean spacing; no film is followed further, for its direction is lost in rounding.
constexpr double kShortestFilm = 1e-5;

constexpr Index kFewBubbles = 256;      // of which all feel an event
constexpr double kBetweenEvents = 1e-6; // tolerance of equilibria in a step
constexpr int kShortRelaxation = 12;    // iterations along the equilibria of one topology

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

double largest_area(const Foam& foam) {
  double largest = 0;
  for (const Bubble b : foam.bubble_slots()) {
    largest = std::max(largest, foam.has_bubble(b) ? foam.target_area[b] : 0);
  }
  return largest;
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
  rates_change_ = area_rates_change(foam_);
  longest_ = std::numeric_limits<double>::infinity();
  note_thresholds();
}

void EventCoarsening::undo(State state) {
  const std::uint64_t topology = foam_.topology + 1; // no one shall take it for one seen before
  foam_ = std::move(state.foam);
  foam_.topology = topology;
  motion_ = std::move(state.motion);
  back_off_ = std::move(state.back_off);
}

bool EventCoarsening::advance(const AbortCheck& aborted) {
  foam_.operations.clear();
  State before{foam_, {}, back_off_};
  iterations_ = 0;
  const bool few = foam_.bubble_count() <= kFewBubbles;
  try {
    std::optional<Obstacle> obstacle = integrate(few, aborted);
    if (obstacle ? obstacle->cause != End::Cause::AllVanish : !foam_.report.converged) {
      undo(before);
      newton_.forget();
      obstacle = integrate(!few, aborted);
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
          note_thresholds();
          return true;
        }
        if (in_need_.foam().ended->cause == End::Cause::LastTwo) {
          obstacle = {End::Cause::LastTwo};
        }
      }
      foam_.ended = end_at(foam_, *obstacle, limit_, options_.thresholds);
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
  note_thresholds();
  return true;
}

void EventCoarsening::note_thresholds() {
  whole_ = foam_.bubble_count() <= kFewBubbles;
  set_limits();
  foam_.thresholds = limit_;
}

/// \param time in this step, s
void EventCoarsening::be_at(double time) {
  now_ = time;
  foam_.time = begin_ + time;
}

/// Through a frame. \param whole whether the whole foam relaxes at every event
std::optional<Obstacle> EventCoarsening::integrate(bool whole, const AbortCheck& aborted) {
  whole_ = whole;
  double remaining = options_.time_step;
  do {
    if (const auto obstacle = step(remaining, aborted)) {
      return obstacle;
    }
    remaining -= step_;
  } while (remaining > 0);
  return std::nullopt;
}

/// The first of equal steps into which a time (s) is divided, s. Where no bubble's area changes in
/// it but for rounding, as all have six sides, say, that is all of it.
double EventCoarsening::length_of_step(double time, const Field<Bubble, double>& rates) const {
  for (const Bubble b : foam_.bubble_slots()) {
    if (foam_.has_bubble(b) && std::abs(rates[b]) * time > kReached * foam_.target_area[b]) {
      return time / std::max(std::ceil(time / (kLongestStep * unit_of_time_)), 1.0);
    }
  }
  return time;
}

/// Takes the thresholds of the foam as it is, with what is too small for any foam.
void EventCoarsening::set_limits() {
  const double spacing = foam_.mean_spacing();
  const double mean_area = spacing * spacing;
  limit_ = thresholds(foam_, options_.thresholds);
  limit_.t1_length =
      std::max(limit_.t1_length, (whole_ ? kShortestFilm : kSmallestLength) * spacing);
  limit_.t2_area = std::max(limit_.t2_area, kManySidedArea * mean_area);
  room_ = whole_ ? kManySidedArea * mean_area : limit_.t2_area;
  smallest_area_ = kSmallestArea * mean_area;
}

/// Goes through a step of at most the remaining time (s) from one event to the next.
std::optional<Obstacle> EventCoarsening::step(double remaining, const AbortCheck& aborted) {
  begin_ = foam_.time;
  be_at(0);
  changed_ = 0;
  unit_of_time_ =
      foam_.mean_area() / von_neumann_constant(foam_.surface_tension, options_.permeability);
  set_limits();
  if (foam_.bubble_count() > 2 && largest_area(foam_) <= limit_.t2_area) {
    return Obstacle{End::Cause::AllVanish};
  }
  if (!foam_.report.converged) { // what follows is the response of an equilibrium
    iterations_ += newton_.equilibrate(foam_, limit_.t1_length, aborted).iterations;
  }
  Field<Bubble, double> rates = area_rates(foam_, options_.permeability);
  step_ = length_of_step(remaining, rates);
  predict_whole(std::move(rates));
  queue_.clear(foam_);
  if (options_.two_sided_bubbles == TwoSidedBubbles::Slide) {
    slide_two_sided_bubbles(aborted);
  }
  schedule_all();
  const std::optional<Obstacle> obstacle = whole_ ? step_whole(aborted) : step_by_patches(aborted);
  predicted_ -= step_;
  return obstacle;
}

std::optional<Obstacle> EventCoarsening::step_by_patches(const AbortCheck& aborted) {
  for (const Film f : foam_.film_slots()) {
    if (foam_.may_close(f) && film_is_due(f)) {
      schedule({.time = now_, .kind = Event::Kind::Close, .film = f});
    }
  }
  int events_left = kEvents + kEventsPerBubble * foam_.bubble_count();
  while (const auto event = queue_.next()) {
    if (aborted && aborted()) {
      throw Aborted();
    }
    be_at(event->time);
    const std::uint64_t topology = foam_.topology;
    if (events_left < 0) {
      return Obstacle{End::Cause::NoEquilibrium};
    }
    if (const auto obstacle = handle(*event, aborted)) {
      return obstacle;
    }
    events_left -= foam_.topology != topology || event->kind == Event::Kind::Strain ? 1 : 0;
  }
  be_at(step_);
  motion_.finish(foam_, now_);
  balance_gas();
  relax_whole(0, limit_.t1_length, options_.equilibrator.maximum_iterations, aborted);
  return std::nullopt;
}

/// Follows the whole foam's equilibrium to where the next event is expected, expects it anew from
/// there, be it earlier, and so finds its time as Newton's method finds a root. The end of a small
/// bubble, which the films around do not feel, needs no equilibrium.
std::optional<Obstacle> EventCoarsening::step_whole(const AbortCheck& aborted) {
  constexpr Obstacle no_equilibrium{End::Cause::NoEquilibrium};
  bool at_end = false;
  for (int left = kEvents + kEventsPerBubble * foam_.bubble_count(); left > 0; --left) {
    if (aborted && aborted()) {
      throw Aborted();
    }
    std::optional<Event> event = queue_.next();
    if (const auto touch = next_touch(); touch && (!event || touch->time < event->time)) {
      event = touch;
    }
    if (!event && at_end) {
      return std::nullopt;
    }
    const bool vanishes = !rates_change_ && event && event->kind == Event::Kind::Collapse &&
                          foam_.sides[event->bubble] <= 3;
    if (vanishes) {
      be_at(event->time);
      motion_.bring_all(foam_, now_);
    }
    if (vanishes || (event && std::abs(event->time - now_) <= same_time())) {
      if (const auto obstacle = handle(*event, aborted)) {
        return obstacle;
      }
      if (!foam_.report.converged) {
        return no_equilibrium;
      }
      at_end = false;
    } else {
      if (!arrive(event ? event->time : step_, aborted)) {
        return no_equilibrium;
      }
      at_end = !event && now_ == step_;
      if (at_end && !has_short_film()) {
        return std::nullopt;
      }
      predict_whole();
      schedule_all();
    }
  }
  return no_equilibrium;
}

/// Whether there is a film that may have closed on the way.
bool EventCoarsening::has_short_film() const {
  for (const Film f : foam_.film_slots()) {
    const Half h = f.half();
    // An arc is no shorter than its chord.
    if (foam_.may_close(f) && norm(foam_.chord(h)) < limit_.t1_length &&
        foam_.length(h) < limit_.t1_length && spares_sides(foam_, f)) {
      return true;
    }
  }
  return false;
}

/// When a film reaches an obstacle that lies free in a bubble, as all move along their response, if
/// one does in this step. \pre the whole foam stands at this instant
std::optional<Event> EventCoarsening::next_touch() const {
  const auto nearest = nearest_film(foam_);
  if (!nearest) {
    return std::nullopt;
  }
  Foam ahead = foam_;
  Motion motion = motion_;
  const auto apart_at = [&](double time) {
    motion.bring_all(ahead, time);
    const auto approach = nearest_film(ahead);
    return !approach || approach->gap > 0;
  };
  double before = now_;
  double after = step_;
  if (nearest->gap > 0) {
    if (apart_at(after)) {
      return std::nullopt;
    }
    while (after - before > 0.5 * same_time()) {
      const double middle = 0.5 * (before + after);
      (apart_at(middle) ? before : after) = middle;
    }
  }
  return Event{.time = before, .kind = Event::Kind::Touch};
}

/// Parts the film that has reached an obstacle.
void EventCoarsening::touch(const AbortCheck& aborted) {
  const auto nearest = nearest_film(foam_);
  const std::array around{foam_.left(nearest->film), foam_.right(nearest->film)};
  changed_ = now_;
  perform_touch(foam_, *nearest);
  relax_around(around, aborted);
}

/// Gives a closed foam's bubbles back what has been lost on the way: by rounding and, where rates
/// are measured, by what they were off. The bubbles take part whose rates those are; on a torus
/// all.
void EventCoarsening::balance_gas() {
  if (!foam_.surroundings.closed()) {
    return;
  }
  const AreaRate rate = area_rate(view_of(std::as_const(foam_)), options_.permeability);
  const bool periodic = foam_.surroundings.periodic();
  double lost = periodic ? foam_.surroundings.lattice.area() : 0;
  double share = 0; // the gas of those that take part
  std::vector<Bubble> taking_part;
  for (const Bubble b : foam_.bubble_slots()) {
    if (foam_.has_bubble(b)) {
      const double gas = foam_.target_area[b];
      lost += (periodic ? 0 : foam_.area(b)) - gas;
      if (periodic || rate.takes_a_share(b)) {
        share += gas;
        taking_part.push_back(b);
      }
    }
  }
  for (const Bubble b : taking_part) {
    foam_.target_area[b] *= 1 + lost / share;
  }
}

/// To which a T1 is found, s.
double EventCoarsening::same_time() const {
  return kSameTime * unit_of_time_;
}

/// Brings the whole foam to an instant, or to one before it: where rates would change too much on
/// the way, or from which on it has no equilibrium of this topology that Newton's method would find
/// at once. \returns false if there is none.
bool EventCoarsening::arrive(double time, const AbortCheck& aborted) {
  const State before{foam_, motion_, back_off_};
  const double nearest = 0.5 * same_time();
  double there = std::clamp(time, now_ - longest_, now_ + longest_);
  do {
    const bool at_end = there == step_;
    at_end ? motion_.finish(foam_, there) : motion_.bring_all(foam_, there);
    double part = 0.5;
    if (!rates_change_ || correct_areas(there - now_, part, aborted)) {
      if (at_end) {
        balance_gas();
      }
      relax_whole(at_end ? 0 : kBetweenEvents, 0, kShortRelaxation, aborted);
      if (foam_.report.converged) {
        be_at(there);
        return true;
      }
    }
    undo(before);
    there = now_ + part * (there - now_);
  } while (std::abs(there - now_) > nearest);
  return false;
}

/// Takes into account at the end of an interval (s) what the rates r have become there. With r₀ and
/// r₀' known at its beginning areas came by h·r₀ + ½h²·r₀'; with r₁ they come, to the next order,
/// by ⅓h·(2r₀ + r₁) + ⅙h²·r₀'. The difference says how far off the first is, and so how long an
/// interval may be. \param part of the interval that would do if it is too long \returns whether
/// it does, and has an equilibrium
bool EventCoarsening::correct_areas(double interval, double& part, const AbortCheck& aborted) {
  relax_whole(kBetweenEvents, 0, kShortRelaxation, aborted);
  if (!foam_.report.converged) {
    return false;
  }
  const Field<Bubble, double> rates = area_rates(foam_, options_.permeability);
  double error = 0;
  for (const Bubble b : foam_.bubble_slots()) {
    if (foam_.has_bubble(b)) {
      const double correction = interval / 3 * (rates[b] - motion_.area_rate(b));
      foam_.target_area[b] += correction;
      error = std::max(error, std::abs(correction));
    }
  }
  const double room = std::cbrt(kGasError * foam_.mean_area() / error); // error ~ interval³
  const double shortest = kLookAgain * unit_of_time_;                   // where rates have a kink
  longest_ = std::max(std::abs(interval) * std::clamp(0.9 * room, 0.1, 4.0), shortest);
  if (room < 1 && std::abs(interval) > shortest) {
    part = std::min(longest_ / std::abs(interval), 0.9);
    return false;
  }
  return true;
}

void EventCoarsening::predict_whole() {
  predict_whole(area_rates(foam_, options_.permeability));
}

/// \param rates of the bubbles' areas \pre the whole foam stands at this instant
void EventCoarsening::predict_whole(Field<Bubble, double> rates) {
  set_limits();
  const newton::StepView* response = newton_.response(foam_, rates, motion_.expected(), drift());
  motion_.begin(foam_, std::move(rates), now_);
  if (response != nullptr) {
    const double since = now_ - predicted_;
    const double bend = (step_ - now_) / since;
    motion_.take_whole(newton_.region(), *response, bend > 0 && bend < 1.5 ? bend : 0);
    if (rates_change_) {
      motion_.bend_areas(area_rate_changes(foam_, options_.permeability, motion_.rates().angles));
    }
  } else {
    motion_.rest();
  }
  predicted_ = now_;
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
  const double excess = std::max(foam_.target_area[bubble] - collapse_area(bubble), 0.0);
  const double rate = motion_.area_rate(bubble);
  const double root = std::sqrt(rate * rate - 2 * motion_.area_bend(bubble) * excess);
  if (root > rate) { // and it does come to that area
    schedule({.time = now_ + 2 * excess / (root - rate),
              .kind = Event::Kind::Collapse,
              .bubble = bubble});
  }
}

/// \pre the film stands at this instant
void EventCoarsening::schedule_film(Film film) {
  queue_.cancel(film);
  if (!foam_.may_close(film)) {
    return;
  }
  if (whole_) {
    double wait = time_to_close(film);
    if (wait <= same_time() && !film_is_due(film)) {
      wait = kLookAgain * unit_of_time_;
    }
    schedule({.time = std::max(now_ + wait, changed_), .kind = Event::Kind::Close, .film = film});
    return;
  }
  const Vec2 chord = foam_.chord(film.half());
  const Vec2 change = motion_.chord_rate(foam_, film);
  const double d = norm(chord);
  Event event{
      .time = std::numeric_limits<double>::infinity(), .kind = Event::Kind::Close, .film = film};
  const double growth = length_growth(film);
  if (growth < 0 && spares_sides(foam_, film)) {
    const double excess = std::max(foam_.length(film.half()) - limit_.t1_length, 0.0);
    event.time = now_ + std::max(excess / -growth, kFinestStep * step_);
  }
  if (norm(change) > 0) {
    const double strained =
        now_ + std::max(kLargestChange * d / norm(change), kFinestStrain * step_);
    if (strained < event.time) {
      event.time = strained;
      event.kind = Event::Kind::Strain;
    }
  }
  schedule(event);
}

/// When the film will have the T1 length, or has had it, s from now; a film collapses as √time or
/// slower, so that its squared length, carried on, does not fall too fast.
double EventCoarsening::time_to_close(Film film) const {
  const double length = foam_.length(film.half());
  const double growth = length_growth(film);
  if (growth >= 0 || !spares_sides(foam_, film)) {
    return std::numeric_limits<double>::infinity();
  }
  const double limit = limit_.t1_length;
  return (length - limit) * (length + limit) / (2 * length * -growth);
}

/// cm/s
double EventCoarsening::length_growth(Film film) const {
  const Half h = film.half();
  if (foam_.wall(h)) {
    return foam_.length(h) * motion_.relative_growth(foam_, film);
  }
  return arc_growth(foam_.chord(h), motion_.chord_rate(foam_, film), foam_.half_angle(h),
                    motion_.angle_rate(film));
}

void EventCoarsening::schedule(const Event& event) {
  if (event.time < step_) {
    queue_.schedule(event);
  }
}

std::optional<Obstacle> EventCoarsening::handle(const Event& event, const AbortCheck& aborted) {
  if (event.kind == Event::Kind::Collapse) {
    return foam_.has_bubble(event.bubble) ? handle_collapse(event.bubble, aborted) : std::nullopt;
  }
  if (event.kind == Event::Kind::Touch) {
    touch(aborted);
    return std::nullopt;
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
  if (film_is_due(film) && can_perform_t1(foam_, film)) {
    swap(film, aborted);
    return std::nullopt;
  }
  schedule_film(film);
  return std::nullopt;
}

std::optional<Obstacle> EventCoarsening::handle_collapse(Bubble bubble, const AbortCheck& aborted) {
  motion_.bring(foam_, rings_around(foam_, std::array{bubble}, kRings), now_);
  const double target = foam_.target_area[bubble];
  if (std::abs(foam_.area(bubble) - target) > kLargestChange * target) {
    relax_around(std::array{bubble}, aborted);
    if (motion_.area_rate(bubble) >= 0) {
      return std::nullopt;
    }
  }
  if (foam_.sides[bubble] <= 3) {
    return vanish(bubble, aborted) ? std::nullopt : std::optional(cannot_vanish(bubble));
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

Obstacle EventCoarsening::cannot_vanish(Bubble bubble) const {
  const bool last_two = !foam_.surroundings.has_images() && foam_.bubble_count() == 2;
  return {last_two ? End::Cause::LastTwo : End::Cause::CannotVanish, bubble};
}

void EventCoarsening::swap(Film film, const AbortCheck& aborted) {
  relax_around(swap_early(film, whole_ ? std::max(time_to_close(film), changed_ - now_) : 0),
               aborted);
}

/// Swaps a film some time (s) before its time has come, or after. By von Neumann's law, away from
/// walls, the bubbles beside it, which lose a side, and those at its ends, which gain one, would
/// have kept their rates so long: they exchange the gas that makes up for it, as far as they can
/// spare it. \returns the bubbles around
std::array<Bubble, 4> EventCoarsening::swap_early(Film film, double early) {
  changed_ = now_;
  const auto [left, right] = perform_t1(foam_, film);
  const std::array around{left, right, foam_.left(film.half()), foam_.right(film.half())};
  const auto outside = [](Bubble b) { return b.is_outside(); };
  if (foam_.surroundings.has_walls() && std::ranges::any_of(around, outside)) {
    return around;
  }
  double gas = early * von_neumann_constant(foam_.surface_tension, options_.permeability);
  for (const Bubble b : around) {
    const double spare =
        b.is_outside() ? std::numeric_limits<double>::infinity() : 0.5 * foam_.target_area[b];
    gas = std::clamp(gas, -spare, spare);
  }
  for (std::size_t i = 0; i < around.size(); ++i) {
    if (!around[i].is_outside()) {
      foam_.target_area[around[i]] += i < 2 ? gas : -gas;
    }
  }
  return around;
}

/// Removes a bubble of two or three sides and gives its gas to those beside it, in equal parts. By
/// von Neumann's law that is what they would have got: each loses a side, or two to a two-sided
/// bubble, and with it K of its rate, or 2K, for the time that the bubble had left. As in
/// equilibrium the films around are as if it were not there (D. Weaire, Phil. Mag. Lett. 79 (1999)
/// 491), it hardly matters how early it goes. \returns whether it can.
bool EventCoarsening::vanish(Bubble bubble, const AbortCheck& aborted) {
  const double gas = foam_.target_area[bubble];
  std::vector<std::pair<Bubble, double>> heirs;
  double shares = 0;
  for_each_half(foam_, bubble, [&](Half h) {
    shares += foam_.wall(h) ? 0 : 1;
    if (!foam_.right(h).is_outside()) {
      heirs.emplace_back(foam_.right(h), foam_.target_area[foam_.right(h)]);
    }
  });
  changed_ = now_;
  if (can_perform_t2(foam_, bubble)) {
    perform_t2(foam_, bubble);
  } else if (can_perform_t3(foam_, bubble)) {
    perform_t3(foam_, bubble);
  } else {
    return false;
  }
  std::vector<Bubble> around;
  for (const auto& [heir, before] : heirs) {
    foam_.target_area[heir] = before;
  }
  for (const auto& [heir, before] : heirs) {
    foam_.target_area[heir] += gas / shares;
    around.push_back(heir);
  }
  relax_around(around, aborted);
  return true;
}

/// Takes a side from a bubble that is at its end with more than three, so that three are left at
/// last: swaps the shortest of its films with which the foam finds an equilibrium. As the bubble
/// shrinks to nothing its films do too; that would be their time. \returns whether there is one.
bool EventCoarsening::reduce_sides(Bubble bubble, const AbortCheck& aborted) {
  const State before{foam_, motion_, back_off_};
  const double constant = von_neumann_constant(foam_.surface_tension, options_.permeability);
  const double time_left =
      foam_.target_area[bubble] / std::max(-motion_.area_rate(bubble), constant);
  for (const Film film : films_to_swap(before.foam, bubble)) {
    const std::array around = swap_early(film, whole_ ? time_left : 0);
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
  const TwoSidedRule rule{options_.two_sided_bubbles, limit_.t1_length};
  for (const Bubble b : foam_.bubble_slots()) {
    if (!can_perform_t3(foam_, b) || !rule.slides(foam_, b)) {
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

/// Whether the film is to be swapped: short, shrinking and pulled shut.
bool EventCoarsening::film_is_due(Film film) const {
  const bool is_short = whole_ ? time_to_close(film) <= same_time()
                               : foam_.length(film.half()) <= limit_.t1_length * (1 + kReached);
  return is_short && motion_.relative_growth(foam_, film) < 0 && spares_sides(foam_, film) &&
         unstable_to_t1(foam_, film);
}

/// The area at which the bubble is to give way. With more than three sides it does so while there
/// is still room for a swap, unless it was tried in vain.
double EventCoarsening::collapse_area(Bubble bubble) const {
  if (foam_.sides[bubble] <= 3) {
    return limit_.t2_area;
  }
  return std::max(room_ * back_off_[bubble], smallest_area_);
}

/// After an event at these bubbles.
void EventCoarsening::relax_around(std::span<const Bubble> bubbles, const AbortCheck& aborted) {
  relax_patch(bubbles, aborted);
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
  if (!whole_) {
    return converged;
  }
  relax_whole(kBetweenEvents, limit_.t1_length, options_.equilibrator.maximum_iterations, aborted);
  return foam_.report.converged;
}

/// \param tolerance if it is above the equilibrium's \param t1_length of films that are swapped on
/// the way, cm \param most iterations
void EventCoarsening::relax_whole(double tolerance, double t1_length, int most,
                                  const AbortCheck& aborted) {
  const double goal = std::max(tolerance, options_.equilibrator.tolerance);
  iterations_ += newton_.equilibrate_to(foam_, goal, t1_length, most, aborted).iterations;
}

/// Predicts how what has relaxed goes on.
void EventCoarsening::move_on() {
  if (whole_) {
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
