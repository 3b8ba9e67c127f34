// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/statistics.h"

#include <algorithm>
#include <limits>
#include <map>

namespace foam {
namespace {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

double ratio(double sum, double count) {
  return count > 0 ? sum / count : kUndefined;
}

BubbleStatistics measure(const Foam& foam, Index bubble) {
  const auto i = Foam::size(bubble);
  BubbleStatistics result;
  result.id = foam.bubble_id[i];
  result.area = foam.area(bubble);
  result.target_area = foam.target_area[i];
  result.pressure = foam.pressure[i];
  result.sides = foam.sides[i];
  for_each_half(foam, bubble, [&](Index h) { result.perimeter += foam.length(h); });
  result.on_boundary = foam.bubble_on_world(bubble);
  return result;
}

/// Mean number of sides of a bubble's neighbours.
double neighbour_sides(const Foam& foam, Index bubble) {
  double sum = 0;
  double count = 0;
  for_each_half(foam, bubble, [&](Index h) {
    if (foam.right(h) != kWorld) {
      sum += foam.sides[Foam::size(foam.right(h))];
      ++count;
    }
  });
  return ratio(sum, count);
}

/// Sums over bubbles.
struct Sums {
  double count = 0;
  double sides = 0;
  double sides_from_six_squared = 0;
  double area = 0;
  double area_squared = 0;
  double neighbour_sides = 0;

  void add(double n, double a, double m) {
    ++count;
    sides += n;
    sides_from_six_squared += (n - 6) * (n - 6);
    area += a;
    area_squared += a * a;
    neighbour_sides += m;
  }
};

/// a of n·m(n) = (6 − a)·n + 6a + μ₂ (thesis 2.6.2) by least squares, each bubble counted once.
double aboav_parameter(const std::vector<SideStatistics>& by_sides, double mean_sides) {
  double product_mean = 0;
  for (const auto& row : by_sides) {
    product_mean += row.fraction * row.sides * row.mean_neighbour_sides;
  }
  double covariance = 0;
  double variance = 0;
  for (const auto& row : by_sides) {
    const double n = row.sides - mean_sides;
    covariance += row.fraction * n * (row.sides * row.mean_neighbour_sides - product_mean);
    variance += row.fraction * n * n;
  }
  return by_sides.size() < 2 ? kUndefined : 6 - covariance / variance;
}

} // namespace

FoamStatistics statistics(const Foam& foam, bool include_boundary) {
  FoamStatistics result;
  Sums all;
  std::map<Index, Sums> with_sides;
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    if (!foam.has_bubble(b)) {
      continue;
    }
    const BubbleStatistics bubble = measure(foam, b);
    result.each.push_back(bubble);
    if (include_boundary || !bubble.on_boundary) {
      const double m = neighbour_sides(foam, b);
      all.add(bubble.sides, bubble.area, m);
      with_sides[bubble.sides].add(bubble.sides, bubble.area, m);
    }
  }
  std::sort(result.each.begin(), result.each.end(),
            [](const auto& a, const auto& b) { return a.id < b.id; });

  result.bubbles = static_cast<Index>(all.count);
  result.mean_sides = ratio(all.sides, all.count);
  result.mu2 = ratio(all.sides_from_six_squared, all.count);
  result.mean_area = ratio(all.area, all.count);
  result.area_second_moment =
      ratio(all.area_squared, all.count) / (result.mean_area * result.mean_area);
  result.energy = foam.energy();
  for (const auto& [n, sums] : with_sides) {
    result.by_sides.push_back({n, static_cast<Index>(sums.count), sums.count / all.count,
                               sums.neighbour_sides / sums.count,
                               sums.area / sums.count / result.mean_area});
  }
  result.aboav = aboav_parameter(result.by_sides, result.mean_sides);
  return result;
}

} // namespace foam
