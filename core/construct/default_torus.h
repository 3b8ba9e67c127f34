// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "geometry/lattice.h"

namespace foam {

/// The rectangle on which points make a foam whose bubbles at the seam are as large as the others:
/// the points' bounds, grown by the same on every side so that the rectangle has for each point the
/// area that those have which lie more than two spacings inside the bounds. Where there are few of
/// those, the area is that of a square whose side is twice what the bounds grow by: a square grid
/// gets its own periods.
/// \param points cm, not all on a line
Lattice default_torus(std::span<const Vec2> points);

} // namespace foam
