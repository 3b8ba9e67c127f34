// SPDX-License-Identifier: GPL-3.0-or-later
//
// The three topological operations on the dual mesh (thesis 2.3, 3.2.2 and, for T3, 3.6). Each is
// local, keeps the mesh valid, and is to be asked for only where it can be performed.
#pragma once

#include <array>

#include "mesh/foam.h"

namespace foam {

/// Whether the film can be swapped: the two bubbles that lose a side keep two, the two that gain
/// one differ, and the film is no piece of a container's wall.
bool can_perform_t1(const Foam& foam, Index film);

/// Swaps a film (thesis Figure 3.3): the two bubbles at its ends become neighbours, the two along
/// it part. The new film lies across the old one, has its chord's length, and takes the curvature
/// of its bubbles' pressures; beside a container's wall it becomes a piece of the wall. \returns
/// the two bubbles that lost a side (the world among them as kWorld).
std::array<Index, 2> perform_t1(Foam& foam, Index film);

/// Whether the bubble has three sides and its neighbours can spare one each.
bool can_perform_t2(const Foam& foam, Index bubble);

/// What is new after a T2: the three films that were prolonged and the bubbles between them.
struct T2Result {
  std::array<Index, 3> films;
  std::array<Index, 3> bubbles;
};

/// Removes a three-sided bubble (thesis Figure 3.4). Its three outer films are prolonged along
/// their arcs until they meet, which in equilibrium they do in one point and at 120° (decoration
/// theorem: D. Weaire, Phil. Mag. Lett. 79 (1999) 491); the rest of the foam stays in equilibrium
/// when the neighbours' target areas grow by what they gain, and so they do here: no gas is lost
/// but to the world. Where the arcs do not meet, the new junction is the mean of the three.
T2Result perform_t2(Foam& foam, Index bubble);

/// Whether the bubble has two sides and is not one of a double bubble.
bool can_perform_t3(const Foam& foam, Index bubble);

/// Removes a two-sided bubble: the film that it floats on closes behind it, an arc of one circle in
/// equilibrium. Its two neighbours' target areas grow by what they gain. Beside a container's wall
/// the wall is straightened, which may cost a sliver of the container's area.
/// \returns the two neighbours.
std::array<Index, 2> perform_t3(Foam& foam, Index bubble);

/// Slides a two-sided bubble along the shorter of the two films that end in it, until that film is
/// `distance` (cm) long (thesis 3.6.1). Does nothing if it is that short already.
void slide_two_sided_bubble(Foam& foam, Index bubble, double distance);

} // namespace foam
