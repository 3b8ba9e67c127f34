// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <numbers>
#include <span>

#include "geometry/wall_piece.h"

namespace foam {

/// How often a closed loop of arcs winds round a point to the left.
inline int winding(std::span<const WallPiece> loop, Vec2 point) {
  double turn = 0;
  int in_segments = 0;
  for (const WallPiece& arc : loop) {
    turn += angle_from_to(arc.start - point, arc.end() - point);
    if (const double curvature = arc.curvature(); curvature != 0) {
      const double side = cross(arc.chord, point - arc.start); // > 0: on the left of the chord
      if (norm(point - arc.centre()) * std::abs(curvature) < 1 && side * arc.half_angle < 0) {
        in_segments += arc.half_angle > 0 ? 1 : -1;
      }
    }
  }
  return static_cast<int>(std::lround(turn / (2 * std::numbers::pi))) + in_segments;
}

} // namespace foam
