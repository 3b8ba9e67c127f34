// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "algebra/direct_solver.h"
#include "equilibrium/options.h"

namespace foam::cuda {

/// Whether this build has a direct solver for the device: NVIDIA's cuDSS, where CMake found it.
bool has_direct_solver();

/// One for matrices in the device's memory. It analyses a matrix only if its entries are not in the
/// places of those before, and asks cuDSS for the same bits every time, where it offers that.
/// \throws FoamError if this build has none, or cuDSS fails.
std::unique_ptr<DirectSolver> make_direct_solver();

/// What the options ask for; null for none.
inline std::unique_ptr<DirectSolver> direct_solver_for(const EquilibratorOptions& options) {
  return options.linear_solver == LinearSolver::Direct ? make_direct_solver() : nullptr;
}

} // namespace foam::cuda
