// SPDX-License-Identifier: GPL-3.0-or-later
//
// How films that are left without a junction go on along their arcs.
#pragma once

#include <array>
#include <cmath>

#include "geometry/vec2.h"

namespace foam::detail {

/// The half-angle of a film after its start has moved while its end, and its direction there,
/// stayed. Straight where that is no prolongation: the start has moved past the end, or all around.
FOAM_HOST_DEVICE inline double prolonged_half_angle(double half_angle, Vec2 old_chord,
                                                    Vec2 new_chord) {
  constexpr double kWidest = 3;
  const double prolonged = half_angle - angle_from_to(old_chord, new_chord);
  return dot(old_chord, new_chord) > 0 && std::abs(prolonged) < kWidest ? prolonged : 0;
}

/// A circle (or line) through a point, by tangent and curvature; > 0 bends to the left.
struct Circle {
  Vec2 point, tangent;
  double curvature = 0;

  /// Zero on the circle; its gradient has unit length there.
  FOAM_HOST_DEVICE double value(Vec2 x) const {
    const Vec2 r = x - point;
    return dot(left_normal(tangent), r) - 0.5 * curvature * dot(r, r);
  }
  FOAM_HOST_DEVICE Vec2 gradient(Vec2 x) const {
    return left_normal(tangent) - curvature * (x - point);
  }
};

/// The common point of three circles nearest to `start`, by Gauss–Newton on their equations, which
/// leads to the point nearest to them in the sense of least squares if they have none in common;
/// `start` itself where that is not found within `size` of it.
FOAM_HOST_DEVICE inline Vec2 common_point(const std::array<Circle, 3>& circles, Vec2 start,
                                          double size) {
  Vec2 x = start;
  for (int iteration = 0; iteration < 32; ++iteration) {
    double a = 0, b = 0, c = 0;
    Vec2 rhs;
    for (const Circle& circle : circles) {
      const Vec2 g = circle.gradient(x);
      a += g.x * g.x;
      b += g.x * g.y;
      c += g.y * g.y;
      rhs -= circle.value(x) * g;
    }
    const double determinant = a * c - b * b;
    if (!(determinant > 1e-6)) {
      return start;
    }
    const Vec2 step{(c * rhs.x - b * rhs.y) / determinant, (a * rhs.y - b * rhs.x) / determinant};
    x += step;
    if (norm(x - start) > size) {
      return start;
    }
    if (norm(step) < 1e-15 * size) {
      break;
    }
  }
  return x;
}

/// The one contact that replaces the middle two of four along a wall, so that the container keeps
/// its area.
FOAM_HOST_DEVICE inline Vec2 merged_contact(const std::array<Vec2, 4>& wall) {
  const Vec2 base = wall[3] - wall[0];
  const Vec2 middle = 0.5 * (wall[1] + wall[2]) - wall[0];
  const double twice_area =
      cross(wall[1] - wall[0], wall[2] - wall[0]) + cross(wall[2] - wall[0], base);
  const double rise = (cross(middle, base) - twice_area) / dot(base, base);
  return wall[0] + middle + rise * left_normal(base);
}

} // namespace foam::detail
