// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "geometry/arc.h"
#include "geometry/vec2.h"

namespace foam {

/// A piece of a wall, straight or circular, walked with the gas on its left: an arc as in
/// geometry/arc.h, of at most a half circle. Places on it are lengths from its start.
struct WallPiece {
  Vec2 start;            ///< cm
  Vec2 chord;            ///< to its end, cm
  double half_angle = 0; ///< rad, −π/2 to π/2; > 0 where the gas is inside the circle

  FOAM_HOST_DEVICE Vec2 end() const { return start + chord; }
  /// cm
  FOAM_HOST_DEVICE double length() const { return arc_length(norm(chord), half_angle); }
  /// By which its tangent turns to the left per length, 1/cm.
  FOAM_HOST_DEVICE double curvature() const { return arc_curvature(norm(chord), half_angle); }
  /// Of the circle that it lies on. \pre it is not straight
  FOAM_HOST_DEVICE Vec2 centre() const {
    return start + 0.5 * chord +
           (std::cos(half_angle) / curvature() / norm(chord)) * left_normal(chord);
  }
  FOAM_HOST_DEVICE Vec2 point(double place) const {
    return place == 0 ? start : arc_point(start, chord, half_angle, place / length());
  }
  /// Of length 1.
  FOAM_HOST_DEVICE Vec2 tangent(double place) const {
    return rotated((1 / norm(chord)) * chord, half_angle * (2 * place / length() - 1));
  }

  /// The place of a point of the piece.
  FOAM_HOST_DEVICE double place_of(Vec2 point) const {
    if (point == start) {
      return 0;
    }
    const Vec2 from_start = point - start;
    const Vec2 to_end = end() - point;
    if (half_angle == 0) {
      return dot(from_start, chord) / norm(chord);
    }
    // By the nearer end, of whose arc the chord is known.
    const double r = dot(from_start, from_start);
    const double s = dot(to_end, to_end);
    return r <= s ? length_of_chord(std::sqrt(r)) : length() - length_of_chord(std::sqrt(s));
  }

  /// How far a point lies from the piece, cm.
  FOAM_HOST_DEVICE double distance(Vec2 x) const {
    const Vec2 direction = (1 / norm(chord)) * chord;
    const Vec2 tangent = rotated(direction, -half_angle);
    const Vec2 last = rotated(direction, half_angle);
    if (dot(x - start, tangent) < 0 || dot(end() - x, last) < 0) {
      return std::min(norm(x - start), norm(x - end()));
    }
    const Vec2 r = x - start;
    const double k = curvature();
    const double value = dot(left_normal(tangent), r) - 0.5 * k * dot(r, r);
    return 2 * std::abs(value) / (1 + std::sqrt(std::max(1 - 2 * k * value, 0.0)));
  }

  friend bool operator==(const WallPiece&, const WallPiece&) = default;

private:
  /// Of the arc over a chord of the piece's circle, of at most half of the piece.
  FOAM_HOST_DEVICE double length_of_chord(double d) const {
    const double k = 0.5 * std::abs(curvature());
    return std::asin(std::min(k * d, 1.0)) / k;
  }
};

/// A circle in four quarters, the first from where x is largest. \param turn 1 counter-clockwise,
/// with the gas inside; −1 clockwise
inline std::array<WallPiece, 4> whole_circle(Vec2 centre, double radius, double turn) {
  const std::array<Vec2, 4> corners{centre + Vec2{radius, 0}, centre + Vec2{0, turn * radius},
                                    centre - Vec2{radius, 0}, centre - Vec2{0, turn * radius}};
  std::array<WallPiece, 4> pieces;
  for (std::size_t i = 0; i < 4; ++i) {
    pieces[i] = {corners[i], corners[(i + 1) % 4] - corners[i], turn * std::numbers::pi / 4};
  }
  return pieces;
}

} // namespace foam
