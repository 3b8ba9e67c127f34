// SPDX-License-Identifier: GPL-3.0-or-later
//
// How films that are left without a junction go on along their arcs.
#pragma once

#include <array>
#include <cmath>

#include "geometry/vec2.h"
#include "mesh/walls.h"

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

/// Where a circle cuts a stretch of a wall, whose ends lie on either side of it; the middle of the
/// stretch if they do not.
template <class Mesh>
FOAM_APART WallPlace cut_of_wall(const Mesh& mesh, const Circle& circle, Half stretch) {
  const auto value = [&](double distance) {
    return circle.value(point_of(mesh, mesh.place_on_stretch(stretch, distance)));
  };
  double inside = 0;
  double outside = mesh.length(stretch);
  const double sign = value(inside);
  double middle = 0.5 * outside;
  if (sign * value(outside) < 0) {
    constexpr int kBisections = 60; // to rounding
    for (int i = 0; i < kBisections; ++i) {
      (sign * value(middle) > 0 ? inside : outside) = middle;
      middle = 0.5 * (inside + outside);
    }
  }
  return mesh.place_on_stretch(stretch, middle);
}

} // namespace foam::detail
