// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is drawn where films meet. Each film draws the places that are nearer to it than to the
// films beside it at its two junctions: so films join without overlaps and gaps, and a Plateau
// border is shared out among its films.
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/plateau_border.h"
#include "geometry/vec2.h"

namespace foam {

/// A film to be drawn: an arc between two junctions.
struct DrawnFilm {
  Vec2 start, end; ///< cm
  /// tan(α/2) of the half-angle α, > 0 where the film bulges to the right: the "bulge" of drawing
  /// formats. With it all of an arc's geometry is rational.
  double bulge = 0;
  std::int64_t start_junction = -1, end_junction = -1;
};

/// The film beside another one at a junction.
struct Neighbour {
  std::int64_t end = -1; ///< which end of which film is at the junction, 2·film or 2·film + 1
  BorderSide side; ///< of the Plateau border between the two; centre from the junction; none if 0
};

/// What is beside one end of a film, seen from the junction along the film.
struct FilmEnd {
  Neighbour left, right;
};

/// Both ends of each film, the start and then the end; −1 for a neighbour that there is not.
/// `border_radius` (cm) is that of the Plateau borders' sides between straight films, 0 for a dry
/// foam. Borders are made smaller where a film is too short for those at its two ends.
std::vector<FilmEnd> film_ends(const std::vector<DrawnFilm>& films, double border_radius);

/// How far a Plateau border reaches to the side of a film's end (cm).
double border_margin(const FilmEnd& end);

} // namespace foam
