// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <utility>

#include "geometry/host_device.h"

namespace foam::thesis {

using Vector5 = std::array<double, 5>;
using Matrix5 = std::array<Vector5, 5>; ///< by rows

/// Solves a·z = x by the thesis's Gauss–Jordan reduction (Appendix B.1), which leaves out the rows
/// and columns that are ignored; their z is 0.
///
/// The reduction exchanges no rows, with one exception: of the two last equations, the angles, the
/// one with the larger pivot comes first. The thesis leaves open which angle that is, and in a
/// symmetric junction the other one can have none. A singular matrix gives a z that is not finite.
FOAM_HOST_DEVICE inline Vector5 gauss_jordan(Matrix5 a, Vector5 x,
                                             const std::array<bool, 5>& ignored) {
  for (std::size_t r = 0; r < 5; ++r) {
    if (ignored[r]) {
      continue;
    }
    if (r == 3 && !ignored[4] && std::abs(a[4][3]) > std::abs(a[3][3])) {
      std::swap(a[3], a[4]);
      std::swap(x[3], x[4]);
    }
    x[r] /= a[r][r];
    for (std::size_t c = 5; c-- > r;) {
      a[r][c] /= a[r][r];
    }
    for (std::size_t s = r + 1; s < 5; ++s) {
      x[s] -= x[r] * a[s][r];
      for (std::size_t c = 5; c-- > r;) {
        a[s][c] -= a[r][c] * a[s][r];
      }
    }
  }
  for (std::size_t r = 5; r-- > 0;) {
    if (ignored[r]) {
      x[r] = 0;
      continue;
    }
    for (std::size_t s = 0; s < r; ++s) {
      x[s] -= x[r] * a[s][r];
    }
  }
  return x;
}

} // namespace foam::thesis
