// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "geometry/lattice.h"

namespace foam {

/// The rectangle on which points make a foam whose bubbles at the seam are as large as the others:
/// the points' bounds, grown by a gap in x and another in y, which are found so that the points
/// near the bounds of either coordinate have the mean area on the torus. A lattice gets its own
/// periods, or where its rows do not fit each other at the seam, as an odd number of staggered
/// ones, those of its areas. A gap is at least the mean gap of its coordinates and at most two
/// spacings. Where most of the points are near the bounds it is that of a square grid. \param
/// points cm, not all on a line
Lattice default_torus(std::span<const Vec2> points);

} // namespace foam
