// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algebra/minimal_residual.h"
#include "equilibrium/compressed_matrix.h"
#include "equilibrium/evaluation.h"
#include "equilibrium/foam_preconditioner.h"
#include "equilibrium/matrix_free.h"
#include "equilibrium/zero_modes.h"

namespace foam::test {

/// Newton's equations of a whole foam, on any executor; newton_system_members.h has the functions.
template <class Executor> class NewtonSystem {
public:
  NewtonSystem(Executor& executor, const FoamView& mesh, double spacing,
               double convexification = 0);

  Index size() const;
  const newton::Units& units() const;
  newton::WholeFoamMatrix matrix() const;
  bool is_unknown(Index i) const;

  void multiply(const double* x, double* to);
  void precondition(const double* x, double* to);
  void load(double* to);
  /// Takes out of a solution, or of a load, what costs nothing.
  void remove_common_pressure(double* x);
  void remove_rigid_motion(double* x);
  LowerTriangle assemble();
  int solve(const double* right, double* x, double tolerance, int most = 500);

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
