// SPDX-License-Identifier: GPL-3.0-or-later
#include "deformation/torus_deformation.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "base/error.h"
#include "physics/step_limits.h"
#include "physics/swap_rule.h"
#include "topology/operations.h"

namespace foam {
namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

// Strains:
constexpr double kLongestStep = 0.05;
constexpr double kAtHand = 2e-6;      // to a T1, from where its strain is known to about the square
constexpr double kAtHandAtEnd = 1e-5; // the same at a frame's end, where no film is to be shorter
constexpr double kTogether = 1e-9;    // between T1s that are one event
constexpr double kFinest = 1e-7;      // interval that is tried
constexpr double kTurn = 1e-12;       // rounding of an amplitude

constexpr double kCurving =
    4; // relative error of a predicted closing, per strain that it lies ahead
constexpr double kDrift = 1e-4;      // per strain, at which a foam may leave equilibrium
constexpr int kShortRelaxation = 8;  // iterations along the equilibria of one topology
constexpr double kSwapLength = 1e-3; // of the mean spacing: films that may be swapped after a T1 …
constexpr double kSwapLengthFar = 0.05; // … and if that leads nowhere
constexpr int kRounds = 64;             // of MaximumIterations, that an avalanche may take

bool may_vanish(const Foam& foam, Film film) {
  return foam.may_close(film) && spares_sides(foam, film) && can_perform_t1(foam, film);
}

} // namespace

TorusDeformation::TorusDeformation(const DeformationOptions& options)
    : options_(options), flow_(velocity_gradient(options.kind)), newton_(options.equilibrator) {
  check(options);
}

double TorusDeformation::frame_time() const {
  return std::abs(options_.strain_step);
}

void TorusDeformation::restart(Foam foam) {
  if (!foam.surroundings.periodic()) {
    throw FoamError("a foam is strained by its periods, but this one has none: its Boundary is not "
                    "Periodic");
  }
  foam_ = std::move(foam);
  make_compact(foam_);
  if (options_.amplitude == 0 || foam_.strain_direction == 0) {
    foam_.strain_direction = options_.strain_step > 0 ? 1 : -1;
  }
  newton_.forget();
  response_ = before_ = {};
  predicted_ = false;
  since_before_ = 0;
}

void TorusDeformation::undo(Foam foam) {
  const std::uint64_t topology = foam_.topology + 1; // no one shall take it for one seen before
  foam_ = std::move(foam);
  foam_.topology = topology;
  predicted_ = false;
  since_before_ = 0;
}

bool TorusDeformation::advance(const AbortCheck& aborted) {
  foam_.operations.clear();
  Foam before = foam_;
  iterations_ = 0;
  bool covered = false;
  try {
    covered = cover(frame_time(), aborted);
  } catch (...) {
    undo(std::move(before));
    newton_.forget();
    throw;
  }
  if (!covered) {
    const double strain = foam_.strain;
    undo(std::move(before));
    newton_.forget();
    End& end = foam_.ended.emplace();
    end.cause = End::Cause::NotStrained;
    end.bubbles = foam_.bubble_count();
    end.strain = strain;
    return false;
  }
  make_compact(foam_);
  foam_.time = before.time + frame_time();
  foam_.report.iterations = iterations_;
  foam_.ended.reset();
  return true;
}

/// To the end of a way of strain, there and back between ± the amplitude.
bool TorusDeformation::cover(double way, const AbortCheck& aborted) {
  while (way > kTurn * frame_time()) {
    turn_at_amplitude();
    const double room = options_.amplitude > 0
                            ? options_.amplitude - foam_.strain_direction * foam_.strain
                            : kInfinity;
    const double part = std::min(way, room);
    const double end = foam_.strain + foam_.strain_direction * part;
    if (!strain_by(part, aborted)) {
      return false;
    }
    foam_.strain = end;
    way -= part;
  }
  return true;
}

void TorusDeformation::turn_at_amplitude() {
  const double amplitude = options_.amplitude;
  if (amplitude > 0 && foam_.strain_direction * foam_.strain >= amplitude * (1 - kTurn)) {
    foam_.strain_direction = -foam_.strain_direction;
  }
}

