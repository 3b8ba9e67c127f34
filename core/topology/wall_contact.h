// SPDX-License-Identifier: GPL-3.0-or-later
//
// How films come upon obstacles that lie free in a bubble. How they leave them: leave_wall.
#pragma once

#include <optional>

#include "mesh/foam.h"

namespace foam {

/// Where the outline of a bubble is nearest to an obstacle in it.
struct Approach {
  Half film = kNone; ///< with the bubble on its left
  WallPlace place;   ///< on the obstacle
  double gap = 0;    ///< between them, cm; negative if the film has gone beyond
  Wrap periods;      ///< from the obstacle to the image of it that is meant
};

/// \returns none if no film faces the obstacle. \pre the wall has a host
std::optional<Approach> nearest_film(const Foam& foam, Outside wall);

/// The same of all obstacles that lie in a bubble. \returns none if there is no such.
std::optional<Approach> nearest_film(const Foam& foam);

/// Parts a film that has come upon an obstacle in two, which end on it, at either side of where
/// they touch.
void perform_touch(Foam& foam, const Approach& approach);

/// Does so with all films that have gone beyond. \returns whether there were any
bool touch_walls(Foam& foam);

} // namespace foam
