// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton's method for a whole foam, every step of it in parallel on a machine (parallel/host.h):
// the equations, the penalty function and the limits of NewtonEquilibrator; its systems solved by
// MINRES (minimal_residual.h) with a preconditioner that does not feel the foam's size
// (foam_preconditioner.h), or by a direct solver that it is given; its T1s by bidding
// (topology/bidding.h).
//
// No inertia is asked for that could tell whether a step leads to a minimum. Far from
// equilibrium, and where the penalty function does not fall along a step, films are stiffened
// (film_derivatives) until it does: they resist being stretched, as springs do. From where that
// does not help, relax_compressible() does, on the processor: ask hemmed_in().
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <utility>

#include "algebra/direct_solver.h"
#include "base/abort.h"
#include "equilibrium/closing_films.h"
#include "equilibrium/compressed_matrix.h"
#include "equilibrium/foam_preconditioner.h"
#include "equilibrium/gauges.h"
#include "equilibrium/minimal_residual.h"
#include "equilibrium/newton_residual.h"
#include "equilibrium/newton_step.h"
#include "equilibrium/options.h"
#include "equilibrium/parallel_measures.h"
#include "topology/bidding.h"

namespace foam::newton {
namespace detail {

struct TargetArea {
  FoamView mesh;

  FOAM_HOST_DEVICE Total operator()(Index bubble) const {
    return mesh.has_bubble(bubble) ? Total{{mesh.target_area[bubble], 0}, 1} : Total{};
  }
};

/// (a − b)²
struct SquaredDifference {
  const double* a = nullptr;
  const double* b = nullptr;

