// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "mesh/foam.h"

namespace foam {

/// The part of a foam that an equilibration may change; all else is held. Indices ascend.
struct Region {
  std::vector<Index> junctions; ///< that move
  std::vector<Index> films;     ///< whose half-angles change: those of the bubbles
  std::vector<Index> bubbles;   ///< whose pressures change so that their areas are right
  std::vector<Index> rim;       ///< bubbles beyond the outermost films: their pressures are held
  bool whole = false;           ///< nothing is held but a container's wall
  double spacing = 0;           ///< √(mean target area) of the bubbles, cm
};

/// All of a foam. Junctions and films on the wall of a sealed container are held.
Region whole_foam(const Foam& foam);

/// The given bubbles that are there and so many rings of neighbours around them, ascending.
std::vector<Index> rings_around(const Foam& foam, std::span<const Index> bubbles, int rings);

/// A patch: the junctions of the given bubbles and of `rings` rings of neighbours around them move.
/// All bubbles at these junctions keep their areas: one of held pressure, grown or shrunk at no
/// cost, would be unstable.
Region patch(const Foam& foam, std::span<const Index> bubbles, int rings);

} // namespace foam
