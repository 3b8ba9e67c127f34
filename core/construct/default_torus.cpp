// SPDX-License-Identifier: GPL-3.0-or-later
#include "construct/default_torus.h"

#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "construct/triangulation.h"
#include "geometry/bounds.h"

namespace foam {
namespace {

constexpr double kMargin = 2; // spacings from the bounds to points that know no seam
constexpr std::size_t kFew = 16;

/// By how much bounds are to grow to an area: (w + 2g)(h + 2g) = A, and not at all if they have
/// more than that.
double growth_to(const Bounds& bounds, double area) {
  const auto [width, height] = bounds.extent();
  const double half_sum = 0.5 * (width + height);
  const double missing = area - width * height;
  return missing > 0 ? 0.5 * missing / (half_sum + std::sqrt(half_sum * half_sum + missing)) : 0;
}

/// The growth by half a spacing m of a grid, where m² is the area that the grown rectangle has per
/// point: (N − 1)·m² − (w + h)·m − w·h = 0.
double half_spacing(const Bounds& bounds, std::size_t points) {
  const double others = static_cast<double>(points - 1);
  const auto [width, height] = bounds.extent();
  const double sum = width + height;
  const double product = width * height;
  return (sum + std::sqrt(sum * sum + 4 * others * product)) / (4 * others);
}

/// The mean area of points that lie so far inside the bounds that they know no seam, a third of
/// each triangle being each corner's. None if they are few.
std::optional<double> inner_area(std::span<const Vec2> points, const Bounds& bounds,
                                 double margin) {
  const auto inside = [&](Vec2 p) {
    return p.x > bounds.low.x + margin && p.x < bounds.high.x - margin &&
           p.y > bounds.low.y + margin && p.y < bounds.high.y - margin;
  };
  const auto count = static_cast<std::size_t>(std::ranges::count_if(points, inside));
  if (count < kFew) {
    return std::nullopt;
  }
  double area = 0;
  for (const Triangle& triangle : triangulate_plane(points)) {
    if (triangle[0].point.is_outside()) {
      continue;
    }
    const auto place = [&](std::size_t k) { return points[triangle[k].point.place()]; };
    const double third = cross(place(1) - place(0), place(2) - place(0)) / 6;
    for (std::size_t k = 0; k < 3; ++k) {
      area += inside(place(k)) ? third : 0;
    }
  }
  return area / static_cast<double>(count);
}

} // namespace

Lattice default_torus(std::span<const Vec2> points) {
  const Bounds bounds = bounds_of(points);
  const double half = half_spacing(bounds, points.size());
  const auto inner = inner_area(points, bounds, kMargin * 2 * half);
  const double by = inner ? growth_to(bounds, *inner * static_cast<double>(points.size())) : half;
  return Lattice::rectangle(bounds.low.x - by, bounds.high.x + by, bounds.low.y - by,
                            bounds.high.y + by);
}

} // namespace foam
