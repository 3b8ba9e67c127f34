// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a bubble's polygon is to be drawn.
#pragma once

#include <algorithm>

#include "geometry/vec2.h"
#include "mesh/ids.h"

namespace foam {

/// A closed polygon, read from one of its vertices on. Owns nothing.
struct Polygon {
  const Vec2* vertices = nullptr; ///< cm
  Index size = 0;
  Index first = 0;

  /// For 0 ≤ i ≤ size.
  FOAM_HOST_DEVICE Vec2 operator[](Index i) const {
    const Index k = first + i;
    return vertices[k < size ? k : k - size];
  }
};

/// Its centroid; its mean vertex if it has no area.
FOAM_HOST_DEVICE inline Vec2 centroid(const Polygon& polygon) {
  const Vec2 origin = polygon[0];
  double area = 0;
  Vec2 moment, sum;
  for (Index i = 0; i < polygon.size; ++i) {
    const Vec2 a = polygon[i] - origin;
    const Vec2 b = polygon[i + 1] - origin;
    const double w = cross(a, b) / 2;
    area += w;
    moment += (w / 3) * (a + b);
    sum += a;
  }
  const Vec2 mean = (1 / static_cast<double>(polygon.size)) * sum;
  return origin + (area > 0 ? (1 / area) * moment : mean);
}

/// The area by which a fan of triangles around the first vertex overlaps itself or leaves the
/// polygon.
FOAM_HOST_DEVICE inline double fan_error(const Polygon& polygon) {
  double error = 0;
  for (Index i = 1; i + 1 < polygon.size; ++i) {
    const Vec2 a = polygon[i] - polygon[0];
    const Vec2 b = polygon[i + 1] - polygon[0];
    error += std::max(0.0, -cross(a, b));
  }
  return error;
}

/// The polygon from the vertex on around which a fan of triangles covers it best: ParaView draws
/// polygons as fans, which leaves slivers along sides that are bent inwards. Of a polygon with very
/// many vertices not all are tried.
FOAM_HOST_DEVICE inline Polygon with_best_fan(Polygon polygon) {
  constexpr Index kFansTried = 512;
  const Index stride = 1 + polygon.size / kFansTried;
  Polygon best = polygon;
  double least = fan_error(polygon);
  for (polygon.first = stride; polygon.first < polygon.size && least > 0; polygon.first += stride) {
    const double error = fan_error(polygon);
    if (error < least) {
      best = polygon;
      least = error;
    }
  }
  return best;
}

} // namespace foam
