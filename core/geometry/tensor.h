// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "geometry/vec2.h"

namespace foam {

/// A symmetric tensor of the plane: a stress, say.
struct SymmetricTensor {
  double xx = 0;
  double yy = 0;
  double xy = 0;

  FOAM_HOST_DEVICE SymmetricTensor& operator+=(const SymmetricTensor& b) {
    return *this = {xx + b.xx, yy + b.yy, xy + b.xy};
  }
  friend bool operator==(const SymmetricTensor& a, const SymmetricTensor& b) = default;
};

FOAM_HOST_DEVICE inline SymmetricTensor operator*(double s, const SymmetricTensor& a) {
  return {s * a.xx, s * a.yy, s * a.xy};
}
FOAM_HOST_DEVICE inline SymmetricTensor operator+(SymmetricTensor a, const SymmetricTensor& b) {
  return a += b;
}
FOAM_HOST_DEVICE inline SymmetricTensor operator-(SymmetricTensor a, const SymmetricTensor& b) {
  return a += -1 * b;
}
/// s·I.
FOAM_HOST_DEVICE inline SymmetricTensor isotropic(double s) {
  return {s, s, 0};
}
/// a⊗a.
FOAM_HOST_DEVICE inline SymmetricTensor square(Vec2 a) {
  return {a.x * a.x, a.y * a.y, a.x * a.y};
}
/// a⊗b + b⊗a.
FOAM_HOST_DEVICE inline SymmetricTensor twice_product(Vec2 a, Vec2 b) {
  return {2 * a.x * b.x, 2 * a.y * b.y, a.x * b.y + a.y * b.x};
}

/// A linear map of the plane: a deformation, or the gradient of a velocity.
struct Tensor {
  double xx = 0, xy = 0;
  double yx = 0, yy = 0;

  FOAM_HOST_DEVICE Vec2 operator*(Vec2 a) const {
    return {xx * a.x + xy * a.y, yx * a.x + yy * a.y};
  }
  friend bool operator==(const Tensor& a, const Tensor& b) = default;
};

/// exp(t·L), the deformation by a flow of gradient L after a time t. As L has no trace it keeps
/// areas, and L² = −det L·I, by Cayley and Hamilton.
inline Tensor exponential(double t, const Tensor& l) {
  const double square = l.xy * l.yx - l.xx * l.yy;
  const double root = std::sqrt(std::abs(square)) * t;
  const auto series = [&](double even, double odd) { // even·I + odd·t·L
    return Tensor{even + odd * t * l.xx, odd * t * l.xy, odd * t * l.yx, even + odd * t * l.yy};
  };
  if (square == 0 || root == 0) {
    return series(1, 1);
  }
  return square > 0 ? series(std::cosh(root), std::sinh(root) / root)
                    : series(std::cos(root), std::sin(root) / root);
}

} // namespace foam
