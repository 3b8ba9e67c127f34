// SPDX-License-Identifier: GPL-3.0-or-later
#include "thesis/junction_equilibrator.h"

#include <utility>

namespace foam {
namespace {

/// Figure 3.13: each junction solves against what the ones before it have left.
thesis::Maxima sweep_gauss_seidel(Foam& foam, const JunctionOptions& options) {
  thesis::Maxima maxima;
  for (const Junction j : foam.junction_slots()) {
    if (foam.has_junction(j)) {
      maxima.include(thesis::equilibrate_junction(foam, j, options));
    }
  }
  return maxima;
}

} // namespace

JunctionEquilibrator::JunctionEquilibrator(const EquilibratorOptions& options, int threads)
    : options_(options), host_(threads), jacobi_(host_, options.junction) {}

EquilibriumReport JunctionEquilibrator::equilibrate(Foam& foam, double /*t1_length*/,
                                                    const AbortCheck& aborted) {
  Field<Junction, Vec2> position = foam.position;
  Field<Bubble, double> pressure = foam.pressure;
  const FoamView mesh = view_of(foam);
  const bool jacobi = options_.junction.sweep == Sweep::Jacobi;
  if (jacobi) {
    jacobi_.prepare(mesh);
  }
  try {
    foam.report = thesis::sweep_to_rest(host_, mesh, options_, aborted, [&] {
      return jacobi ? jacobi_.sweep(mesh) : sweep_gauss_seidel(foam, options_.junction);
    });
  } catch (...) {
    foam.position = std::move(position);
    foam.pressure = std::move(pressure);
    throw;
  }
  return foam.report;
}

} // namespace foam
