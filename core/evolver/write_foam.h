// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "mesh/foam.h"

namespace foam {

/// A foam as a datafile for Surface Evolver in its two-dimensional STRING model, with an edge for
/// each film: quadratic, of the methods circular_arc_length and circular_arc_area, so that energy,
/// areas and pressures are there what they are here, in the same units. Bubbles are bodies in the
/// order of their ids, which the attribute BubbleId has. Pressures are above the outside's. What
/// read_evolver() makes of it is the foam again.
///
/// Walls are edges of tension 0 on constraints, lines and circles, along which films slip; FIXED
/// where films are pinned. Of the bubbles between walls that of the highest id has no VOLUME, as it
/// has what the others leave.
/// \throws FoamError for a foam in several gases
std::string write_evolver(const Foam& foam);

} // namespace foam
