// SPDX-License-Identifier: GPL-3.0-or-later
//
// In which order junctions move where one's constraints look at the positions of others.
//
// The order is that of a hash of their numbers. A junction can move as soon as those near it have
// moved that come before it; all that can are one wave. Of n junctions in random order no more than
// O(log n) in a row wait for one another (G. E. Blelloch, J. T. Fineman, J. Shun, Greedy sequential
// maximal independent set and matching are parallel on average, SPAA 2012), so that there are few
// waves, and the result is that of moving one after the other.
#pragma once

#include <cstdint>
#include <utility>

#include "equilibrium/options.h"
#include "mesh/foam_view.h"
#include "parallel/kernels.h"

namespace foam::thesis {

/// A bijection that scatters (A. Appleby, MurmurHash3, its 32-bit finaliser).
FOAM_HOST_DEVICE inline std::uint32_t scattered(std::uint32_t x) {
  x ^= x >> 16;
  x *= 0x85ebca6bU;
  x ^= x >> 13;
  x *= 0xc2b2ae35U;
  x ^= x >> 16;
  return x;
}

/// Where a junction comes in the order.
FOAM_HOST_DEVICE inline std::uint32_t rank(Junction junction) {
  return scattered(static_cast<std::uint32_t>(junction.index()));
}

/// How many films away the positions lie that a junction's constraints look at.
FOAM_HOST_DEVICE inline int constraint_reach(const JunctionOptions& options) {
  return options.orientation_invariant ? 2 : (options.energy_decay ? 1 : 0);
}

namespace detail {

inline constexpr Index kWaiting = -1;

/// Puts the junctions that wait for nobody into a wave.
struct JoinWave {
  ConstFoamView mesh;
  int reach = 0;
  Index wave = 0;
  ConstFieldView<Junction, Index> before; ///< their waves; kWaiting if not known yet
  FieldView<Junction, Index> after;

  FOAM_HOST_DEVICE void operator()(Junction junction) const {
    const Index known = before[junction];
    const bool joins = mesh.has_junction(junction) && known == kWaiting && !waits(junction);
    after[junction] = joins ? wave : known;
  }

  /// Whether one that is near comes before the junction and waits itself.
  FOAM_HOST_DEVICE bool waits(Junction junction) const {
    bool found = false;
    for (const Half half : mesh.junction_half[junction]) {
      const Junction neighbour = mesh.end(half);
      found = found || (reach > 0 && comes_first(neighbour, junction));
      for (const Half second : mesh.junction_half[neighbour]) {
        found = found || (reach > 1 && comes_first(mesh.end(second), junction));
      }
    }
    return found;
  }

  FOAM_HOST_DEVICE bool comes_first(Junction other, Junction junction) const {
    return before[other] == kWaiting && rank(other) < rank(junction);
  }
};

struct IsWaiting {
  ConstFoamView mesh;
  ConstFieldView<Junction, Index> wave;

  FOAM_HOST_DEVICE bool operator()(Junction junction) const {
    return mesh.has_junction(junction) && wave[junction] == kWaiting;
  }
};

} // namespace detail

/// The waves of a mesh, found on an executor (parallel/host.h).
template <class Executor> class UpdateOrder {
public:
  explicit UpdateOrder(Executor& executor) : executor_(executor) {}

  /// Finds the waves; to be called anew after every topological change.
  void find(const ConstFoamView& mesh, int reach) {
    wave_.resize(place_of(mesh.junctions));
    next_.resize(place_of(mesh.junctions));
    executor_.for_each(mesh.junctions, parallel::Fill<Index>{wave_.data(), detail::kWaiting});
    waves_ = 0;
    while (executor_.reduce(mesh.junction_slots(), false, detail::IsWaiting{mesh, wave()},
                            parallel::Or{})) {
      executor_.for_each(
          mesh.junction_slots(),
          detail::JoinWave{mesh, reach, waves_, wave(), FieldView<Junction, Index>(next_.data())});
      std::swap(wave_, next_);
      ++waves_;
    }
  }

  Index waves() const { return waves_; }
  /// Of each junction, from 0; not of those that have vanished.
  ConstFieldView<Junction, Index> wave() const {
    return ConstFieldView<Junction, Index>(wave_.data());
  }

private:
  Executor& executor_;
  typename Executor::template Array<Index> wave_;
  typename Executor::template Array<Index> next_;
  Index waves_ = 0;
};

} // namespace foam::thesis
