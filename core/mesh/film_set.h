// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "mesh/foam.h"

namespace foam {

/// A foam as its films list it: what is written to a file and read back, without masks and without
/// the mesh's internal order. Films and junctions are numbered from 0 in the order given here.
struct FilmSet : FoamRecord {
  struct Film {
    Index start = kNone;     ///< junction
    Index end = kNone;       ///< junction
    std::int64_t left = -1;  ///< BubbleId on the left of the walk from start to end; −1 = outside
    std::int64_t right = -1; ///< BubbleId on the right
    double half_angle = 0;   ///< rad, > 0 where the film bulges to the right
    Wrap wrap;               ///< periods from start to end; (0, 0) unless Periodic

    friend bool operator==(const Film&, const Film&) = default;
  };
  struct Bubble {
    std::int64_t id = 0;
    double pressure = 0;    ///< N/cm²
    double target_area = 0; ///< cm²

    friend bool operator==(const Bubble&, const Bubble&) = default;
  };

  std::vector<Vec2> junctions; ///< cm
  std::vector<Film> films;
  std::vector<double> tensions;    ///< of the films, N/cm; empty where all have 2γ
  std::vector<Bubble> bubbles;     ///< in ascending order of id
  std::vector<Exterior> exteriors; ///< the outsides; empty stands for what goes with the boundary
  std::vector<WallPiece> wall_pieces; ///< of the outsides in turn; without them the films beside
                                      ///< the outside of a Fixed foam are its wall

  friend bool operator==(const FilmSet&, const FilmSet&) = default;
};

/// The films of a foam, compacted. Their order is that of the foam's films.
FilmSet film_set(const Foam& foam);

/// The foam of a list of films. A function of the list alone: the same list gives the same foam,
/// bit for bit, and film_set(foam_of(list)) is the list. \throws FoamError if the films do not make
/// a valid foam, or a junction cannot hold the tensions of its films; the message names the
/// element.
Foam foam_of(const FilmSet& set);

} // namespace foam
