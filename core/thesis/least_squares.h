// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <limits>

#include "geometry/host_device.h"

namespace foam::thesis {

/// The z that minimises ‖a·z − x‖₂, by Householder's reflections (Golub & Van Loan, Matrix
/// Computations, 5.2 and 5.3), which leaves out the columns that are ignored; their z is 0. There
/// must be at least as many rows as columns left. Columns that depend on each other give a z that
/// is not finite.
template <std::size_t Rows, std::size_t Columns>
FOAM_HOST_DEVICE std::array<double, Columns>
least_squares(std::array<std::array<double, Columns>, Rows> a, std::array<double, Rows> x,
              const std::array<bool, Columns>& ignored) {
  constexpr double kRounding = Rows * std::numeric_limits<double>::epsilon();
  std::size_t pivot = 0;
  std::array<std::size_t, Columns> pivot_of{}; // the row of a column's diagonal element in R
  for (std::size_t c = 0; c < Columns; ++c) {
    if (ignored[c]) {
      continue;
    }
    // The reflection along v = (0, …, 0, a_pivot − r, a_pivot+1, …) leaves r in the pivot's row and
    // nothing below.
    double above = 0;
    double below = 0;
    std::array<double, Rows> v{};
    for (std::size_t s = 0; s < Rows; ++s) {
      (s < pivot ? above : below) += a[s][c] * a[s][c];
      v[s] = s < pivot ? 0 : a[s][c];
    }
    const bool dependent = std::sqrt(below) <= kRounding * std::sqrt(above + below);
    const double r = dependent ? 0 : -std::copysign(std::sqrt(below), v[pivot]);
    v[pivot] -= r;
    const double half_square = -r * v[pivot]; // ½‖v‖²
    for (std::size_t d = c; d < Columns; ++d) {
      double along = 0;
      for (std::size_t s = pivot; s < Rows; ++s) {
        along += v[s] * a[s][d];
      }
      for (std::size_t s = pivot; s < Rows; ++s) {
        a[s][d] -= along / half_square * v[s];
      }
    }
    double along = 0;
    for (std::size_t s = pivot; s < Rows; ++s) {
      along += v[s] * x[s];
    }
    for (std::size_t s = pivot; s < Rows; ++s) {
      x[s] -= along / half_square * v[s];
    }
    pivot_of[c] = pivot++;
  }
  std::array<double, Columns> z{};
  for (std::size_t c = Columns; c-- > 0;) {
    if (ignored[c]) {
      continue;
    }
    const auto& row = a[pivot_of[c]];
    z[c] = x[pivot_of[c]];
    for (std::size_t d = c + 1; d < Columns; ++d) {
      z[c] -= row[d] * z[d];
    }
    z[c] /= row[c];
  }
  return z;
}

} // namespace foam::thesis