/// From one T1 to the next. \param way > 0, in the direction that the strain goes
bool TorusDeformation::strain_by(double way, const AbortCheck& aborted) {
  if (!foam_.report.converged && !relax_swapping(aborted)) {
    return false;
  }
  while (true) {
    if (aborted && aborted()) {
      throw Aborted();
    }
    predict();
    const double wait = next_closing();
    if (wait <= (way > 0 ? kAtHand : kAtHandAtEnd)) {
      const double rest = std::min(swap_closing(wait), way);
      follow(rest);
      way -= rest;
      if (!relax_swapping(aborted)) {
        return false;
      }
      continue;
    }
    if (way == 0) {
      return true;
    }
    double part = std::min({way, kLongestStep, near_closing(wait)});
    if (!arrive(part, aborted) && !jump(part, aborted)) {
      return false;
    }
    way -= part;
  }
}

/// The response of the equilibrium at hand.
void TorusDeformation::predict() {
  if (predicted_) {
    return;
  }
  std::swap(before_, response_);
  const Rates expected = before_.topology == foam_.topology ? before_.view() : Rates{};
  const Field<Bubble, double> no_growth(foam_.target_area.size(), 0.0);
  response_.topology = foam_.topology;
  response_.junctions.assign(foam_.position.size(), {});
  response_.angles.assign(foam_.film_angle.size(), 0);
  response_.pressures.assign(foam_.pressure.size(), 0);
  if (const newton::StepView* found = newton_.response(foam_, no_growth, expected, kDrift, flow_)) {
    const Region& region = newton_.region();
    for (const Junction j : region.junctions) {
      response_.junctions[j] = found->junction[j];
    }
    for (const Film f : region.films) {
      response_.angles[f] = found->angle[f];
    }
    for (const Bubble b : region.bubbles) {
      response_.pressures[b] = found->pressure[b];
    }
  }
  if (before_.topology != foam_.topology) {
    since_before_ = 0;
  }
  predicted_ = true;
}

/// Of a film's length, cm per strain in the direction that the strain goes.
double TorusDeformation::growth(Film film) const {
  const Half h = film.half();
  const Vec2 chord = foam_.chord(h);
  const Vec2 change =
      flow_ * chord + response_.junctions[foam_.end(h)] - response_.junctions[foam_.start(h)];
  return foam_.strain_direction *
         arc_growth(chord, change, foam_.half_angle(h), response_.angles[film]);
}

/// The strain ahead at which the film's length vanishes.
double TorusDeformation::strain_to_close(Film film) const {
  const double growing = growth(film);
  return growing < 0 && may_vanish(foam_, film) ? foam_.length(film.half()) / -growing : kInfinity;
}

double TorusDeformation::next_closing() const {
  double first = kInfinity;
  for (const Film f : foam_.film_slots()) {
    if (foam_.has_film(f)) {
      first = std::min(first, strain_to_close(f));
    }
  }
  return first;
}

/// How far to go towards a closing: not beyond it, as far as it is known.
double TorusDeformation::near_closing(double wait) const {
  return wait - std::max(std::min(kCurving * wait, 0.5) * wait, 0.5 * kAtHand);
}

/// Swaps the films that vanish in the strain `wait` ahead, and with it. \returns that strain
double TorusDeformation::swap_closing(double wait) {
  std::vector<std::pair<double, Film>> closing;
  for (const Film f : foam_.film_slots()) {
    if (foam_.has_film(f)) {
      if (const double own = strain_to_close(f); own <= wait + kTogether) {
        closing.emplace_back(own, f);
      }
    }
  }
  std::ranges::sort(closing);
  std::vector<Junction> used;
  for (const auto& [own, film] : closing) {
    const Half h = film.half();
    const std::array ends{foam_.start(h), foam_.end(h)};
    if (std::ranges::find_first_of(used, ends) != used.end() || !may_vanish(foam_, film)) {
      continue;
    }
    used.insert(used.end(), ends.begin(), ends.end());
    perform_t1(foam_, film);
    TopologicalOperation& swap = foam_.operations.back();
    swap.time += own;
    swap.strain += foam_.strain_direction * own;
  }
  predicted_ = false;
  since_before_ = 0;
  return wait;
}

