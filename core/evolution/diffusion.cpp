// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/diffusion.h"

#include <numbers>

namespace foam {

double von_neumann_constant(double surface_tension, double permeability) {
  return 2 * std::numbers::pi / 3 * surface_tension * permeability;
}

double von_neumann_rate(const Foam& foam, Index bubble, double permeability) {
  return von_neumann_constant(foam.surface_tension, permeability) *
         (foam.sides[Foam::size(bubble)] - 6);
}

std::vector<double> gas_transfer(const Foam& foam, double permeability) {
  std::vector<double> rate(foam.pressure.size(), 0.0);
  for (Index f = 0; f < foam.film_capacity(); ++f) {
    const Index h = 2 * f;
    if (!foam.has_film(f) || foam.wall(h)) {
      continue;
    }
    const Index left = foam.left(h);
    const Index right = foam.right(h);
    const double flow =
        permeability * foam.length(h) * (foam.pressure_of(left) - foam.pressure_of(right));
    if (left != kWorld) {
      rate[Foam::size(left)] -= flow;
    }
    if (right != kWorld) {
      rate[Foam::size(right)] += flow;
    }
  }
  return rate;
}

std::vector<double> area_rates(const Foam& foam, double permeability) {
  std::vector<double> rate(foam.pressure.size(), 0.0);
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    if (foam.has_bubble(b)) {
      rate[Foam::size(b)] = von_neumann_rate(foam, b, permeability);
    }
  }
  if (foam.boundary != Boundary::Fixed) {
    return rate;
  }
  const std::vector<double> transfer = gas_transfer(foam, permeability);
  std::vector<std::size_t> at_wall;
  double total = 0;
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    if (foam.has_bubble(b)) {
      const auto i = Foam::size(b);
      if (foam.bubble_on_world(b)) {
        rate[i] = transfer[i];
        at_wall.push_back(i);
      }
      total += rate[i];
    }
  }
  for (const std::size_t i : at_wall) { // rounding, and what the equilibrium's tolerance leaves
    rate[i] -= total / static_cast<double>(at_wall.size());
  }
  return rate;
}

} // namespace foam
