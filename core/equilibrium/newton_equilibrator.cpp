// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/newton_equilibrator.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "equilibrium/far_start.h"
#include "physics/equilibrium_measures.h"
#include "topology/wall_contact.h"

namespace foam {
namespace {

constexpr int kPatchRings = 2;
constexpr double kPatchTolerance = 1e-3; // the rim's residual is of this order or larger
constexpr double kUnrelaxed = 1e-4;      // residual of a place that is not in equilibrium,
constexpr double kSmallPatch = 0.3;      // and a part of the foam that patches around such may be

} // namespace

/// A foam's region (equilibrium/newton.h).
class NewtonEquilibrator::Problem {
public:
  Problem(Foam& foam, newton::FactorisingSolver& solver, newton::SwapsInTurn& swaps,
          double t1_length, MakeRegion make_region)
      : foam_(foam), mesh_(view_of(foam)), solver_(solver), swaps_(swaps), t1_length_(t1_length),
        make_region_(std::move(make_region)) {}

  const Foam& foam() const { return foam_; }
  const FoamView& mesh() const { return mesh_; }
  Domain domain() const { return domain_of(solver_.region()); }
  bool renew() {
    const bool changed = !solver_.fits(foam_);
    if (changed) {
      solver_.set_up(foam_, make_region_(foam_, touched_));
    }
    return changed;
  }
  void mark_closing(const newton::StepView& step) {
    swaps_.mark(foam_, domain(), step, t1_length_);
  }
  std::size_t swap_closing() {
    touched_ = swaps_.perform(foam_);
    return touched_.size();
  }

private:
  Foam& foam_;
  FoamView mesh_;
  newton::FactorisingSolver& solver_;
  newton::SwapsInTurn& swaps_;
  double t1_length_; ///< cm
  MakeRegion make_region_;
  std::vector<Bubble> touched_;
};

NewtonEquilibrator::NewtonEquilibrator(const EquilibratorOptions& options)
    : options_(options), newton_(host_) {}

void NewtonEquilibrator::forget() {
  whole_.reset();
  patch_.reset();
}

EquilibriumReport NewtonEquilibrator::equilibrate(Foam& foam, double t1_length,
                                                  const AbortCheck& aborted) {
  try {
    do {
      equilibrate_from_afar(
          foam, [&](Foam& start) { return is_far(start); }, t1_length, options_.maximum_iterations,
          aborted,
          [&](Foam& start, int most_iterations) {
            relax_to(start, options_.tolerance, t1_length, most_iterations, aborted);
          });
    } while (foam.report.converged && t1_length > 0 && touch_walls(foam));
    return foam.report;
  } catch (...) {
    foam.report = measured_report(foam);
    throw;
  }
}

bool NewtonEquilibrator::is_far(Foam& foam) {
  whole_.set_up(foam, whole_foam(foam));
  Problem problem(foam, whole_, swaps_, 0, {});
  return newton_.is_far(problem, whole_);
}

EquilibriumReport NewtonEquilibrator::equilibrate_to(Foam& foam, double tolerance, double t1_length,
                                                     int most_iterations,
                                                     const AbortCheck& aborted) {
  do {
    relax_to(foam, tolerance, t1_length, most_iterations, aborted);
  } while (foam.report.converged && t1_length > 0 && touch_walls(foam));
  return foam.report;
}

void NewtonEquilibrator::relax_to(Foam& foam, double tolerance, double t1_length,
                                  int most_iterations, const AbortCheck& aborted) {
  iterations_ = 0;
  swaps_.begin(foam);
  relax_unrelaxed_regions(foam, t1_length, most_iterations, aborted);
  Problem problem(foam, whole_, swaps_, t1_length,
                  [](const Foam& f, std::span<const Bubble>) { return whole_foam(f); });
  const newton::Outcome outcome =
      newton_.relax(problem, whole_, tolerance, iterations_, most_iterations, aborted);
  foam.report = {.converged = outcome.converged,
                 .iterations = iterations_,
                 .max_angle_error = max_angle_error(foam),
                 .max_area_error = outcome.residual.area,
                 .residual = outcome.residual.largest()};
}

/// Where a foam that is in equilibrium but in a few places is not, patches around those are relaxed
/// first: an iteration there costs next to nothing.
void NewtonEquilibrator::relax_unrelaxed_regions(Foam& foam, double t1_length, int most_iterations,
                                                 const AbortCheck& aborted) {
  if (!whole_.factorised()) {
    return;
  }
  if (!whole_.fits(foam)) {
    whole_.set_up(foam, whole_foam(foam));
  }
  newton_.evaluate(Problem(foam, whole_, swaps_, t1_length, {}));
  const std::vector<Bubble> rough = unrelaxed_bubbles(foam);
  const auto largest = static_cast<std::size_t>(kSmallPatch * foam.bubble_count());
  if (!rough.empty() && rough.size() < largest &&
      patch(foam, rough, kPatchRings).bubbles.size() < largest) {
    relax_patch_to(
        kUnrelaxed, foam, rough, t1_length, most_iterations, [](const Region&) {}, aborted);
  }
}

/// The bubbles at which dimensionless residuals of the state evaluated last exceed a limit.
std::vector<Bubble> NewtonEquilibrator::unrelaxed_bubbles(const Foam& foam) const {
  const newton::Evaluation<Host>& state = newton_.state();
  const Region& region = whole_.region();
  std::vector<Bubble> rough;
  for (const Film f : region.films) {
    const Half h = f.half();
    if (std::abs(state.films()[f].forces.angle) >
        kUnrelaxed * foam.tension(f) * norm(foam.chord(h))) {
      rough.insert(rough.end(), {foam.left(h), foam.right(h)});
    }
  }
  for (const Junction j : region.junctions) {
    if (norm(state.forces()[j]) > kUnrelaxed * foam.reference_tension()) {
      for (const Half h : foam.junction_half[j]) {
        rough.push_back(foam.left(h));
      }
    }
  }
  for (const Bubble b : region.bubbles) {
    const double target = foam.target_area[b];
    if (std::abs(state.areas()[b] - target) > kUnrelaxed * target) {
      rough.push_back(b);
    }
  }
  std::ranges::sort(rough);
  const auto repeated = std::ranges::unique(rough);
  rough.erase(repeated.begin(), repeated.end());
  return rough;
}

bool NewtonEquilibrator::relax_patch(Foam& foam, std::span<const Bubble> bubbles, double t1_length,
                                     const std::function<void(const Region&)>& prepare,
                                     const AbortCheck& aborted) {
  iterations_ = 0;
  swaps_.begin(foam);
  return relax_patch_to(kPatchTolerance, foam, bubbles, t1_length, options_.maximum_iterations,
                        prepare, aborted);
}

bool NewtonEquilibrator::relax_patch_to(double tolerance, Foam& foam,
                                        std::span<const Bubble> bubbles, double t1_length,
                                        int most_iterations,
                                        const std::function<void(const Region&)>& prepare,
                                        const AbortCheck& aborted) {
  patch_.reset();
  std::vector<Bubble> centre(bubbles.begin(), bubbles.end());
  Problem problem(foam, patch_, swaps_, t1_length,
                  [&](const Foam& f, std::span<const Bubble> touched) {
                    centre.insert(centre.end(), touched.begin(), touched.end());
                    Region region = patch(f, centre, kPatchRings);
                    prepare(region);
                    return region;
                  });
  return newton_
      .relax(problem, patch_, std::max(tolerance, options_.tolerance), iterations_, most_iterations,
             aborted)
      .converged;
}

const newton::StepView* NewtonEquilibrator::response(const Foam& foam,
                                                     const Field<Bubble, double>& area_rate,
                                                     const Rates& expected, double drift,
                                                     const Tensor& flow) {
  if (!whole_.fits(foam)) {
    whole_.set_up(foam, whole_foam(foam));
  }
  return whole_.response(foam, area_rate, expected, drift, flow);
}

const newton::StepView* NewtonEquilibrator::patch_response(const Foam& foam,
                                                           const Field<Bubble, double>& area_rate,
                                                           const Rates& around, double drift) {
  return patch_.response(foam, area_rate, around, drift);
}

} // namespace foam
