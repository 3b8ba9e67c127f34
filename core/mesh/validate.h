// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

#include "mesh/foam.h"

namespace foam {

/// Checks every invariant of the dual mesh and returns what is wrong with it, a sentence per
/// problem; empty for a valid foam. Never crashes, whatever the arrays hold.
///
/// Twins start in the two ends of one film; three films meet in a junction; the bubble on the left
/// of a half-film is on the right of the next one counter-clockwise; each bubble's films form one
/// closed loop of as many films as it has sides, closed on the torus too; a bubble has at least two
/// sides; Euler's V − E + F is 2 on the plane (the world counted) and 0 on the torus.
std::vector<std::string> validate(const Foam& foam);

/// Checks the geometry of a foam that claims to be in equilibrium: films leave their junctions in
/// counter-clockwise order and every bubble's area is positive. Call on a valid foam.
std::vector<std::string> validate_geometry(const Foam& foam);

/// Checks that the stretches of each wall follow each other once round it. Call on a valid foam.
std::vector<std::string> validate_walls(const Foam& foam);

} // namespace foam
