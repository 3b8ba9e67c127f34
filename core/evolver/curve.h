// SPDX-License-Identifier: GPL-3.0-or-later
//
// Lines and circles, as Surface Evolver's constraints and boundaries give them.
#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "evolver/jet.h"
#include "geometry/vec2.h"

namespace foam::evolver {

/// A straight line or a circle.
struct Curve {
  Vec2 point;           ///< on it
  Vec2 tangent;         ///< there, of length 1
  double curvature = 0; ///< by which it turns to the left, 1/length

  /// The length over which it is looked at: a circle's radius, or how far out a line's point is.
  double scale() const;
  /// How far a point lies from it, > 0 on its left.
  double distance(Vec2 from) const;
  /// \pre it is a circle
  Vec2 centre() const { return point + (1 / curvature) * left_normal(tangent); }
  /// The direction from the curve to its left, where it is nearest to a point; of length 1.
  Vec2 normal(Vec2 near) const;
  /// The nearest point of it.
  Vec2 nearest(Vec2 to) const { return to - distance(to) * normal(to); }
  /// At a distance along it from its point.
  Vec2 at(double way) const;
};

/// The line or circle on which a function vanishes, beginning where that is near a place; none if
/// it vanishes on no such curve.
std::optional<Curve> curve_of_formula(const std::function<Jet(Vec2)>& formula, Vec2 near);

/// The line or circle that a parameter runs along; none if it is none.
/// \param x, y of the parameter, which is the jets' first variable
std::optional<Curve> curve_of_parameter(const std::function<Jet(double)>& x,
                                        const std::function<Jet(double)>& y, double parameter);

/// Where two curves cross: in none, one or two points; none where they only touch.
std::vector<Vec2> crossings(const Curve& a, const Curve& b);

} // namespace foam::evolver
