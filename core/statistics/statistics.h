// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include "geometry/tensor.h"
#include "mesh/foam.h"

namespace foam {

/// One bubble of a foam, measured.
struct BubbleStatistics {
  std::int64_t id = 0;
  double area = 0;        ///< cm²
  double target_area = 0; ///< cm²
  double pressure = 0;    ///< N/cm²
  Index sides = 0;
  double perimeter = 0; ///< cm
  bool on_boundary = false;
  SymmetricTensor stress; ///< σ, N/cm², tension positive; see statistics/stress.h
};

/// The bubbles with n sides.
struct SideStatistics {
  Index sides = 0;
  Index count = 0;
  double fraction = 0;             ///< p(n)
  double mean_neighbour_sides = 0; ///< m(n); no outside is a neighbour
  double mean_relative_area = 0;   ///< ⟨A_n⟩/⟨A⟩ (Lewis's law)
};

/// A foam in figures (thesis 2.6). Averages leave out bubbles beside an outside unless told
/// otherwise; energy and stress are the whole foam's. Averages over no bubble are NaN.
struct FoamStatistics {
  Index bubbles = 0;
  double mean_sides = 0;
  double mu2 = 0;                ///< second moment of p(n) about six, Σ(n − 6)² p(n)
  double mean_area = 0;          ///< cm²
  double area_second_moment = 0; ///< ⟨A²⟩/⟨A⟩²
  double energy = 0;             ///< N
  SymmetricTensor stress;        ///< of the whole foam, N/cm²; see statistics/stress.h
  double aboav = 0; ///< Aboav–Weaire's a, from a count-weighted linear fit of n·m(n)
  std::vector<SideStatistics> by_sides; ///< ascending, only n that occur
  std::vector<BubbleStatistics> each;   ///< in ascending order of id
};

/// \param include_boundary whether bubbles beside an outside count in the averages.
FoamStatistics statistics(const Foam& foam, bool include_boundary);

} // namespace foam
