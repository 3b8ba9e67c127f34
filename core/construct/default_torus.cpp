// SPDX-License-Identifier: GPL-3.0-or-later
#include "construct/default_torus.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

#include "construct/triangulation.h"
#include "geometry/bounds.h"

namespace foam {
namespace {

constexpr double kSeam = 0.75; // spacings from the bounds to where points are no longer at the seam
constexpr double kMostAtSeam = 0.5; // of the points: with more of them there are no others
constexpr double kWidest = 2;       // spacings of a gap
constexpr double kPrecision = 1e-6; // spacings
constexpr int kMostRounds = 12;

/// A gap of a grid's spacing m, where m² is the area that the rectangle has per point:
/// (N − 1)·m² − (w + h)·m − w·h = 0.
double grid_spacing(Vec2 extent, std::size_t points) {
  const double others = static_cast<double>(points - 1);
  const double sum = extent.x + extent.y;
  const double product = extent.x * extent.y;
  return (sum + std::sqrt(sum * sum + 4 * others * product)) / (2 * others);
}

Lattice with_gaps(const Bounds& bounds, Vec2 gap) {
  return Lattice::rectangle(bounds.low.x - 0.5 * gap.x, bounds.high.x + 0.5 * gap.x,
                            bounds.low.y - 0.5 * gap.y, bounds.high.y + 0.5 * gap.y);
}

/// Each point's area on a torus: a third of each of its triangles.
Field<Bubble, double> areas_on(const Lattice& torus, std::span<const Vec2> points) {
  const TorusPoints sites = torus_points(points, torus);
  Field<Bubble, double> area(points.size(), 0);
  for (const Triangle& triangle : triangulate_torus(sites)) {
    const auto place = [&](std::size_t k) {
      return sites.position[triangle[k].point] + torus.period(triangle[k].copy);
    };
    const double third = cross(place(1) - place(0), place(2) - place(0)) / 6;
    for (const Corner& corner : triangle) {
      area[corner.point] += third;
    }
  }
  return area;
}

/// The points that lie near the low or the high end of one coordinate.
std::vector<Bubble> points_at_seam(std::span<const Vec2> points, double low, double high,
                                   double Vec2::*coordinate, double width) {
  std::vector<Bubble> result;
  for (const Bubble b : Slots<Bubble>(static_cast<Index>(points.size()))) {
    const double c = points[b.place()].*coordinate;
    if (std::min(c - low, high - c) < width) {
      result.push_back(b);
    }
  }
  return result;
}

} // namespace

Lattice default_torus(std::span<const Vec2> points) {
  const Bounds bounds = bounds_of(points);
  const Vec2 extent = bounds.extent();
  const auto count = static_cast<double>(points.size());
  const double spacing = grid_spacing(extent, points.size());
  struct Side {
    double Vec2::*along;
    double Vec2::*across;
    std::vector<Bubble> seam;
  };
  std::array<Side, 2> sides{Side{&Vec2::x, &Vec2::y, {}}, Side{&Vec2::y, &Vec2::x, {}}};
  Vec2 gap{spacing, spacing};
  for (Side& side : sides) {
    side.seam = points_at_seam(points, bounds.low.*side.along, bounds.high.*side.along, side.along,
                               kSeam * spacing);
    if (static_cast<double>(side.seam.size()) > kMostAtSeam * count) {
      return with_gaps(bounds, gap);
    }
  }
  double change = spacing;
  for (int round = 0; round < kMostRounds && change > kPrecision * spacing; ++round) {
    const Vec2 size = extent + gap;
    const Field<Bubble, double> area = areas_on(with_gaps(bounds, gap), points);
    const double mean = size.x * size.y / count;
    change = 0;
    for (const auto& [along, across, seam] : sides) {
      double excess = 0; // of area at the seam, which the gap is to lose
      for (const Bubble b : seam) {
        excess += area[b] - mean;
      }
      const double others = 1 - static_cast<double>(seam.size()) / count;
      const double before = gap.*along;
      gap.*along = std::clamp(before - excess / (others * size.*across),
                              extent.*along / (count - 1), kWidest * spacing);
      change = std::max(change, std::abs(gap.*along - before));
    }
  }
  return with_gaps(bounds, gap);
}

} // namespace foam
