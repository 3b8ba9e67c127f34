// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/newton_equilibrator.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <unordered_set>

#include "equilibrium/compressible_relaxation.h"
#include "equilibrium/globalisation.h"
#include "physics/swap_rule.h"
#include "topology/operations.h"

namespace foam {
namespace {

constexpr double kFar = 0.5;          // residual that Newton's method may not be up to
constexpr double kHemmedIn = 0.25;    // part of its step that can be taken where it is not
constexpr double kContraction = 0.25; // what a reused factorisation must achieve
constexpr double kExcess = 0.3;       // part of the tolerance that a step's equations may miss
constexpr double kReuseBelow = 0.1;   // residual from which on reuse is tried
constexpr double kChordBelow = 1e-4;  // residual from which on a system serves for several steps
constexpr double kStationaryBelow = 1e-5; // residual from which on any equilibrium will do
constexpr double kFreeToTurnBelow =
    0.1; // residual from which on a free foam's rotation is told apart
constexpr Index kAnyEquilibrium = std::numeric_limits<Index>::max();
constexpr double kSmallestStep = 1e-4; // of a line search
constexpr int kPatchRings = 2;
constexpr double kPatchTolerance = 1e-3; // the rim's residual is of this order or larger
constexpr double kRough = 1e-4;          // residual of a place that is not in equilibrium,
constexpr double kSmallPatch = 0.3;      // and a part of the foam that patches around such may be
constexpr int kPatience = 24;            // iterations without progress close to the solution
constexpr int kLargestSwapCount = 4;     // of one film in one call

/// Negative pivots beyond the constraints' that need no shift. One is a free foam's rotation: it
/// costs nothing in equilibrium, near it a little more or less, and is taken out of every step.
Index surplus(const Foam& foam, const Residual& residual) {
  if (residual.largest() < kStationaryBelow) {
    return kAnyEquilibrium;
  }
  return foam.boundary == Boundary::Free && residual.largest() < kFreeToTurnBelow ? 1 : 0;
}

} // namespace

NewtonEquilibrator::NewtonEquilibrator(const EquilibratorOptions& options) : options_(options) {}

void NewtonEquilibrator::forget() {
  whole_.reset();
  patch_.reset();
}

EquilibriumReport NewtonEquilibrator::equilibrate(Foam& foam, double t1_length,
                                                  const AbortCheck& aborted) {
  foam.report = {};
  if (hemmed_in(foam)) {
    relax_compressible(foam, t1_length, aborted);
  }
  return equilibrate_to(foam, options_.tolerance, t1_length, aborted);
}

/// Whether the foam is so far from equilibrium that some film is in the way of Newton's first step.
bool NewtonEquilibrator::hemmed_in(const Foam& foam) {
  whole_.set_up(foam, whole_foam(foam));
  return whole_.evaluate(foam).largest() > kFar && whole_.factorise(foam, 0) &&
         longest_step(foam, whole_, whole_.newton_step(foam)) < kHemmedIn;
}

EquilibriumReport NewtonEquilibrator::equilibrate_to(Foam& foam, double tolerance, double t1_length,
                                                     const AbortCheck& aborted) {
  iterations_ = 0;
  swaps_.clear();
  relax_rough_spots(foam, t1_length, aborted);
  const auto outcome = relax(
      foam, whole_, [](const Foam& f, std::span<const Index>) { return whole_foam(f); }, tolerance,
      t1_length, aborted);
  return report(foam, outcome);
}

/// Where a foam that is in equilibrium but in a few places is not, patches around those are relaxed
/// first: an iteration there costs next to nothing.
void NewtonEquilibrator::relax_rough_spots(Foam& foam, double t1_length,
                                           const AbortCheck& aborted) {
  if (!whole_.factorised()) {
    return;
  }
  if (!whole_.fits(foam)) {
    whole_.set_up(foam, whole_foam(foam));
  }
  whole_.evaluate(foam);
  const std::vector<Index> rough = whole_.rough_bubbles(foam, kRough);
  const auto most = static_cast<std::size_t>(kSmallPatch * foam.bubble_count());
  if (!rough.empty() && rough.size() < most &&
      patch(foam, rough, kPatchRings).bubbles.size() < most) {
    relax_patch_to(
        kRough, foam, rough, t1_length, [](const Region&) {}, aborted);
  }
}

bool NewtonEquilibrator::relax_patch(Foam& foam, std::span<const Index> bubbles, double t1_length,
                                     const std::function<void(const Region&)>& prepare,
                                     const AbortCheck& aborted) {
  iterations_ = 0;
  swaps_.clear();
  return relax_patch_to(kPatchTolerance, foam, bubbles, t1_length, prepare, aborted);
}

bool NewtonEquilibrator::relax_patch_to(double tolerance, Foam& foam,
                                        std::span<const Index> bubbles, double t1_length,
                                        const std::function<void(const Region&)>& prepare,
                                        const AbortCheck& aborted) {
  patch_.reset();
  std::vector<Index> centre(bubbles.begin(), bubbles.end());
  return relax(
             foam, patch_,
             [&](const Foam& f, std::span<const Index> touched) {
               centre.insert(centre.end(), touched.begin(), touched.end());
               Region region = patch(f, centre, kPatchRings);
               prepare(region);
               return region;
             },
             std::max(tolerance, options_.tolerance), t1_length, aborted)
      .converged;
}

EquilibriumReport NewtonEquilibrator::report(Foam& foam, const Outcome& outcome) const {
  foam.report = {.converged = outcome.converged,
                 .iterations = iterations_,
                 .max_angle_error = max_angle_error(foam),
                 .max_area_error = outcome.residual.area,
                 .residual = outcome.residual.largest()};
  return foam.report;
}

const Step* NewtonEquilibrator::response(const Foam& foam, const std::vector<double>& area_rate,
                                         const Rates& expected, double drift) {
  if (!whole_.fits(foam)) {
    whole_.set_up(foam, whole_foam(foam));
  }
  return response(whole_, foam, area_rate, expected, drift);
}

const Step* NewtonEquilibrator::patch_response(const Foam& foam,
                                               const std::vector<double>& area_rate,
                                               const Rates& around, double drift) {
  return response(patch_, foam, area_rate, around, drift);
}

const Step* NewtonEquilibrator::response(LagrangianSystem& system, const Foam& foam,
                                         const std::vector<double>& area_rate,
                                         const Rates& expected, double drift) const {
  const Step* step = system.response(foam, area_rate, expected, drift);
  if (step == nullptr && system.factorise(foam, kAnyEquilibrium)) {
    step = system.response(foam, area_rate, expected, LagrangianSystem::kAnyDrift);
  }
  return step;
}

template <class MakeRegion>
NewtonEquilibrator::Outcome
NewtonEquilibrator::relax(Foam& foam, LagrangianSystem& system, const MakeRegion& make_region,
                          double tolerance, double t1_length, const AbortCheck& aborted) {
  std::vector<Index> touched;
  double best = std::numeric_limits<double>::infinity();
  int since_best = 0;
  Residual residual;
  bool evaluated = false;
  bool adapted = false;
  while (true) {
    if (aborted && aborted()) {
      throw Aborted();
    }
    if (!system.fits(foam)) {
      system.set_up(foam, make_region(foam, touched));
      evaluated = false;
      adapted = false;
    }
    if (!evaluated) {
      residual = system.evaluate(foam);
      evaluated = true;
    }
    if (residual.largest() < tolerance) {
      return {true, residual};
    }
    since_best = residual.largest() < 0.5 * best ? 0 : since_best + 1;
    best = std::min(best, residual.largest());
    const bool stalled = best < 1e-6 && since_best > kPatience;
    if (iterations_ >= options_.maximum_iterations || stalled ||
        !std::isfinite(residual.largest())) {
      return {false, residual};
    }
    ++iterations_;
    if (reuse_factorisation(foam, system, tolerance, residual, adapted)) {
      continue;
    }
    adapted = system.factorise(foam, surplus(foam, residual));
    if (!adapted) {
      return {false, residual};
    }
    const Step& step = system.newton_step(foam);
    const std::vector<Index> closing = closing_films(foam, system, step, t1_length);
    const bool moved = search_line(foam, system, step, residual);
    touched = swap_films(foam, closing);
    if (!moved && touched.empty()) {
      return {false, residual};
    }
  }
}

/// One step with the factorisation at hand, undone unless it contracts. \param adapted whether the
/// system is about that of the present state.
bool NewtonEquilibrator::reuse_factorisation(Foam& foam, LagrangianSystem& system, double tolerance,
                                             Residual& residual, bool& adapted) {
  if (!system.factorised() || system.shifted() || residual.largest() > kReuseBelow) {
    return false;
  }
  if (!adapted || residual.largest() > kChordBelow) {
    adapted = system.adapt(foam);
    if (!adapted) {
      return false;
    }
  }
  const Step* step = system.newton_step(foam, kExcess * tolerance);
  if (step == nullptr || longest_step(foam, system, *step) < 1) {
    return false;
  }
  const Snapshot before(foam, system.region());
  before.advance(foam, *step, 1);
  const Residual after = system.evaluate(foam);
  if (after.largest() < kContraction * residual.largest() || after.largest() < tolerance) {
    residual = after;
    return true;
  }
  before.restore(foam);
  residual = system.evaluate(foam);
  return false;
}

/// Takes the Newton step, or as much of it everywhere as can be taken there, or backtracks along
/// it, until the residual is halved or the merit function falls.
bool NewtonEquilibrator::search_line(Foam& foam, LagrangianSystem& system, const Step& step,
                                     Residual& residual) {
  const Merit merit(foam, system, step);
  const double before_merit = merit(foam);
  const Snapshot before(foam, system.region());
  const auto improves = [&](const Step& direction, double fraction) {
    before.advance(foam, direction, fraction);
    const Residual after = system.evaluate(foam);
    if (after.largest() < 0.5 * residual.largest() || merit(foam) < before_merit) {
      residual = after;
      return true;
    }
    return false;
  };
  const double longest = longest_step(foam, system, step);
  if (longest < 1 && system.region().whole && improves(limited_step(foam, system, step), 1)) {
    return true;
  }
  for (double fraction = longest; fraction > kSmallestStep * longest; fraction *= 0.5) {
    if (improves(step, fraction)) {
      return true;
    }
  }
  before.restore(foam);
  return false;
}

/// The films that the step shortens further although they are short, the shortest first. Each swap
/// of a film in one call asks for it to be four times shorter, so that no film is swapped back and
/// forth.
std::vector<Index> NewtonEquilibrator::closing_films(const Foam& foam,
                                                     const LagrangianSystem& system,
                                                     const Step& step, double t1_length) const {
  struct Candidate {
    double length;
    Index film;
  };
  std::vector<Candidate> candidates;
  for (const Index f : system.region().films) {
    const double length = foam.length(2 * f);
    if (length > t1_length || dot(foam.chord(2 * f), system.chord_change(foam, f, step)) >= 0) {
      continue;
    }
    const auto found = swaps_.find(f);
    const int swaps = found == swaps_.end() ? 0 : found->second;
    if (swaps < kLargestSwapCount && length <= t1_length * std::pow(0.25, swaps)) {
      candidates.push_back({length, f});
    }
  }
  std::ranges::sort(candidates, [](const Candidate& a, const Candidate& b) {
    return a.length < b.length || (a.length == b.length && a.film < b.film);
  });
  std::vector<Index> films;
  std::ranges::transform(candidates, std::back_inserter(films), &Candidate::film);
  return films;
}

/// Swaps those of the films that may be swapped and are pulled shut, no two at one junction.
/// Three-sided bubbles keep their sides: they vanish by T2. \returns the bubbles around them.
std::vector<Index> NewtonEquilibrator::swap_films(Foam& foam, std::span<const Index> films) {
  std::vector<Index> touched;
  std::unordered_set<Index> used;
  for (const Index f : films) {
    const std::array ends{foam.start(2 * f), foam.end(2 * f)};
    const bool free_ends = !used.contains(ends[0]) && !used.contains(ends[1]);
    if (free_ends && spares_sides(foam, f) && can_perform_t1(foam, f) && pulled_shut(foam, f)) {
      perform_t1(foam, f);
      ++swaps_[f];
      used.insert(ends.begin(), ends.end());
      for (const Index j : ends) {
        for (const Index h : foam.junction_half[Foam::size(j)]) {
          touched.push_back(foam.left(h));
        }
      }
    }
  }
  return touched;
}

} // namespace foam
