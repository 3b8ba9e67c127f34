// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lattice of a torus: two periods, which need not be at right angles.
#pragma once

#include <cmath>
#include <cstdint>

#include "geometry/vec2.h"

namespace foam {

/// How many periods lie between two places on a torus.
struct Wrap {
  std::int32_t x = 0; ///< of the lattice's first period
  std::int32_t y = 0; ///< of its second

  friend FOAM_HOST_DEVICE Wrap operator+(Wrap a, Wrap b) { return {a.x + b.x, a.y + b.y}; }
  friend FOAM_HOST_DEVICE Wrap operator-(Wrap a) { return {-a.x, -a.y}; }
  friend FOAM_HOST_DEVICE Wrap operator-(Wrap a, Wrap b) { return a + (-b); }
  friend FOAM_HOST_DEVICE bool operator==(Wrap a, Wrap b) { return a.x == b.x && a.y == b.y; }
};

/// The one place that knows a torus's images. Its cell is the parallelogram of the two periods at
/// the origin.
struct Lattice {
  Vec2 origin;        ///< a corner of the cell, cm
  Vec2 first, second; ///< the periods, cm, counter-clockwise; of a channel the second is 0

  static FOAM_HOST_DEVICE Lattice rectangle(double xmin, double xmax, double ymin, double ymax) {
    return {{xmin, ymin}, {xmax - xmin, 0}, {0, ymax - ymin}};
  }

  FOAM_HOST_DEVICE bool is_rectangle() const { return first.y == 0 && second.x == 0; }
  /// Area of the cell, cm².
  FOAM_HOST_DEVICE double area() const { return cross(first, second); }
  /// A wrap as a vector, cm.
  FOAM_HOST_DEVICE Vec2 period(Wrap w) const {
    return {w.x * first.x + w.y * second.x, w.x * first.y + w.y * second.y};
  }
  /// A place's coordinates in the cell: both in [0, 1) for places in it.
  FOAM_HOST_DEVICE Vec2 coordinates(Vec2 place) const {
    const Vec2 r = place - origin;
    if (is_rectangle()) {
      return {r.x / first.x, second.y == 0 ? 0 : r.y / second.y};
    }
    return {cross(r, second) / area(), cross(first, r) / area()};
  }
  /// How many periods a place lies from the cell.
  FOAM_HOST_DEVICE Wrap cell_of(Vec2 place) const {
    const Vec2 c = coordinates(place);
    return {static_cast<std::int32_t>(std::floor(c.x)), static_cast<std::int32_t>(std::floor(c.y))};
  }

  friend bool operator==(const Lattice& a, const Lattice& b) = default;
};

/// Another basis of a lattice's points: wraps by the old periods become wraps by the new ones.
struct ReducedLattice {
  Lattice lattice;
  std::int32_t xx = 1, xy = 0, yx = 0, yy = 1; ///< determinant 1

  Wrap wrap(Wrap w) const { return {xx * w.x + xy * w.y, yx * w.x + yy * w.y}; }
  /// Back again.
  Wrap original(Wrap w) const { return {yy * w.x - xy * w.y, xx * w.y - yx * w.x}; }
};

/// The same lattice by its shortest periods (Lagrange's and Gauss's reduction): the angle between
/// them lies between 60° and 120°. What is that already stays as it is.
inline ReducedLattice reduced(const Lattice& lattice) {
  // How often b is to be taken from a; not for a tie, which would go back and forth.
  const auto times = [](Vec2 a, Vec2 b) {
    const double ratio = dot(a, b) / dot(b, b);
    return std::abs(ratio) > 0.5 * (1 + 1e-9) ? static_cast<std::int32_t>(std::lround(ratio)) : 0;
  };
  ReducedLattice result{lattice};
  Vec2& a = result.lattice.first;
  Vec2& b = result.lattice.second;
  while (true) { // of w.x·a + w.y·b one factor changes where the other's period does
    if (const auto n = times(a, b); dot(a, a) > dot(b, b) && n != 0) {
      a -= n * b;
      result.yx += n * result.xx;
      result.yy += n * result.xy;
    } else if (const auto m = times(b, a); m != 0) {
      b -= m * a;
      result.xx += m * result.yx;
      result.xy += m * result.yy;
    } else {
      return result;
    }
  }
}

} // namespace foam