  FOAM_HOST_DEVICE double operator()(Index i) const { return (a[i] - b[i]) * (a[i] - b[i]); }
};

} // namespace detail

/// What an equilibration did.
struct NewtonResult {
  EquilibriumReport report;
  std::int64_t t1 = 0;      ///< films swapped
  int inner_iterations = 0; ///< of MINRES, all in all
};

/// Notes in a foam what has been done to its arrays.
inline void note(Foam& foam, const NewtonResult& result) {
  foam.t1_count += result.t1;
  foam.topology += static_cast<std::uint64_t>(result.t1);
  foam.report = result.report;
}

template <class Machine> class ParallelNewton {
public:
  /// \param direct solves the systems in place of MINRES, which takes over where that leaves more
  /// than 10⁻⁴ of the right-hand side; null for MINRES alone.
  ParallelNewton(Machine& machine, const EquilibratorOptions& options,
                 std::unique_ptr<DirectSolver> direct = nullptr)
      : machine_(machine), options_(options), bidding_(machine), solver_(machine),
        preconditioner_(machine), direct_(std::move(direct)), compressed_(machine) {}

  /// Brings a mesh to equilibrium, swapping films shorter than t1_length (cm) that are pulled shut.
  /// Where it throws Aborted the mesh is somewhere in between.
  NewtonResult equilibrate(const FoamView& mesh, double t1_length, const AbortCheck& aborted) {
    prepare(mesh);
    NewtonResult result;
    double residual = residual_of(mesh);
    double best = std::numeric_limits<double>::infinity();
    int since_best = 0;
    double stiffening = residual > kFar ? kFirstStiffening : 0;
    while (!(residual < options_.tolerance)) {
      if (aborted && aborted()) {
        throw Aborted();
      }
      since_best = residual < 0.5 * best ? 0 : since_best + 1;
      best = std::min(best, residual);
      if (result.report.iterations >= options_.maximum_iterations || !std::isfinite(residual) ||
          (best < kClose && since_best > kPatience)) {
        break;
      }
      ++result.report.iterations;
      result.inner_iterations += find_step(mesh, stiffening, residual);
      machine_.for_each(
          mesh.films, detail::MarkClosing{mesh, step(), t1_length, swaps_.data(), closing_.data()});
      const double taken = search_line(mesh, residual, stiffening);
      const std::int64_t swapped =
          bidding_.run(mesh, ClosingFilmBids{closing_.data(), swaps_.data()}).count;
      result.t1 += swapped;
      if (taken == 0 && swapped == 0) {
        if (stiffening >= kLargestStiffening) {
          break;
        }
        stiffening = std::max(kFirstStiffening, 8 * stiffening);
      } else {
        if (taken == 1) {
          stiffening = stiffening > kLeastStiffening ? stiffening / 8 : 0;
        }
        residual = residual_of(mesh);
      }
    }
    const EquilibriumMeasures measures = measure_equilibrium(machine_, mesh);
    result.report.converged = residual < options_.tolerance;
    result.report.max_angle_error = measures.angle_error;
    result.report.max_area_error = measures.area_error;
    result.report.residual = residual;
    return result;
  }

  /// Whether a mesh is so far from equilibrium that some film is in the way of Newton's first step:
  /// relax_compressible() then brings it nearer.
  bool hemmed_in(const FoamView& mesh) {
    prepare(mesh);
    const double residual = residual_of(mesh);
    if (!(residual > kFar)) {
      return false;
    }
    find_step(mesh, 0, residual);
    return longest_step(mesh) < kHemmedIn;
  }

private:
  template <class T> using Array = typename Machine::template Array<T>;

  static constexpr double kFar = 0.5;       // residual from which on films are stiffened at once
  static constexpr double kHemmedIn = 0.25; // part of its step that can be taken where it is not
  static constexpr double kFirstStiffening = 1;
  static constexpr double kLeastStiffening = 0.01;
  static constexpr double kLargestStiffening = 1000;
  static constexpr double kClose = 1e-6;
  static constexpr int kPatience = 24;          // iterations without progress when close
  static constexpr double kSmallestStep = 1e-4; // of a line search
  static constexpr double kRoughest = 1e-2;     // to which linear systems are solved, …
  static constexpr double kFinest = 1e-4;       // … in between as the residual is
  static constexpr int kInnerIterations = 500;

  double longest_step(const FoamView& mesh) {
    return machine_.reduce(mesh.films, 1.0, detail::LongestStep{mesh, step()}, parallel::Smaller{});
  }

  /// Makes room for a mesh, and takes its measure.
  void prepare(const FoamView& mesh) {
    const auto junctions = FoamView::size(mesh.junctions);
    const auto films = FoamView::size(mesh.films);
    const auto bubbles = FoamView::size(mesh.bubbles);
    const auto unknowns = static_cast<std::size_t>(size_of(mesh));
    for (auto* array : {&position_, &junction_step_}) {
      array->resize(junctions);
    }
    for (auto* array : {&angle_, &angle_step_}) {
      array->resize(films);
    }
    for (auto* array : {&pressure_, &pressure_step_}) {
      array->resize(bubbles);
    }
    for (auto* array : {&right_, &solution_}) {
      array->resize(unknowns);
    }
    for (auto* array : {&swaps_, &closing_}) {
      array->resize(films);
    }
    stiffness_.resize(films);
    gradient_.resize(films);
    machine_.for_each(mesh.films, parallel::Fill<std::uint8_t>{swaps_.data(), 0});
    const detail::Total area =
        machine_.reduce(mesh.bubbles, detail::Total{}, detail::TargetArea{mesh}, parallel::Add{});
    units_ = {std::sqrt(area.mean().x), 2 * mesh.surface_tension};
  }

  StepView step() { return {junction_step_.data(), angle_step_.data(), pressure_step_.data()}; }

  double residual_of(const FoamView& mesh) { return largest_residual(machine_, mesh, units_); }

  /// Newton's step. \returns MINRES's iterations.
  int find_step(const FoamView& mesh, double stiffening, double residual) {
    using namespace detail;
    const Index rows = mesh.junctions + mesh.bubbles;
    machine_.for_each(mesh.films,
                      Linearise{mesh, units_, stiffening, stiffness_.data(), gradient_.data()});
    machine_.for_each(rows, RightHandSide{mesh, units_, gradient_.data(), right_.data()});
    if (mesh.boundary != Boundary::Free) { // the areas' sum is given
      level_pressures(machine_, mesh, right_.data());
    }
    const WholeFoamMatrix matrix{mesh, stiffness_.data()};
    const int iterations =
        direct_ && solve_directly(matrix)
            ? 0
            : solve_iteratively(matrix, std::clamp(residual, kFinest, kRoughest));
    remove_gauges(machine_, mesh, solution_.data());
    take_step(mesh, stiffening);
    return iterations;
  }

  /// \returns whether the solution is as good as the finest that is asked of MINRES.
  bool solve_directly(const WholeFoamMatrix& matrix) {
    using namespace detail;
    const Index size = size_of(matrix.mesh);
    const double* const b = right_.data();
    direct_->solve(compressed_.assemble(matrix), b, solution_.data());
    product_.resize(static_cast<std::size_t>(size));
    machine_.for_each(matrix.mesh.junctions + matrix.mesh.bubbles,
                      Multiply{matrix, solution_.data(), product_.data()});
    const double error =
        machine_.reduce(size, 0.0, SquaredDifference{b, product_.data()}, parallel::Add{});
    return error <=
           kFinest * kFinest * machine_.reduce(size, 0.0, DotProduct{b, b}, parallel::Add{});
  }

  /// \returns the iterations it took.
  int solve_iteratively(const WholeFoamMatrix& matrix, double tolerance) {
    using namespace detail;
    const Index rows = matrix.mesh.junctions + matrix.mesh.bubbles;
    preconditioner_.set_up(matrix, units_);
    return solver_.solve(
        size_of(matrix.mesh), right_.data(), solution_.data(), tolerance, kInnerIterations,
        [&](const double* from, double* to) {
          machine_.for_each(rows, Multiply{matrix, from, to});
        },
        [&](const double* from, double* to) { preconditioner_.apply(from, to); });
  }

  /// The step that the solution is.
  void take_step(const FoamView& mesh, double stiffening) {
    using namespace detail;
    machine_.for_each(mesh.junctions, TakeJunctionStep{units_, solution_.data(), step()});
    machine_.for_each(mesh.bubbles, TakePressureStep{mesh, units_, solution_.data(), step()});
    machine_.for_each(mesh.films,
                      TakeAngleStep{mesh, units_, stiffening, solution_.data(), step()});
  }

  void walk(const FoamView& mesh, double fraction) {
    using namespace detail;
    machine_.for_each(mesh.junctions,
                      Walk<Vec2>{position_.data(), junction_step_.data(), fraction, mesh.position});
    machine_.for_each(mesh.films,
                      Walk<double>{angle_.data(), angle_step_.data(), fraction, mesh.film_angle});
    machine_.for_each(mesh.bubbles, Walk<double>{pressure_.data(), pressure_step_.data(), fraction,
                                                 mesh.pressure});
  }

  double violation(const FoamView& mesh) {
    return machine_.reduce(mesh.bubbles, 0.0, detail::ViolationOf{mesh}, parallel::Add{});
  }

  /// The exact penalty function (globalisation.h).
  double merit(const FoamView& mesh, double mu) {
    return units_.tension *
               machine_.reduce(mesh.films, 0.0, detail::LengthOf{mesh}, parallel::Add{}) +
           mu * violation(mesh);
  }

  /// Its weight of areas (J. Nocedal, S. J. Wright, Numerical Optimization, 2nd ed., 2006, 18.36).
  double penalty(const FoamView& mesh) {
    using namespace detail;
    const double largest =
        machine_.reduce(mesh.bubbles, 0.0, LargestPressure{mesh, step()}, parallel::Larger{});
    const double slope =
        units_.tension * machine_.reduce(mesh.films, 0.0, GrowthOf{mesh, step()}, parallel::Add{});
    const double descent = slope > 0 ? slope / violation(mesh) : 0;
    return 1.5 * std::max(largest, std::isfinite(descent) ? descent : 0) + 5e-4 * units_.pressure();
  }

  /// Takes as much of the step as can be taken, or backtracks along it, until the residual is
  /// halved or the merit function falls. \returns the fraction of the step taken.
  double search_line(const FoamView& mesh, double residual, double stiffening) {
    using namespace detail;
    const double mu = penalty(mesh);
    const double before = merit(mesh, mu);
    machine_.for_each(mesh.junctions, parallel::Copy<Vec2>{mesh.position, position_.data()});
    machine_.for_each(mesh.films, parallel::Copy<double>{mesh.film_angle, angle_.data()});
    machine_.for_each(mesh.bubbles, parallel::Copy<double>{mesh.pressure, pressure_.data()});
    const auto improves = [&](double fraction) {
      walk(mesh, fraction);
      return residual_of(mesh) < 0.5 * residual || merit(mesh, mu) < before;
    };
    const double longest = longest_step(mesh);
    if (longest < 1) {
      machine_.for_each(mesh.junctions, LimitJunction{mesh, step()});
      machine_.for_each(mesh.films, LimitAngle{mesh, step()});
      if (improves(1)) {
        return longest;
      }
      walk(mesh, 0);
      take_step(mesh, stiffening);
    }
    for (double fraction = longest; fraction > kSmallestStep * longest; fraction *= 0.5) {
      if (improves(fraction)) {
        return fraction;
      }
    }
    walk(mesh, 0);
    return 0;
  }

  Machine& machine_;
  EquilibratorOptions options_;
  Bidding<Machine> bidding_;
  MinimalResidual<Machine> solver_;
  FoamPreconditioner<Machine> preconditioner_;
  std::unique_ptr<DirectSolver> direct_;
  CompressedMatrix<Machine> compressed_;
  Units units_;

  Array<FilmStiffness> stiffness_;
  Array<FilmGradient> gradient_;
  Array<double> right_, solution_;
  Array<double> product_; ///< with a direct solver's solution
  Array<Vec2> junction_step_;
  Array<double> angle_step_, pressure_step_;
  Array<Vec2> position_; ///< and the next two: where a line search began
  Array<double> angle_, pressure_;
  Array<std::uint8_t> swaps_, closing_;
};

} // namespace foam::newton
