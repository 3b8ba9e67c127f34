// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/krylov_equilibrator.h"

#include <utility>

namespace foam {

KrylovEquilibrator::KrylovEquilibrator(const EquilibratorOptions& options, int threads,
                                       std::size_t least_per_thread)
    : host_(threads, least_per_thread), newton_(host_, options) {}

EquilibriumReport KrylovEquilibrator::equilibrate(Foam& foam, double t1_length,
                                                  const AbortCheck& aborted) {
  Foam changed = foam;
  const newton::NewtonResult result = newton_.equilibrate(view_of(changed), t1_length, aborted);
  foam = std::move(changed);
  foam.t1_count += result.t1;
  foam.topology += static_cast<std::uint64_t>(result.t1);
  foam.report = result.report;
  return foam.report;
}

} // namespace foam
