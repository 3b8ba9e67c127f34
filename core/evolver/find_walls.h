// SPDX-License-Identifier: GPL-3.0-or-later
//
// Walls in Surface Evolver's files: edges that keep to a CONSTRAINT or a BOUNDARY, or are FIXED,
// with bubbles on one side at most.
#pragma once

#include <array>
#include <string>
#include <vector>

#include "evolver/datafile.h"
#include "mesh/foam.h"

namespace foam::evolver {

struct WallsOfDatafile {
  std::vector<Wall> walls;     ///< with the foam on their left, the container first
  std::vector<Index> of_edge;  ///< the wall that an edge is part of, kNone of films
  std::vector<bool> of_vertex; ///< whether a vertex belongs to a wall
  std::vector<std::string> warnings;
};

/// Whether an edge keeps to a curve or to its place: it is FIXED, or on a curve of its own, or of
/// both of its ends.
bool is_held(const Datafile& file, const Datafile::Edge& edge);

/// Edges in which faces are open, as where areas are completed by CONTENT: along the curves that
/// the ends keep to, round one corner at most. \throws FoamError with line and cause, if the gap is
/// none along walls
void close_faces(Datafile& file);

/// \param beside whether there is a bubble on the left and on the right of each edge
/// \throws FoamError with line and cause for what is no wall that encloses the foam, or lies in it
WallsOfDatafile find_walls(const Datafile& file, const std::vector<std::array<bool, 2>>& beside);

} // namespace foam::evolver
