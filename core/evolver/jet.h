// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <limits>

#include "geometry/vec2.h"

namespace foam::evolver {

/// A function of two variables in one point, with its derivatives up to the second.
struct Jet {
  double value = 0;
  Vec2 gradient{};
  double xx = 0, xy = 0, yy = 0; ///< second derivatives

  static Jet x(double value) { return {value, {1, 0}}; }
  static Jet y(double value) { return {value, {0, 1}}; }
  /// Of a function of which nothing is known.
  static Jet unknown() {
    constexpr double kUnknown = std::numeric_limits<double>::quiet_NaN();
    return {kUnknown, {kUnknown, kUnknown}, kUnknown, kUnknown, kUnknown};
  }

  bool is_constant() const { return gradient == Vec2{} && xx == 0 && xy == 0 && yy == 0; }

  friend Jet operator+(const Jet& a, const Jet& b) {
    return {a.value + b.value, a.gradient + b.gradient, a.xx + b.xx, a.xy + b.xy, a.yy + b.yy};
  }
  friend Jet operator-(const Jet& a) { return {-a.value, -1 * a.gradient, -a.xx, -a.xy, -a.yy}; }
  friend Jet operator-(const Jet& a, const Jet& b) { return a + (-b); }
  friend Jet operator*(const Jet& a, const Jet& b) {
    const Vec2 u = a.gradient;
    const Vec2 v = b.gradient;
    return {a.value * b.value, a.value * v + b.value * u,
            a.value * b.xx + 2 * u.x * v.x + a.xx * b.value,
            a.value * b.xy + u.x * v.y + u.y * v.x + a.xy * b.value,
            a.value * b.yy + 2 * u.y * v.y + a.yy * b.value};
  }
};

/// f(u) by the chain rule. \param f, f1, f2 the value and the derivatives of f in u
inline Jet composed(const Jet& u, double f, double f1, double f2) {
  if (u.is_constant()) {
    return {f};
  }
  const Vec2 g = u.gradient;
  return {f, f1 * g, f1 * u.xx + f2 * g.x * g.x, f1 * u.xy + f2 * g.x * g.y,
          f1 * u.yy + f2 * g.y * g.y};
}

inline Jet operator/(const Jet& a, const Jet& b) {
  const double inverse = 1 / b.value;
  return a * composed(b, inverse, -inverse * inverse, 2 * inverse * inverse * inverse);
}

} // namespace foam::evolver
