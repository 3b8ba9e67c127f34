// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/statistics.h"

#include <limits>

#include "parallel/host.h"
#include "statistics/parallel_statistics.h"

namespace foam {
namespace {

constexpr double kUndefined = std::numeric_limits<double>::quiet_NaN();

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

FoamStatistics averages(const std::vector<SideSums>& by_sides) {
  double count = 0;
  double sides = 0;
  double sides_from_six_squared = 0;
  double area = 0;
  double area_squared = 0;
  for (const SideSums& sums : by_sides) {
    const double n = sums.sides;
    count += sums.count;
    sides += n * sums.count;
    sides_from_six_squared += (n - 6) * (n - 6) * sums.count;
    area += sums.area;
    area_squared += sums.area_squared;
  }
  const auto mean = [&](double sum) { return count > 0 ? sum / count : kUndefined; };

  FoamStatistics result;
  result.bubbles = static_cast<Index>(count);
  result.mean_sides = mean(sides);
  result.mu2 = mean(sides_from_six_squared);
  result.mean_area = mean(area);
  result.area_second_moment = mean(area_squared) / (result.mean_area * result.mean_area);
  for (const SideSums& sums : by_sides) {
    result.by_sides.push_back({sums.sides, sums.count, sums.count / count,
                               sums.neighbour_sides / sums.count,
                               sums.area / sums.count / result.mean_area});
  }
  result.aboav = aboav_parameter(result.by_sides, result.mean_sides);
  return result;
}

FoamStatistics statistics(const Foam& foam, bool include_boundary) {
  Host host;
  return ParallelStatistics<Host>(host).measure(view_of(foam), BubbleNames<Host>(foam.bubble_id),
                                                include_boundary);
}

} // namespace foam
