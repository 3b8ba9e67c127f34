// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarsening/diffusion.h"

#include <numbers>

namespace foam {

double von_neumann_constant(double surface_tension, double permeability) {
  return 2 * std::numbers::pi / 3 * surface_tension * permeability;
}

double area_rate(const Foam& foam, Index bubble, double permeability) {
  if (at_wall(foam, bubble)) {
    return gas_transfer(foam, bubble, permeability);
  }
  return von_neumann_constant(foam.surface_tension, permeability) *
         (foam.sides[Foam::size(bubble)] - 6);
}

std::vector<double> area_rates(const Foam& foam, double permeability) {
  std::vector<double> rate(foam.pressure.size(), 0.0);
  std::vector<std::size_t> evens_out;
  double total = 0;
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    if (foam.has_bubble(b)) {
      const auto i = Foam::size(b);
      rate[i] = area_rate(foam, b, permeability);
      total += rate[i];
      if (at_wall(foam, b)) {
        evens_out.push_back(i);
      }
    }
  }
  for (const std::size_t i : evens_out) { // rounding, and what the equilibrium's tolerance leaves
    rate[i] -= total / static_cast<double>(evens_out.size());
  }
  return rate;
}

} // namespace foam
