// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <memory>
#include <utility>

#include "algebra/direct_solver.h"
#include "algebra/minimal_residual.h"
#include "equilibrium/compressed_matrix.h"
#include "equilibrium/foam_preconditioner.h"
#include "equilibrium/matrix_free.h"
#include "equilibrium/zero_modes.h"

namespace foam::newton {

/// Solves Newton's equations of a whole foam (equilibrium/newton.h) without a matrix, on an
/// executor (parallel/host.h): by MINRES with a preconditioner that does not feel the foam's size,
/// or by a direct solver that it is given.
///
/// No inertia is asked for that could tell whether a step leads to a minimum. Far from equilibrium,
/// and where the penalty function does not fall along a step, the equations are convexified
/// (film_derivatives): films resist being stretched, as springs do.
template <class Executor> class KrylovSolver {
public:
  /// \param direct solves the systems in place of MINRES, which takes over where that leaves more
  /// than 10⁻⁴ of the right-hand side; null for MINRES alone.
  explicit KrylovSolver(Executor& executor, std::unique_ptr<DirectSolver> direct = nullptr)
      : executor_(executor), minimal_residual_(executor), preconditioner_(executor),
        direct_(std::move(direct)), compressed_(executor) {}

  // What the loop asks for (equilibrium/newton.h).
  void begin(bool far) { convexification_ = far ? kFirstConvexification : 0; }
  static const StepView* reuse(const FoamView& /*mesh*/, const Domain& /*domain*/,
                               const Evaluation<Executor>& /*state*/, const Residual& /*residual*/,
                               double /*tolerance*/) {
    return nullptr;
  }
  const StepView* find(const FoamView& mesh, const Domain& domain,
                       const Evaluation<Executor>& state, const Residual& residual) {
    const ConstFoamView foam = const_view(mesh);
    const Units units{domain.spacing, foam.reference_tension()};
    stiffness_.resize(place_of(mesh.films));
    gradient_.resize(place_of(mesh.films));
    right_.resize(place_of(size_of(foam)));
    solution_.resize(place_of(size_of(foam)));
    const WholeFoamMatrix matrix{foam, FieldView<Film, const FilmStiffness>(stiffness_.data()),
                                 FieldView<Film, const FilmGradient>(gradient_.data()),
                                 units.length};
    linearise(executor_, foam, units, convexification_,
              FieldView<Film, FilmStiffness>(stiffness_.data()),
              FieldView<Film, FilmGradient>(gradient_.data()));
    gather_load(executor_, foam, units, state.areas(),
                FieldView<Film, const FilmGradient>(gradient_.data()), right_.data());
    remove_common_pressure(executor_, foam, domain.bubbles, pressures_of(foam, right_.data()));
    remove_rigid_motion(executor_, foam, domain, right_.data());
    if (!direct_ || !solve_directly(matrix)) {
      solve_iteratively(matrix, units, std::clamp(residual.largest(), kFinest, kRoughest));
    }
    remove_common_pressure(executor_, foam, domain.bubbles, pressures_of(foam, solution_.data()));
    remove_rigid_motion(executor_, foam, domain, solution_.data());
    step_.fit(foam);
    view_ = step_.view();
    take_step(executor_, foam, units, convexification_, solution_.data(), view_);
    return &view_;
  }
  bool convexify() {
    if (convexification_ >= kMostConvexification) {
      return false;
    }
    convexification_ = std::max(kFirstConvexification, 8 * convexification_);
    return true;
  }
  void took(double fraction) {
    if (fraction == 1) {
      convexification_ = convexification_ > kLeastConvexification ? convexification_ / 8 : 0;
    }
  }

  /// MINRES's iterations so far.
  int iterations() const { return iterations_; }

private:
  template <class T> using Array = typename Executor::template Array<T>;

  static constexpr double kFirstConvexification = 1; // in units of a stretched film's own stiffness
  static constexpr double kLeastConvexification = 0.01;
  static constexpr double kMostConvexification = 1000;
  static constexpr double kRoughest = 1e-2; // to which linear systems are solved, …
  static constexpr double kFinest = 1e-4;   // … in between as the residual is
  static constexpr int kMostIterations = 500;

  /// \returns whether the solution is as good as the finest that is asked of MINRES.
  bool solve_directly(const WholeFoamMatrix& matrix) {
    const double* const b = right_.data();
    direct_->solve(compressed_.assemble(CompressedMatrix{matrix}), b, solution_.data());
    product_.resize(right_.size());
    multiply(executor_, matrix, solution_.data(), product_.data());
    const Index size = size_of(matrix.mesh);
    return squared_distance(executor_, size, b, product_.data()) <=
           kFinest * kFinest * dot_product(executor_, size, b, b);
  }

  void solve_iteratively(const WholeFoamMatrix& matrix, const Units& units, double tolerance) {
    preconditioner_.set_up(matrix, units);
    iterations_ += minimal_residual_.solve(
        size_of(matrix.mesh), right_.data(), solution_.data(), tolerance, kMostIterations,
        [&](const double* from, double* to) { multiply(executor_, matrix, from, to); },
        [&](const double* from, double* to) { preconditioner_.apply(from, to); });
  }

  Executor& executor_;
  MinimalResidual<Executor> minimal_residual_;
  FoamPreconditioner<Executor> preconditioner_;
  std::unique_ptr<DirectSolver> direct_;
  CompressedRows<Executor> compressed_;
  double convexification_ = 0;
  int iterations_ = 0;

  Array<FilmStiffness> stiffness_;
  Array<FilmGradient> gradient_;
  Array<double> right_, solution_;
  Array<double> product_; ///< with a direct solver's solution
  Step<Executor> step_;
  StepView view_;
};

} // namespace foam::newton
