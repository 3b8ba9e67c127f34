// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "geometry/host_device.h"

namespace foam {

/// A point or vector of the plane; cm when it is a position.
struct Vec2 {
  double x = 0;
  double y = 0;

  FOAM_HOST_DEVICE Vec2& operator+=(Vec2 b) { return *this = {x + b.x, y + b.y}; }
  FOAM_HOST_DEVICE Vec2& operator-=(Vec2 b) { return *this = {x - b.x, y - b.y}; }
  friend bool operator==(Vec2 a, Vec2 b) = default;
};

FOAM_HOST_DEVICE inline Vec2 operator+(Vec2 a, Vec2 b) {
  return {a.x + b.x, a.y + b.y};
}
FOAM_HOST_DEVICE inline Vec2 operator-(Vec2 a, Vec2 b) {
  return {a.x - b.x, a.y - b.y};
}
FOAM_HOST_DEVICE inline Vec2 operator-(Vec2 a) {
  return {-a.x, -a.y};
}
FOAM_HOST_DEVICE inline Vec2 operator*(double s, Vec2 a) {
  return {s * a.x, s * a.y};
}
FOAM_HOST_DEVICE inline double dot(Vec2 a, Vec2 b) {
  return a.x * b.x + a.y * b.y;
}
FOAM_HOST_DEVICE inline double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}
FOAM_HOST_DEVICE inline double norm(Vec2 a) {
  return std::sqrt(dot(a, a));
}
/// The vector turned 90° to the left.
FOAM_HOST_DEVICE inline Vec2 left_normal(Vec2 a) {
  return {-a.y, a.x};
}
FOAM_HOST_DEVICE inline Vec2 rotated(Vec2 a, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * a.x - s * a.y, s * a.x + c * a.y};
}
/// The angle in (−π, π] that turns the direction of a into that of b.
FOAM_HOST_DEVICE inline double angle_from_to(Vec2 a, Vec2 b) {
  return std::atan2(cross(a, b), dot(a, b));
}

} // namespace foam
