// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/options.h"

#include "base/error.h"

namespace foam {
namespace {

void check(const JunctionOptions& options) {
  require(options.damping > 0 && options.damping <= 1, "Damping", "in (0, 1]", options.damping);
  require(options.finite_difference_step > 0, "FiniteDifferenceStep", "positive",
          options.finite_difference_step);
  require(options.jacobian_tolerance > 0, "JacobianTolerance", "positive",
          options.jacobian_tolerance);
  require(options.pressure_tolerance > 0, "PressureTolerance", "positive",
          options.pressure_tolerance);
  require(options.position_tolerance > 0, "PositionTolerance", "positive",
          options.position_tolerance);
  require(options.minimum_scale > 0 && options.minimum_scale < 1, "MinimumScale", "in (0, 1)",
          options.minimum_scale);
}

} // namespace

void check(const EquilibratorOptions& options) {
  require(options.tolerance > 0, "Tolerance", "positive", options.tolerance);
  require(options.maximum_iterations > 0, "MaximumIterations", "at least 1",
          options.maximum_iterations);
  if (options.kind == EquilibratorKind::Junction) {
    check(options.junction);
  }
  if (options.linear_solver == LinearSolver::Direct &&
      (options.kind != EquilibratorKind::Newton || options.device != Device::CUDA)) {
    throw FoamError("LinearSolver = Direct is for Equilibrator = Newton with Device = CUDA alone");
  }
}

} // namespace foam
