// SPDX-License-Identifier: GPL-3.0-or-later
//
// Obstacles that no film touches: each lies in a bubble, its host.
#pragma once

#include "mesh/foam.h"

namespace foam {

/// What a film that comes upon such an obstacle needs (topology/wall_contact.h).
inline constexpr Index kFilmsOfContact = 3;
inline constexpr Index kJunctionsOfContact = 2;

/// Once along a whole wall, cm.
double length_of_wall(const Foam& foam, Outside wall);

/// Whether there are walls round which the foam lies.
bool has_obstacles(const Foam& foam);

/// Finds the host of every wall on which no film ends, and makes room for the films that will.
/// \throws FoamError if one lies in no bubble
void house_walls(Foam& foam);

} // namespace foam
