// SPDX-License-Identifier: GPL-3.0-or-later
//
// A foam's statistics as reductions, on any executor (parallel/host.h).
#pragma once

#include <algorithm>
#include <limits>
#include <vector>

#include "parallel/kernels.h"
#include "statistics/bubble_records.h"
#include "statistics/statistics.h"
#include "statistics/stress.h"

namespace foam {

/// Sums over the bubbles with n sides that count in the averages.
struct SideSums {
  static constexpr Index kNoMore = std::numeric_limits<Index>::max();

  Index sides = 0; ///< n
  Index count = 0;
  double area = 0;            ///< ΣA, cm²
  double area_squared = 0;    ///< ΣA², cm⁴
  double neighbour_sides = 0; ///< Σ of the means of each one's neighbours
  Index next = kNoMore;       ///< the least n above this one that occurs
};

/// The figures that follow from sums: all of them but the energy and each bubble's.
/// \param by_sides in ascending order of n.
FoamStatistics averages(const std::vector<SideSums>& by_sides);

namespace detail {

/// What a bubble adds to the sums for n.
struct AddToSides {
  ConstFoamView mesh;
  const Bubble* bubbles = nullptr;
  const BubbleStatistics* records = nullptr;
  bool include_boundary = false;
  Index sides = 0; ///< n

  FOAM_HOST_DEVICE SideSums operator()(Index i) const {
    const BubbleStatistics& bubble = records[i];
    SideSums sums;
    sums.sides = sides;
    if (!include_boundary && bubble.on_boundary) {
      return sums;
    }
    if (bubble.sides == sides) {
      sums.count = 1;
      sums.area = bubble.area;
      sums.area_squared = bubble.area * bubble.area;
      sums.neighbour_sides = mean_neighbour_sides(bubbles[i]);
    } else if (bubble.sides > sides) {
      sums.next = bubble.sides;
    }
    return sums;
  }

  /// NaN without neighbours.
  FOAM_HOST_DEVICE double mean_neighbour_sides(Bubble bubble) const {
    double sum = 0;
    double count = 0;
    for_each_half(mesh, bubble, [&](Half h) {
      if (!mesh.right(h).is_outside()) {
        sum += mesh.sides[mesh.right(h)];
        ++count;
      }
    });
    return sum / count;
  }
};

struct AddSums {
  FOAM_HOST_DEVICE SideSums operator()(const SideSums& a, const SideSums& b) const {
    return {a.sides,
            a.count + b.count,
            a.area + b.area,
            a.area_squared + b.area_squared,
            a.neighbour_sides + b.neighbour_sides,
            std::min(a.next, b.next)};
  }
};

} // namespace detail

template <class Executor> class ParallelStatistics {
public:
  explicit ParallelStatistics(Executor& executor) : executor_(executor), records_(executor) {}

  /// statistics() of the foam: one reduction over the bubbles for each n that occurs.
  FoamStatistics measure(const ConstFoamView& mesh, const BubbleNames<Executor>& names,
                         bool include_boundary) {
    records_.measure(mesh, names);
    const auto sums_with = [&](Index n) {
      SideSums zero;
      zero.sides = n;
      return executor_.reduce(
          records_.count(), zero,
          detail::AddToSides{mesh, records_.bubbles(), records_.records(), include_boundary, n},
          detail::AddSums{});
    };
    std::vector<SideSums> by_sides;
    for (Index n = sums_with(0).next; n != SideSums::kNoMore; n = by_sides.back().next) {
      by_sides.push_back(sums_with(n));
    }
    FoamStatistics result = averages(by_sides);
    result.energy = records_.energy(mesh);
    result.each = records_.fetch_records();
    result.stress = mean_stress(result.each);
    return result;
  }

private:
  Executor& executor_;
  BubbleRecords<Executor> records_;
};

} // namespace foam
