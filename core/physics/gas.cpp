// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/gas.h"

#include <numbers>

#include "parallel/host.h"

namespace foam {

double von_neumann_constant(double surface_tension, double kappa) {
  return 2 * std::numbers::pi / 3 * surface_tension * kappa;
}

AreaRate area_rate(const ConstFoamView& mesh, double kappa) {
  return {mesh, von_neumann_constant(mesh.surface_tension, kappa), kappa};
}

Field<Bubble, double> area_rates(const Foam& foam, double kappa) {
  const ConstFoamView mesh = view_of(foam);
  const AreaRate rate = area_rate(mesh, kappa);
  Host host(1);
  const double excess = sum_bubbles(host, mesh, rate).excess();
  Field<Bubble, double> rates(foam.pressure.size(), 0.0);
  for (const Bubble b : foam.bubble_slots()) {
    if (foam.has_bubble(b)) {
      rates[b] = detail::even(rate, b, excess);
    }
  }
  return rates;
}

} // namespace foam
