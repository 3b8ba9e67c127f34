// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>

#include "mesh/elements.h"

namespace foam {

/// One film's share of a symmetric matrix.
struct FilmShare {
  std::array<Index, 7> unknown{}; ///< kNone where held
  std::array<double, 28> value{}; ///< lower triangle
};

/// The largest entry by magnitude between unknowns that are not held.
inline double largest_entry(const FilmShare& share) {
  double largest = 0;
  std::size_t k = 0;
  for (std::size_t row = 0; row < 7; ++row) {
    for (std::size_t column = 0; column <= row; ++column, ++k) {
      if (share.unknown[row] != kNone && share.unknown[column] != kNone) {
        largest = std::max(largest, std::abs(share.value[k]));
      }
    }
  }
  return largest;
}

/// from −= share · x, where x is the film's own.
inline void subtract_product(const FilmShare& share, const std::array<double, 7>& x,
                             std::span<double> from) {
  std::array<double, 7> force{};
  const std::size_t size = share.unknown.back() == kNone ? 6 : 7;
  std::size_t k = 0;
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t column = 0; column < row; ++column, ++k) {
      force[row] += share.value[k] * x[column];
      force[column] += share.value[k] * x[row];
    }
    force[row] += share.value[k++] * x[row];
  }
  for (std::size_t row = 0; row < size; ++row) {
    if (share.unknown[row] != kNone) {
      from[static_cast<std::size_t>(share.unknown[row])] -= force[row];
    }
  }
}

/// The same. \param columns of the share's unknowns in x, kNone where held.
inline void subtract_product(const FilmShare& share, const std::array<Index, 7>& columns,
                             std::span<const double> x, std::span<double> from) {
  std::array<double, 7> own{};
  for (std::size_t k = 0; k < own.size(); ++k) {
    own[k] = columns[k] == kNone ? 0 : x[static_cast<std::size_t>(columns[k])];
  }
  subtract_product(share, own, from);
}

} // namespace foam
