// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "equilibrium/newton_equilibrator.h"
#include "junction/junction_equilibrator.h"
#include "mesh/number.h"
#include "parallel/accelerator.h"

namespace foam {

void check_options(const EquilibratorOptions& options) {
  if (!(options.tolerance > 0) || !std::isfinite(options.tolerance)) {
    throw FoamError("Tolerance must be positive, but is " + number(options.tolerance));
  }
  if (options.maximum_iterations < 1) {
    throw FoamError("MaximumIterations must be at least 1, but is " +
                    std::to_string(options.maximum_iterations));
  }
  if (options.linear_solver == LinearSolver::Direct &&
      (options.kind != EquilibratorKind::Newton || options.device != Device::CUDA)) {
    throw FoamError("LinearSolver = Direct is for Equilibrator = Newton with Device = CUDA alone");
  }
}

std::unique_ptr<Equilibrator> make_equilibrator(const EquilibratorOptions& options) {
  check_options(options);
  if (const Accelerator* const accelerator =
          accelerator_for(options.device, accelerator_obstacle(options))) {
    return accelerator->make_equilibrator(options);
  }
  if (options.kind == EquilibratorKind::Junction) {
    return std::make_unique<JunctionEquilibrator>(options);
  }
  return std::make_unique<NewtonEquilibrator>(options);
}

} // namespace foam
