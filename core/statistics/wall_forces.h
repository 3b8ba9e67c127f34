// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/foam.h"

namespace foam {

/// What a foam does to a wall, per cm of its depth, N/cm.
struct WallForce {
  Vec2 network;  ///< of the films that end there, Σ T·t with t away from the wall
  Vec2 pressure; ///< of the gas, −Σ p·∫n ds with n into the foam

  friend bool operator==(const WallForce&, const WallForce&) = default;
};

/// Of each outside with a wall, in order; empty without walls. A constant that is added to all
/// pressures changes none of a closed wall's. In equilibrium those of a closed container and of all
/// that is in it cancel.
std::vector<WallForce> wall_forces(const Foam& foam);

} // namespace foam
