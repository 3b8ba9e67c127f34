// SPDX-License-Identifier: GPL-3.0-or-later
// Foams in containers.
#pragma once

#include <numeric>
#include <string>
#include <utility>
#include <vector>

#include "construct/containers.h"
#include "foams.h"
#include "geometry/bounds.h"

namespace foam::test {

/// Of the line tension 1, in equilibrium.
inline Foam filled(const Container& container, const std::vector<Vec2>& points,
                   const std::vector<double>& areas = {}) {
  BuildOptions options;
  options.boundary = Boundary::Container;
  options.container = container;
  options.surface_tension = 0.5;
  options.target_areas = areas.empty() ? TargetAreas::Initial : TargetAreas::Array;
  options.target_area_array = areas;
  Foam foam = build_from_points(points, options);
  expect_valid(foam);
  equilibrate(foam, 1e-12);
  expect_valid(foam);
  return foam;
}

/// Points at random inside, no two nearer than half of what they have room for.
inline std::vector<Vec2> points_in(const Container& container, Index count, std::uint64_t seed) {
  Bounds bounds;
  double area = 0;
  for (const Wall& wall : container.walls) {
    for (const WallPiece& piece : wall.pieces) {
      bounds = bounds + Bounds{piece.start, piece.start} + Bounds{piece.end(), piece.end()};
      area +=
          0.5 * cross(piece.start, piece.chord) + segment_area(norm(piece.chord), piece.half_angle);
    }
  }
  if (container.period > 0) {
    area = container.period * bounds.extent().y;
  }
  Random random(seed);
  const double apart = 0.6 * std::sqrt(area / count);
  std::vector<Vec2> points;
  const auto near = [&](Vec2 p) {
    return std::ranges::any_of(points, [&](Vec2 q) {
      for (const double shift : {-container.period, 0.0, container.period}) {
        if (norm(p + Vec2{shift, 0} - q) < apart) {
          return true;
        }
      }
      return false;
    });
  };
  while (static_cast<Index>(points.size()) < count) {
    const Vec2 p{bounds.low.x + random.uniform() * bounds.extent().x,
                 bounds.low.y + random.uniform() * bounds.extent().y};
    if (is_inside(container, p) && !near(p)) {
      points.push_back(p);
    }
  }
  return points;
}

inline Foam random_foam_in(const Container& container, Index bubbles, std::uint64_t seed) {
  return filled(container, points_in(container, bubbles, seed));
}

/// One of each shape, with slipping films.
inline std::vector<std::pair<std::string, Container>> containers() {
  return {{"rectangle", rectangle({0, 3, 0, 2}, WallContact::Slip)},
          {"disc", disc({-1, 1, -1, 1}, WallContact::Slip)},
          {"annulus", annulus({-2, 2, -2, 2}, 0.7, WallContact::Slip)},
          {"channel", channel({0, 4, 0, 2}, WallContact::Slip)},
          {"an L with a square in it", outline({{{{0, 0}, {4, 0}, {4, 2}, {2, 2}, {2, 4}, {0, 4}},
                                                 {{0.7, 0.7}, {1.4, 0.7}, {1.4, 1.4}, {0.7, 1.4}}}},
                                               WallContact::Slip)}};
}

} // namespace foam::test
