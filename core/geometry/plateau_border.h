// SPDX-License-Identifier: GPL-3.0-or-later
//
// Plateau borders on a dry foam. The decoration theorem (F. Bolton and D. Weaire, The effects of
// Plateau borders in the two-dimensional soap froth, Phil. Mag. B 63 (1991) 795): where films of an
// equilibrated foam meet, small borders can be put on them, whose sides are arcs tangent to the
// films, and the foam stays in equilibrium, the films being where they were.
//
// The proof makes the construction (M. Mancini and C. Oguey, Eur. Phys. J. E 17 (2005) 119): a
// Möbius transformation keeps circles and angles. With the junction in the origin of the complex
// plane, z = w/(1 − b·w) takes the straight ray w = s·t, s ≥ 0, to an arc with the same unit
// tangent t and the curvature 2 Im(b·t). Two arcs that leave the junction give b, and the border's
// side is the image of the circle of the given radius that touches the two rays.
#pragma once

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <optional>

#include "geometry/vec2.h"

namespace foam {

/// A film as it leaves a junction.
struct FilmAtJunction {
  Vec2 tangent;         ///< unit vector
  double curvature = 0; ///< 1/cm, > 0 where the film turns to the left
};

/// One side of a Plateau border: a circle that bounds the gas between two films.
struct BorderSide {
  Vec2 centre; ///< cm, from the junction
  double radius = 0;
};

/// The side of a Plateau border between two films, the second of which lies to the left of the
/// first, between 0 and 180° away; none if it is not. `radius` (cm) is that of a side between
/// straight films, γ over the pressure difference of gas and liquid. A side touches its films no
/// further than `reach` (cm) from the junction: it is made smaller to keep to that.
inline std::optional<BorderSide> border_side(const FilmAtJunction& first,
                                             const FilmAtJunction& second, double radius,
                                             double reach) {
  using Complex = std::complex<double>;
  const double sine = cross(first.tangent, second.tangent);
  const double angle = angle_from_to(first.tangent, second.tangent);
  constexpr double kLeastAngle = 0.02; // rad from touching or opposite films, which have no side
  if (angle < kLeastAngle || angle > std::numbers::pi - kLeastAngle) {
    return std::nullopt;
  }
  // The b with 2 Im(b·t) = curvature of either film.
  const Complex t1(first.tangent.x, first.tangent.y);
  const Complex t2(second.tangent.x, second.tangent.y);
  const Complex b =
      (second.curvature * std::conj(t1) - first.curvature * std::conj(t2)) / (2 * sine);
  // Where the map is far from its pole, 1 − b·w = 0.
  constexpr double kLargestBend = 0.5;
  const double furthest = std::min(reach, kLargestBend / std::max(std::abs(b), 1e-300));
  const double r = std::min(radius, furthest * std::tan(angle / 2));
  if (!(r > 0)) {
    return std::nullopt;
  }
  const Complex centre = r / std::sin(angle / 2) * (t1 + t2) / std::abs(t1 + t2);
  // |w − centre| = r with w = z/(1 + b·z) is k·|z|² − 2 Re(g·z) + |centre|² − r² = 0.
  const Complex g = std::conj(centre) * (1.0 - centre * b) + r * r * b;
  const double k = std::norm(1.0 - centre * b) - r * r * std::norm(b);
  const Complex image = std::conj(g) / k;
  return BorderSide{{image.real(), image.imag()}, r / k};
}

} // namespace foam
