// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

namespace foam {

/// A point or vector of the plane; cm when it is a position.
struct Vec2 {
  double x = 0;
  double y = 0;

  Vec2& operator+=(Vec2 b) { return *this = {x + b.x, y + b.y}; }
  Vec2& operator-=(Vec2 b) { return *this = {x - b.x, y - b.y}; }
  friend bool operator==(Vec2 a, Vec2 b) = default;
};

inline Vec2 operator+(Vec2 a, Vec2 b) {
  return {a.x + b.x, a.y + b.y};
}
inline Vec2 operator-(Vec2 a, Vec2 b) {
  return {a.x - b.x, a.y - b.y};
}
inline Vec2 operator-(Vec2 a) {
  return {-a.x, -a.y};
}
inline Vec2 operator*(double s, Vec2 a) {
  return {s * a.x, s * a.y};
}
inline double dot(Vec2 a, Vec2 b) {
  return a.x * b.x + a.y * b.y;
}
inline double cross(Vec2 a, Vec2 b) {
  return a.x * b.y - a.y * b.x;
}
inline double norm(Vec2 a) {
  return std::sqrt(dot(a, a));
}
/// The vector turned 90° to the left.
inline Vec2 left_normal(Vec2 a) {
  return {-a.y, a.x};
}
inline Vec2 rotated(Vec2 a, double angle) {
  const double c = std::cos(angle);
  const double s = std::sin(angle);
  return {c * a.x - s * a.y, s * a.x + c * a.y};
}
/// The angle in (−π, π] that turns the direction of a into that of b.
inline double angle_from_to(Vec2 a, Vec2 b) {
  return std::atan2(cross(a, b), dot(a, b));
}

} // namespace foam
