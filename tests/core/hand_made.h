// SPDX-License-Identifier: GPL-3.0-or-later
//
// Foams made by hand for tests.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "construct/from_points.h"
#include "mesh/film_set.h"
#include "mesh/validate.h"

namespace foam {

inline void expect_valid(const Foam& foam) {
  const auto problems = validate(foam);
  EXPECT_TRUE(problems.empty()) << problems.front();
}

/// A free foam of bubbles with straight films, each given by its junctions, counter-clockwise. What
/// lies outside is the world. Target areas are the areas; bubble i has id i.
inline Foam foam_of_polygons(const std::vector<Vec2>& junctions,
                             const std::vector<std::vector<Index>>& polygons) {
  FilmSet set;
  set.junctions = junctions;
  set.surface_tension = 0.25;
  std::map<std::pair<Index, Index>, std::int64_t> left;
  for (std::size_t b = 0; b < polygons.size(); ++b) {
    set.bubbles.push_back({static_cast<std::int64_t>(b), 0, 1});
    for (std::size_t k = 0; k < polygons[b].size(); ++k) {
      left[{polygons[b][k], polygons[b][(k + 1) % polygons[b].size()]}] =
          static_cast<std::int64_t>(b);
    }
  }
  for (const auto& [edge, bubble] : left) {
    const auto other = left.find({edge.second, edge.first});
    if (other == left.end() || edge.first < edge.second) {
      set.films.push_back(
          {edge.first, edge.second, bubble, other == left.end() ? -1 : other->second, 0, {}});
    }
  }
  Foam foam = foam_of(set);
  for (const Bubble b : foam.bubble_slots()) {
    foam.target_area[b] = foam.area(b);
  }
  return foam;
}

/// The points of a honeycomb of columns × 2·pairs bubbles with centres at distance 1.
inline std::vector<Vec2> honeycomb_points(Index columns, Index pairs) {
  std::vector<Vec2> points;
  for (Index row = 0; row < 2 * pairs; ++row) {
    for (Index column = 0; column < columns; ++column) {
      points.push_back({column + 0.25 + 0.5 * (row % 2), (row + 0.5) * std::sqrt(0.75)});
    }
  }
  return points;
}

/// A perfect honeycomb on a torus.
inline Foam honeycomb(Index columns, Index pairs) {
  BuildOptions options;
  options.boundary = Boundary::Periodic;
  options.torus = Lattice::rectangle(0, static_cast<double>(columns), 0,
                                     2 * static_cast<double>(pairs) * std::sqrt(0.75));
  return build_from_points(honeycomb_points(columns, pairs), options);
}

} // namespace foam
