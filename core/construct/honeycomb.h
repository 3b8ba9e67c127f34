// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "mesh/foam.h"

namespace foam {

struct HoneycombOptions {
  Index columns = 0;             ///< bubbles in a row, at least 4
  Index rows = 0;                ///< even, at least 4
  double displacement = 0;       ///< of every junction along x and y, cm; in [0, 0.15]
  double swaps = 0;              ///< share of films to try a T1 on, in [0, 1]
  double surface_tension = 0.25; ///< γ, N/cm, > 0
  std::uint64_t seed = 1;        ///< the same seed gives the same foam on every platform
};

/// A honeycomb on a torus with bubbles of 1 cm², its junctions displaced at random by up to
/// `displacement` in either direction and films swapped at random where bubbles keep five to seven
/// sides. Target areas are the areas, films are straight and pressures 0. Needs no triangulation.
/// Not in equilibrium, unless displacement and swaps are 0.
/// \throws FoamError for options out of range.
Foam honeycomb(const HoneycombOptions& options);

} // namespace foam
