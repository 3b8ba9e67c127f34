// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a step of Newton's method does to one film, and how much of it the film can take.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

#include "geometry/arc.h"

namespace foam {

inline constexpr double kLargestTurn = 0.5; ///< rad that an arc may turn in one step
/// By which a junction may move in a step that is limited everywhere, of its shortest film.
inline constexpr double kLargestMove = 0.3;

/// Change of an arc's length to first order, cm. \param chord cm, and its change; \param alpha
/// half-angle, rad, and its change, turn.
FOAM_HOST_DEVICE inline double arc_growth(Vec2 chord, Vec2 change, double alpha, double turn) {
  const double d = norm(chord);
  const ArcShape shape = arc_shape(alpha);
  return shape.f * dot(chord, change) / d + d * shape.f1 * turn;
}

/// The most by which an arc may turn the way of `turn` in one step, rad.
FOAM_HOST_DEVICE inline double largest_turn(double alpha, double turn) {
  const double half_room = 0.5 * (std::numbers::pi - std::abs(alpha));
  return turn * alpha > 0 && half_room < kLargestTurn ? half_room : kLargestTurn;
}

/// The largest fraction ≤ 1 of a step with which the film shrinks or turns by no more than half of
/// its length, and its arc by no more than kLargestTurn and half of its way to a full circle.
FOAM_HOST_DEVICE inline double longest_film_step(Vec2 chord, Vec2 change, double alpha,
                                                 double turn) {
  const double d = norm(chord);
  const double growth = dot(chord, change) / d;
  const double across = std::abs(cross(chord, change)) / d;
  const double excess = std::max(-growth, across - 0.5 * std::max(growth, 0.0));
  double fraction = 1;
  if (excess > 0.5 * d) {
    fraction = 0.5 * d / excess;
  }
  if (fraction * std::abs(turn) > kLargestTurn) {
    fraction = kLargestTurn / std::abs(turn);
  }
  const double room = std::numbers::pi - std::abs(alpha);
  if (fraction * std::abs(turn) > 0.5 * room && turn * alpha > 0) {
    fraction = 0.5 * room / std::abs(turn);
  }
  return fraction;
}

} // namespace foam
