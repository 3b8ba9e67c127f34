// SPDX-License-Identifier: GPL-3.0-or-later
//
// A plane that is divided into regions by straight sides, as the foam that it looks like.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/film_set.h"

namespace foam {

/// A straight side between two regions.
struct Side {
  Index from = kNone; ///< point
  Index to = kNone;   ///< point
  Index left = kNone; ///< region on the left of the way; kNone is the outside
  Index right = kNone;
  Wrap wrap; ///< periods from the one point's cell to the other's, on a torus
};

struct Division {
  std::vector<Vec2> points; ///< cm
  std::vector<Side> sides;
  std::vector<std::int64_t> ids; ///< of the regions' bubbles, in ascending order
  std::optional<Lattice> torus;  ///< that the regions fill
};

/// What to make of the line around it all.
enum class DivisionOutline {
  Films, ///< films that bulge into a gas
  Wall   ///< the wall of a container, with its corners, along which films slide
};

struct DivisionFoam {
  Foam foam;                      ///< not in equilibrium; the regions' areas are the target areas
  std::vector<double> misfit;     ///< of each film: how far its points lie from its arc, cm
  Index points_of_more_films = 0; ///< where more than three met
};

/// The foam with the same neighbours. Sides that meet two by two are one film, the arc with their
/// ends and with their area beside it, so that each bubble has its region's area. Where more than
/// three meet, the pairs with the smallest angles part from the others, by a quarter of the
/// shortest side there. \pre the sides hang together, and there is no outside inside
/// \throws FoamError if that is no foam, naming regions by their bubbles' ids
DivisionFoam foam_of_division(const Division& division, DivisionOutline outline,
                              double surface_tension);

/// The pieces that sides hang together in: for each side the number of its piece, from 0.
std::vector<Index> pieces_of(const Division& division);

} // namespace foam
