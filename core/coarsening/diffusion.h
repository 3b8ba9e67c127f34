// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/foam.h"

namespace foam {

/// Von Neumann's rate of growth per side beyond six (thesis 2.4.5), K = (2π/3)γκ, cm²/s.
double von_neumann_constant(double surface_tension, double permeability);

/// dA/dt of a bubble from the gas that its films let through, −κ·Σ l·Δp (thesis 2.4.1), cm²/s. The
/// wall of a sealed container lets nothing through.
template <class Mesh>
FOAM_HOST_DEVICE double gas_transfer(const Mesh& mesh, Index bubble, double permeability) {
  double inflow = 0;
  for_each_half(mesh, bubble, [&](Index h) {
    if (!mesh.wall(h)) {
      inflow -= permeability * mesh.length(h) *
                (mesh.pressure_of(bubble) - mesh.pressure_of(mesh.right(h)));
    }
  });
  return inflow;
}

/// Whether films do not meet at 120° around all of the bubble: beside a sealed container's wall.
template <class Mesh> FOAM_HOST_DEVICE bool at_wall(const Mesh& mesh, Index bubble) {
  return mesh.boundary == Boundary::Fixed && mesh.bubble_on_world(bubble);
}

/// The rate at which a bubble's target area changes, cm²/s: von Neumann's K(n − 6) (thesis 2.4.5),
/// also on the free boundary, where n counts the outer film; at a wall the gas transfer itself.
double area_rate(const Foam& foam, Index bubble, double permeability);

/// Those of all bubbles, 0 for vanished ones; a container's total is conserved.
std::vector<double> area_rates(const Foam& foam, double permeability);

} // namespace foam
