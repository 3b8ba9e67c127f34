// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

namespace foam::filters {

/// The fewest sides that were measured.
inline constexpr int kFewestMeasuredSides = 3;

/// Fractions of bubbles with 3, 4, … 11 sides in a quasi-two-dimensional dry foam in the scaling
/// state, without those on the boundary: A. E. Roth, C. D. Jones, D. J. Durian, Bubble statistics
/// and coarsening dynamics for quasi-two-dimensional foams with increasing liquid content, Phys.
/// Rev. E 87, 042304 (2013). With their errors in sample-data/measured-sides.csv.
inline constexpr std::array kMeasuredSides{0.013, 0.083, 0.304, 0.316, 0.178,
                                           0.076, 0.022, 0.006, 0.0005};

} // namespace foam::filters
