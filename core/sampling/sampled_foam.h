// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "mesh/foam.h"
#include "statistics/statistics.h"
#include "statistics/wall_forces.h"

namespace foam {

using Point3 = std::array<double, 3>; ///< cm; VTK's points have three coordinates, the last is 0

/// A foam's films, a polyline for each, in the order of film_set(); then the pieces of walls on
/// which no film ends, with no junctions. The first points are the
/// junctions, which films share. A film that crosses the border of a torus's cell ends in a point
/// of its own, a whole number of periods from its junction. Points inside arcs follow, each of one
/// film alone.
struct FilmPolylines {
  std::vector<Point3> points;
  std::vector<std::int64_t> junction_id;  ///< of each point; −1 inside an arc
  std::vector<std::int64_t> offsets;      ///< of each film's points in connectivity; its length
  std::vector<std::int64_t> connectivity; ///< the points, from start to end

  // Of each film, as seen from its start.
  std::vector<std::int64_t> left, right;   ///< BubbleId, or below 0 an outside
  std::vector<double> curvature;           ///< 1/cm, > 0 where the film bulges to the right
  std::vector<double> pressure_difference; ///< of the left bubble over the right one, N/cm²
  std::vector<double> length;              ///< cm
  std::vector<double> half_angle;          ///< rad
  std::vector<double> tension;             ///< N/cm; empty where all have 2γ
  std::vector<int> on_boundary;            ///< 1 where a side is an outside
  std::vector<int> kind;                   ///< 1 of a stretch of a wall; empty without walls
};

/// A foam's bubbles, a polygon for each in ascending order of id, counter-clockwise, in one piece
/// and, on a torus, with its centroid in the cell. Each begins where a fan of triangles covers it
/// best. No point is shared.
struct BubblePolygons {
  std::vector<Point3> points;
  std::vector<std::int64_t> offsets; ///< of each bubble's points; their number
  std::vector<BubbleStatistics> each;
};

/// A foam as it is shown: all that VTK's arrays hold of it.
struct SampledFoam {
  FoamRecord record;
  std::vector<Exterior> exteriors;    ///< the outsides
  std::vector<WallPiece> wall_pieces; ///< of the outsides in turn
  std::vector<WallForce> wall_forces; ///< on the outsides' walls
  double energy = 0;                  ///< N
  FilmPolylines films;
  BubblePolygons bubbles;
};

/// Of a foam that is sampled elsewhere.
void take_outsides(const Foam& foam, SampledFoam& sampled);

/// \param chord_error largest distance between an arc and its polyline, cm; 0 stands for 1/200 of
/// the mean spacing.
SampledFoam sample(const Foam& foam, double chord_error);

} // namespace foam
