// SPDX-License-Identifier: GPL-3.0-or-later
//
// What runs on a GPU, on the processor.
#pragma once

#include "equilibrium/executor_equilibrator.h"
#include "parallel/host.h"

namespace foam::test {

/// A foam's copy on the processor, as ExecutorEquilibrator wants one.
class HostCopy {
public:
  void upload(const Foam& foam) { foam_ = foam; }
  FoamView view() { return view_of(foam_); }
  void download(Foam& foam) const {
    static_cast<FoamArrays<Field>&>(foam) = static_cast<const FoamArrays<Field>&>(foam_);
  }

private:
  Foam foam_;
};

using KrylovEquilibrator = ExecutorEquilibrator<Host, HostCopy>;

/// Newton's equations of a whole foam, on any executor.
template <class Executor> class NewtonSystem {
public:
  NewtonSystem(Executor& executor, const FoamView& mesh, double spacing, double convexification = 0)
      : executor_(executor), mesh_(const_view(mesh)),
        domain_(whole_mesh(mesh_, spacing)), units_{spacing, mesh.reference_tension()},
        stiffness_(place_of(mesh.films)), gradient_(place_of(mesh.films)),
        preconditioner_(executor), compressed_(executor) {
    linearise(executor, mesh_, units_, convexification,
              FieldView<Film, FilmStiffness>(stiffness_.data()),
              FieldView<Film, FilmGradient>(gradient_.data()));
    preconditioner_.set_up(matrix(), units_);
  }

  Index size() const { return newton::size_of(mesh_); }
  const newton::Units& units() const { return units_; }
  newton::WholeFoamMatrix matrix() const {
    return {mesh_, FieldView<Film, const FilmStiffness>(stiffness_.data()),
            FieldView<Film, const FilmGradient>(gradient_.data()), units_.length};
  }
  bool is_unknown(Index i) const {
    return i < 2 * mesh_.junctions ? mesh_.moves(Junction(i / 2))
                                   : mesh_.has_bubble(Bubble(i - 2 * mesh_.junctions));
  }

  void multiply(const double* x, double* to) { newton::multiply(executor_, matrix(), x, to); }
  void precondition(const double* x, double* to) { preconditioner_.apply(x, to); }
  void load(double* to) {
    newton::Evaluation<Executor> state;
    state.evaluate(executor_, mesh_, domain_);
    gather_load(executor_, mesh_, units_, state.areas(),
                FieldView<Film, const FilmGradient>(gradient_.data()), to);
  }
  /// Takes out of a solution, or of a load, what costs nothing.
  void remove_common_pressure(double* x) {
    newton::remove_common_pressure(executor_, mesh_, domain_.bubbles,
                                   newton::pressures_of(mesh_, x));
  }
  void remove_rigid_motion(double* x) { newton::remove_rigid_motion(executor_, mesh_, domain_, x); }
  LowerTriangle assemble() { return compressed_.assemble(newton::CompressedMatrix{matrix()}); }
  int solve(const double* right, double* x, double tolerance, int most = 500) {
    return MinimalResidual<Executor>(executor_).solve(
        size(), right, x, tolerance, most,
        [&](const double* from, double* to) { multiply(from, to); },
        [&](const double* from, double* to) { precondition(from, to); });
  }

private:
  Executor& executor_;
  ConstFoamView mesh_;
  Domain domain_;
  newton::Units units_;
  typename Executor::template Array<FilmStiffness> stiffness_;
  typename Executor::template Array<FilmGradient> gradient_;
  newton::FoamPreconditioner<Executor> preconditioner_;
  CompressedRows<Executor> compressed_;
};

} // namespace foam::test
