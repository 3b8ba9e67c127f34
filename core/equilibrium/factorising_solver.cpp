// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/factorising_solver.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <utility>

#include "algebra/generalised_conjugate_residuals.h"
#include "equilibrium/zero_modes.h"

namespace foam::newton {
namespace {

constexpr double kReuseBelow = 0.1;  // residual from which on reuse is tried
constexpr double kChordBelow = 1e-4; // residual from which on a matrix serves for several steps
constexpr double kStationaryBelow = 1e-5; // residual from which on any equilibrium will do
constexpr double kFreeToTurnBelow = 0.1;  // residual from which on a rotation is told apart
constexpr Index kAnyEquilibrium = std::numeric_limits<Index>::max();
constexpr double kExcess = 0.3;   // part of the tolerance that a step's equations may miss
constexpr int kDirections = 8;    // after which a new factorisation is cheaper
constexpr double kForcing = 1e-2; // of the load, that an inexact step may leave
constexpr double kFirstShift = 1e-3;
constexpr double kLargestShift = 1e4;

/// Negative pivots beyond the constraints' that need no shift: so close to a stationary point, be
/// it a saddle, that Newton's own step leads there, all. One is the rotation of a foam that turns:
/// it costs nothing in equilibrium, near it a little more or less, and is taken out of every step.
Index surplus(const Foam& foam, const Residual& residual) {
  if (residual.largest() < kStationaryBelow) {
    return kAnyEquilibrium;
  }
  return foam.surroundings.rotates() && residual.largest() < kFreeToTurnBelow ? 1 : 0;
}

} // namespace

void FactorisingSolver::reset() {
  topology_.reset();
  factorised_ = false;
  shift_ = 0;
}

void FactorisingSolver::set_up(const Foam& foam, Region region) {
  const bool adapts = factorised_ && shift_ == 0 && region_.whole && region.whole;
  step_.fit(view_of(foam));
  for (const Junction j : region_.junctions) { // which may be held now
    if (j.index() < foam.junction_slots().size()) {
      step_.view().junction[j] = {};
    }
  }
  region_ = std::move(region);
  topology_ = foam.topology;
  adapted_ = false;
  std::vector<char> keep_angle(region_.films.size());
  std::ranges::transform(region_.films, keep_angle.begin(), [&](Film f) {
    return adapts ? factorisation_.keeps_angle(f) : NewtonMatrix::angle_is_delicate(foam, f);
  });
  matrix_.set_up(foam, region_, std::move(keep_angle));
  assembled_ = false;
  factorised_ = adapts;
}

void FactorisingSolver::begin(bool /*far*/) {
  assembled_ = false;
  adapted_ = false;
}

const StepView* FactorisingSolver::reuse(const Foam& foam, const Domain& /*domain*/,
                                         const Evaluation<Host>& state, const Residual& residual,
                                         double tolerance) {
  assembled_ = false;
  if (!factorised_ || shift_ > 0 || residual.largest() > kReuseBelow) {
    return nullptr;
  }
  if (!adapted_ || residual.largest() > kChordBelow) {
    adapted_ = adapt(foam);
    if (!adapted_) {
      return nullptr;
    }
  }
  // An inexact step: it leaves a part of the load (R. S. Dembo, S. C. Eisenstat, T. Steihaug, SIAM
  // J. Numer. Anal. 19 (1982) 400), or what is below a limit. A load below the limit is to be met
  // too: areas are measured here by the mean, not by their own.
  std::vector<double> rest = load(foam, state);
  std::vector<double> change(rest.size(), 0.0);
  const double most = largest_weighted(rest, weights(foam));
  const double limit = kExcess * tolerance;
  const double enough = limit < most ? std::max(limit, kForcing * most) : kForcing * most;
  if (!solve(foam, change, rest, enough)) {
    return nullptr;
  }
  extract(foam, change, angle_gradient(state), {}, step_);
  return &view_;
}

const StepView* FactorisingSolver::find(const Foam& foam, const Domain& /*domain*/,
                                        const Evaluation<Host>& state, const Residual& residual) {
  adapted_ = factorise(foam, surplus(foam, residual));
  if (!adapted_) {
    return nullptr;
  }
  std::vector<double> change = load(foam, state);
  factorisation_.solve(change);
  extract(foam, change, angle_gradient(state), {}, step_);
  return &view_;
}

/// \returns false if some angles are to be kept that were not: the unknowns are others then.
bool FactorisingSolver::assemble(const Foam& foam, double shift) {
  if (assembled_ && shift == 0) {
    return true;
  }
  const bool same_unknowns = matrix_.assemble(foam, region_, shift);
  assembled_ = same_unknowns && shift == 0;
  return same_unknowns;
}

/// \param surplus so many negative pivots more than there are constraints are taken as well.
/// \returns false if no shift does it.
bool FactorisingSolver::factorise(const Foam& foam, Index surplus) {
  factorised_ = false;
  const auto constraints = static_cast<Index>(region_.bubbles.size());
  double shift = 0;
  while (shift <= kLargestShift) {
    if (!assemble(foam, shift)) {
      continue;
    }
    const Index negative = factorisation_.factorise(foam, region_, matrix_);
    if (negative >= constraints && negative - constraints <= surplus) {
      factorised_ = true;
      shift_ = shift;
      return true;
    }
    shift = shift == 0 ? std::max(kFirstShift, shift_ / 8) : 8 * shift;
  }
  return false;
}

/// Makes the last factorisation of a whole foam serve for where it has moved since. \returns false
/// if that is too far.
bool FactorisingSolver::adapt(const Foam& foam) {
  factorised_ = factorised_ && assemble(foam, 0) &&
                (!region_.whole || (shift_ == 0 && factorisation_.adapt(foam, region_, matrix_)));
  return factorised_;
}

/// ∂φ/∂α by place in region_.films.
std::vector<double> FactorisingSolver::angle_gradient(const Evaluation<Host>& state) const {
  std::vector<double> gradient(region_.films.size());
  std::ranges::transform(region_.films, gradient.begin(),
                         [&](Film f) { return state.films()[f].forces.angle; });
  return gradient;
}

/// The right-hand side of Newton's equations: minus the gradient by the unknowns, condensed.
std::vector<double> FactorisingSolver::load(const Foam& foam, const Evaluation<Host>& state) const {
  const Unknowns& unknowns = matrix_.unknowns();
  std::vector<double> load(place_of(unknowns.count()));
  for (std::size_t i = 0; i < region_.junctions.size(); ++i) {
    const Vec2 force = state.forces()[region_.junctions[i]];
    load[2 * i] = -force.x;
    load[2 * i + 1] = -force.y;
  }
  for (std::size_t i = 0; i < region_.bubbles.size(); ++i) {
    load[place_of(unknowns.first_pressure()) + i] =
        bounded_excess(view_of(foam), state.areas(), region_.bubbles[i]);
  }
  matrix_.add_angles(angle_gradient(state), load);
  return load;
}

/// What makes residuals dimensionless, areas in units of the mean.
std::vector<double> FactorisingSolver::weights(const Foam& foam) const {
  const Unknowns& unknowns = matrix_.unknowns();
  const Units units{region_.spacing, foam.reference_tension()};
  std::vector<double> weight(place_of(unknowns.count()), 1 / units.energy());
  const auto first_pressure = weight.begin() + unknowns.first_pressure();
  std::fill(weight.begin(), first_pressure, 1 / units.tension);
  std::fill_n(first_pressure, region_.bubbles.size(), 1 / units.area());
  return weight;
}

/// Adds to a change what takes away the rest of the load that it leaves, down to a limit of
/// dimensionless residuals. \returns whether the limit is met.
bool FactorisingSolver::solve(const Foam& foam, std::span<double> change, std::vector<double>& rest,
                              double limit) {
  const ConstFoamView mesh = view_of(foam);
  return generalised_conjugate_residuals(
      change, rest, weights(foam), limit, kDirections,
      [&](std::span<const double> x, std::span<double> from) { matrix_.subtract_product(x, from); },
      [&](std::span<double> x) {
        factorisation_.solve(x);
        remove_rigid_motion(host_, mesh, domain_of(region_), x.data());
      });
}

const StepView* FactorisingSolver::response(const Foam& foam,
                                            const Field<Bubble, double>& area_rate,
                                            const Rates& expected, double drift,
                                            const Tensor& flow) {
  assembled_ = false;
  const StepView* step = adapt(foam) ? respond(foam, area_rate, expected, drift, flow) : nullptr;
  if (step == nullptr && factorise(foam, kAnyEquilibrium)) {
    step = respond(foam, area_rate, expected, kAnyDrift, flow);
  }
  return step;
}

const StepView* FactorisingSolver::respond(const Foam& foam, const Field<Bubble, double>& area_rate,
                                           const Rates& expected, double drift,
                                           const Tensor& flow) {
  const Unknowns& unknowns = matrix_.unknowns();
  std::vector<double> change(place_of(unknowns.count()), 0.0);
  std::vector<double> rest(change.size(), 0.0);
  for (std::size_t i = 0; i < region_.bubbles.size(); ++i) {
    rest[place_of(unknowns.first_pressure()) + i] = -area_rate[region_.bubbles[i]];
  }
  for (std::size_t i = 0; i < region_.films.size(); ++i) {
    const FilmMatrix& share = matrix_.shares()[i];
    const FilmLagrangian::Each<double> rates = expected.of_film(foam, region_.films[i]);
    subtract_product(share, rates, rest);
    for (std::size_t k = 0; k < rates.size(); ++k) {
      if (share.unknown[k] != kNone) {
        change[place_of(share.unknown[k])] = rates[k];
      }
    }
  }
  std::vector<double> angle_load(region_.films.size(), 0.0);
  if (flow != Tensor{}) {
    add_strain(foam, flow, rest, angle_load);
  }
  if (drift == kAnyDrift) {
    factorisation_.solve(rest);
    std::ranges::transform(change, rest, change.begin(), std::plus<>());
  } else if (!solve(foam, change, rest, drift)) {
    return nullptr;
  }
  response_.fit(view_of(foam));
  extract(foam, change, angle_load, expected, response_);
  return &view_;
}

/// What a flow L does to the gradient of the Lagrangian, −∂²L/∂u∂γ to the load and ∂²φ/∂α∂γ to that
/// of the half-angles. It changes a chord D by δ = L·D, as if the ends moved by ∓½δ, were it not
/// for the polygons of their bubbles: of −q·½(D_y, −D_x), a film's part in the gradient at either
/// end, that has but the half.
void FactorisingSolver::add_strain(const Foam& foam, const Tensor& flow, std::span<double> load,
                                   std::span<double> angle_load) const {
  constexpr std::size_t kAngle = FilmLagrangian::kAngle;
  for (std::size_t i = 0; i < region_.films.size(); ++i) {
    const Half h = region_.films[i].half();
    const Vec2 half = 0.5 * (flow * foam.chord(h));
    const FilmLagrangian::Each<double> change{-half.x, -half.y, half.x, half.y, 0, 0, 0};
    const FilmMatrix& share = matrix_.shares()[i];
    subtract_product(share, change, load);
    const Vec2 polygon = 0.5 * foam.pressure_difference(h) * Vec2{half.y, -half.x};
    for (std::size_t k = 0; k < 4; ++k) {
      if (share.unknown[k] != kNone) {
        load[place_of(share.unknown[k])] += k % 2 == 0 ? polygon.x : polygon.y;
      }
      if (share.unknown[kAngle] == kNone) {
        angle_load[i] += share.value[kAngle * (kAngle + 1) / 2 + k] * change[k];
      }
    }
  }
}

/// \param angle_gradient that the change is to bring to zero, by place in region_.films
/// \param held how what is held changes
void FactorisingSolver::extract(const Foam& foam, std::span<double> change,
                                std::span<const double> angle_gradient, const Rates& held,
                                Step<Host>& step) {
  const ConstFoamView mesh = view_of(foam);
  const Domain domain = domain_of(region_);
  remove_rigid_motion(host_, mesh, domain, change.data());
  view_ = step.view();
  for (std::size_t i = 0; i < region_.junctions.size(); ++i) {
    view_.junction[region_.junctions[i]] = {change[2 * i], change[2 * i + 1]};
  }
  const auto pressures = change.subspan(place_of(matrix_.unknowns().first_pressure()));
  for (std::size_t i = 0; i < region_.bubbles.size(); ++i) {
    view_.pressure[region_.bubbles[i]] = pressures[i];
  }
  if (region_.whole) {
    remove_common_pressure(host_, mesh, domain.bubbles, view_.pressure);
  }
  for (std::size_t i = 0; i < region_.films.size(); ++i) {
    view_.angle[region_.films[i]] =
        matrix_.angle_change(i, angle_gradient[i], change, held.of_film(foam, region_.films[i]));
  }
}

} // namespace foam::newton
