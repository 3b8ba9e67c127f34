// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "mesh/ids.h"

namespace foam::detail {

/// Shares out the gas of a bubble that is removed: each neighbour's target area grows by what the
/// neighbour itself gains, and by an equal share of what the bubble's area lacked of its target.
template <std::size_t N> class GasLedger {
public:
  template <class Mesh>
  FOAM_HOST_DEVICE GasLedger(const Mesh& mesh, Bubble removed,
                             const std::array<Bubble, N>& neighbours)
      : neighbours_(neighbours) {
    int takers = 0;
    for (std::size_t i = 0; i < N; ++i) {
      if (!neighbours[i].is_outside()) {
        before_[i] = mesh.area(neighbours[i]);
        ++takers;
      }
    }
    share_ = (mesh.target_area[removed] - mesh.area(removed)) / takers;
  }

  template <class Mesh> FOAM_HOST_DEVICE void share_out(Mesh& mesh) const {
    for (std::size_t i = 0; i < N; ++i) {
      const Bubble b = neighbours_[i];
      if (!b.is_outside()) {
        const double gain = seen_before(i) ? 0 : mesh.area(b) - before_[i];
        mesh.target_area[b] += share_ + gain;
      }
    }
  }

private:
  FOAM_HOST_DEVICE bool seen_before(std::size_t i) const {
    bool seen = false;
    for (std::size_t k = 0; k < i; ++k) {
      seen = seen || neighbours_[k] == neighbours_[i];
    }
    return seen;
  }

  std::array<Bubble, N> neighbours_;
  std::array<double, N> before_{};
  double share_ = 0;
};

} // namespace foam::detail
