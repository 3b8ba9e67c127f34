// SPDX-License-Identifier: GPL-3.0-or-later
//
// In the place of cudss_solver.cu, where there is no cuDSS.
#include "algebra/device_direct_solver.h"
#include "base/error.h"

namespace foam::cuda {

bool has_direct_solver() {
  return false;
}

std::unique_ptr<DirectSolver> make_direct_solver() {
  throw FoamError("LinearSolver = Direct, but this build has no cuDSS");
}

} // namespace foam::cuda