/// Brings the foam along its equilibria by a way of strain, or by a part of it: if there is no
/// equilibrium of this topology that Newton's method finds at once by half of it, and so on.
/// \param way becomes what was gone, or the least that was tried. \returns whether there is one
bool TorusDeformation::arrive(double& way, const AbortCheck& aborted) {
  const Foam here = foam_;
  const Response response = response_;
  while (true) {
    follow(way);
    if (relax(0, kShortRelaxation, aborted)) {
      return true;
    }
    undo(here);
    response_ = response;
    response_.topology = foam_.topology;
    if (way <= kFinest) {
      return false;
    }
    way = std::max(0.5 * way, kFinest);
  }
}

/// Goes by a way of strain from where the equilibria of this topology end to another one.
bool TorusDeformation::jump(double way, const AbortCheck& aborted) {
  follow(way);
  return relax_swapping(aborted);
}

/// Moves everything by a way of strain s along the response v to second order, from
/// dx/ds = L·x + v: junctions by F and v·s + ½(L·v + dv/ds)·s².
void TorusDeformation::follow(double way) {
  const double s = foam_.strain_direction * way;
  foam_.strain += s;
  foam_.time += way;
  strain(foam_, exponential(s, flow_));
  const bool moves = response_.topology == foam_.topology;
  const bool bends = moves && since_before_ != 0 && std::abs(s) < 1.5 * std::abs(since_before_);
  const double bend = bends ? 0.5 * s * s / since_before_ : 0;
  if (moves) {
    for (const Junction j : foam_.junction_slots()) {
      const Vec2 v = response_.junctions[j];
      foam_.position[j] += s * v + (0.5 * s * s) * (flow_ * v);
      foam_.position[j] += bends ? bend * (v - before_.junctions[j]) : Vec2{};
    }
    for (const Film f : foam_.film_slots()) {
      const double rate = response_.angles[f];
      foam_.film_angle[f] += s * rate + (bends ? bend * (rate - before_.angles[f]) : 0);
    }
    for (const Bubble b : foam_.bubble_slots()) {
      const double rate = response_.pressures[b];
      foam_.pressure[b] += s * rate + (bends ? bend * (rate - before_.pressures[b]) : 0);
    }
  }
  since_before_ = moves ? s : 0;
  predicted_ = false;
}

/// \param t1_length of films that are swapped on the way, of the mean spacing
bool TorusDeformation::relax(double t1_length, int most_iterations, const AbortCheck& aborted) {
  const double length = t1_length * foam_.mean_spacing();
  const EquilibriumReport report =
      newton_.equilibrate_to(foam_, reachable_tolerance(), length, most_iterations, aborted);
  iterations_ += report.iterations;
  predicted_ = false;
  return report.converged;
}

/// With the T1s that come on the way, be it an avalanche: it goes on for as long as films are
/// swapped within the iterations that a foam may take.
bool TorusDeformation::relax_swapping(const AbortCheck& aborted) {
  const Foam start = foam_;
  const int most = options_.equilibrator.maximum_iterations;
  for (int round = 0; round < kRounds; ++round) {
    const std::size_t performed = foam_.operations.size();
    if (relax(kSwapLength, most, aborted)) {
      return true;
    }
    if (foam_.operations.size() == performed) {
      break;
    }
  }
  undo(start);
  newton_.forget();
  const EquilibriumReport report =
      newton_.equilibrate(foam_, kSwapLengthFar * foam_.mean_spacing(), aborted);
  iterations_ += report.iterations;
  return report.converged;
}

/// The tolerance, or what rounding of coordinates leaves of the direction of the shortest film.
double TorusDeformation::reachable_tolerance() const {
  double shortest = kInfinity;
  for (const Film f : foam_.film_slots()) {
    if (foam_.has_film(f)) {
      shortest = std::min(shortest, norm(foam_.chord(f.half())));
    }
  }
  double largest = 0;
  for (const Vec2 place : foam_.position) {
    largest = std::max({largest, std::abs(place.x), std::abs(place.y)});
  }
  const double rounding = 8 * std::numeric_limits<double>::epsilon() * largest / shortest;
  return std::max(options_.equilibrator.tolerance, rounding);
}

} // namespace foam
