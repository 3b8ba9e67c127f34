// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "newton_system.h"

namespace foam::test {

template <class Executor>
NewtonSystem<Executor>::NewtonSystem(Executor& executor, const FoamView& mesh, double spacing,
                                     double convexification)
    : executor_(executor), mesh_(const_view(mesh)),
      domain_(whole_mesh(mesh_, spacing)), units_{spacing, mesh.reference_tension()},
      stiffness_(place_of(mesh.films)), gradient_(place_of(mesh.films)), preconditioner_(executor),
      compressed_(executor) {
  linearise(executor, mesh_, units_, convexification,
            FieldView<Film, FilmStiffness>(stiffness_.data()),
            FieldView<Film, FilmGradient>(gradient_.data()));
  preconditioner_.set_up(matrix(), units_);
}

template <class Executor> Index NewtonSystem<Executor>::size() const {
  return newton::size_of(mesh_);
}

template <class Executor> const newton::Units& NewtonSystem<Executor>::units() const {
  return units_;
}

template <class Executor> newton::WholeFoamMatrix NewtonSystem<Executor>::matrix() const {
  return {mesh_, FieldView<Film, const FilmStiffness>(stiffness_.data()),
          FieldView<Film, const FilmGradient>(gradient_.data()), units_.length};
}

template <class Executor> bool NewtonSystem<Executor>::is_unknown(Index i) const {
  return i < 2 * mesh_.junctions ? mesh_.moves(Junction(i / 2))
                                 : mesh_.has_bubble(Bubble(i - 2 * mesh_.junctions));
}

template <class Executor> void NewtonSystem<Executor>::multiply(const double* x, double* to) {
  newton::multiply(executor_, matrix(), x, to);
}

template <class Executor> void NewtonSystem<Executor>::precondition(const double* x, double* to) {
  preconditioner_.apply(x, to);
}

template <class Executor> void NewtonSystem<Executor>::load(double* to) {
  newton::Evaluation<Executor> state;
  state.evaluate(executor_, mesh_, domain_);
  gather_load(executor_, mesh_, units_, state.areas(),
              FieldView<Film, const FilmGradient>(gradient_.data()), to);
}

template <class Executor> void NewtonSystem<Executor>::remove_common_pressure(double* x) {
  newton::remove_common_pressure(executor_, mesh_, domain_.bubbles, newton::pressures_of(mesh_, x));
}

template <class Executor> void NewtonSystem<Executor>::remove_rigid_motion(double* x) {
  newton::remove_rigid_motion(executor_, mesh_, domain_, x);
}

template <class Executor> LowerTriangle NewtonSystem<Executor>::assemble() {
  return compressed_.assemble(newton::CompressedMatrix{matrix()});
}

template <class Executor>
int NewtonSystem<Executor>::solve(const double* right, double* x, double tolerance, int most) {
  return MinimalResidual<Executor>(executor_).solve(
      size(), right, x, tolerance, most,
      [&](const double* from, double* to) { multiply(from, to); },
      [&](const double* from, double* to) { precondition(from, to); });
}

} // namespace foam::test
