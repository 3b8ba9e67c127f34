// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>

#include "construct/triangulation.h"
#include "mesh/foam.h"

namespace foam {

/// The mesh dual to a triangulation, its junctions not yet in place: bubbles in the order of the
/// points, junctions in that of the triangles, films in that of the edges. A junction's half-films
/// begin with the lowest, and a bubble is found by its lowest.
Foam dual_mesh(std::span<const Triangle> triangles, std::size_t points);

/// A triangle as a junction sees it, cm.
using Face = std::array<Vec2, 3>;

/// Puts each junction at its face's barycentre (thesis 4.5.3); at its incentre where barycentres
/// would leave a bubble without area.
void place_junctions(Foam& foam, std::span<const Face> faces);

} // namespace foam
