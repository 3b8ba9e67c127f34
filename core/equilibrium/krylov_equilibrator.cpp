// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/krylov_equilibrator.h"

#include <utility>

#include "equilibrium/compressible_relaxation.h"

namespace foam {

KrylovEquilibrator::KrylovEquilibrator(const EquilibratorOptions& options, int threads,
                                       std::size_t least_per_thread)
    : host_(threads, least_per_thread), newton_(host_, options) {}

EquilibriumReport KrylovEquilibrator::equilibrate(Foam& foam, double t1_length,
                                                  const AbortCheck& aborted) {
  Foam changed = foam;
  if (newton_.hemmed_in(view_of(changed))) {
    relax_compressible(changed, t1_length, aborted);
  }
  const newton::NewtonResult result = newton_.equilibrate(view_of(changed), t1_length, aborted);
  foam = std::move(changed);
  newton::note(foam, result);
  return foam.report;
}

} // namespace foam
