// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/sparse_solver.h"

namespace foam {

std::unique_ptr<SparseSolver> make_sparse_solver() {
#ifdef FOAM_HAVE_MUMPS
  return make_mumps_solver();
#else
  return make_eigen_solver();
#endif
}

} // namespace foam
