// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/foam.h"

namespace foam {

/// Von Neumann's rate of growth per side beyond six (thesis 2.4.5), K = (2π/3)γκ, cm²/s.
double von_neumann_constant(double surface_tension, double permeability);

/// dA/dt of every bubble from the gas that its films let through, −κ·Σ l·Δp (thesis 2.4.1), cm²/s;
/// 0 for vanished bubbles. The wall of a sealed container lets nothing through.
std::vector<double> gas_transfer(const Foam& foam, double permeability);

/// Von Neumann's K(n − 6) of a bubble, cm²/s (thesis 2.4.5), also on the free boundary, where n
/// counts the outer film.
double von_neumann_rate(const Foam& foam, Index bubble, double permeability);

/// The rates at which target areas change: von Neumann's K(n − 6) (thesis 2.4.5), also on the free
/// boundary, where n counts the outer film. Beside the wall of a sealed container, where films do
/// not end at 120°, it is the gas transfer itself; the container's total is conserved.
std::vector<double> area_rates(const Foam& foam, double permeability);

} // namespace foam
