// SPDX-License-Identifier: GPL-3.0-or-later
//
// Local operations on the mesh, many at once, with a result that depends on the mesh alone: every
// candidate bids for the bubbles that it touches, and goes ahead where none of them has had a lower
// bid. Two operations that touch the same film or junction touch a common bubble, so that those
// which go ahead do not meet.
//
// An operation has
//   candidates(mesh)   all that may be candidates, as Slots of elements or of numbers,
//   key(mesh, c)       the bid of candidate c, no two alike; kNoBid where it cannot or will not,
//   bubbles(mesh, c)   the bubbles that it touches,
//   count(mesh, c)     what it counts for: Performed, or as Performed,
//   perform(mesh, c)   what it does. Nothing outside of these bubbles is read or written.
// The mesh is a ConstFoamView, and a FoamView where it is changed.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>

#include "mesh/foam_view.h"
#include "parallel/atomic.h"
#include "parallel/kernels.h"

namespace foam {

inline constexpr std::uint64_t kNoBid = ~std::uint64_t{0};

/// The bubbles around a candidate, filled up with an outside, for which nobody has to bid: a
/// junction beside it has two other bubbles.
using Touched = std::array<Bubble, 5>;

/// The bubbles along a film and at its ends.
template <class Mesh> FOAM_HOST_DEVICE Touched bubbles_around_film(const Mesh& mesh, Film film) {
  const Half h = film.half();
  return {mesh.left(h), mesh.right(h), mesh.left(mesh.next_around_junction(h)),
          mesh.left(mesh.next_around_junction(h.twin())), kWorld};
}

/// How many operations of one kind were performed.
struct Performed {
  std::int64_t count = 0;

  FOAM_HOST_DEVICE bool any() const { return count > 0; }
  friend FOAM_HOST_DEVICE Performed operator+(Performed a, Performed b) {
    return {a.count + b.count};
  }
};

namespace detail {

template <class Operation> struct PlaceBids {
  ConstFoamView mesh;
  Operation operation;
  std::uint64_t* bid = nullptr;
  std::uint64_t* lowest = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    const auto candidate = operation.candidates(mesh)[i];
    const std::uint64_t key = operation.key(mesh, candidate);
    bid[i] = key;
    if (key != kNoBid) {
      for (const Bubble b : operation.bubbles(mesh, candidate)) {
        if (!b.is_outside()) {
          atomic_min(lowest + b.index(), key);
        }
      }
    }
  }
};

/// Takes back the bids that are not the lowest everywhere.
template <class Operation> struct WithdrawBids {
  ConstFoamView mesh;
  Operation operation;
  std::uint64_t* bid = nullptr;
  const std::uint64_t* lowest = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    std::uint64_t& key = bid[i];
    if (key != kNoBid) {
      bool holds_all = true;
      for (const Bubble b : operation.bubbles(mesh, operation.candidates(mesh)[i])) {
        holds_all = holds_all && (b.is_outside() || lowest[b.index()] == key);
      }
      key = holds_all ? key : kNoBid;
    }
  }
};

template <class Operation> struct PerformBids {
  FoamView mesh;
  Operation operation;
  const std::uint64_t* bid = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    if (bid[i] != kNoBid) {
      FoamView changed = mesh;
      operation.perform(changed, operation.candidates(mesh)[i]);
    }
  }
};

template <class Operation> struct CountBid {
  ConstFoamView mesh;
  Operation operation;
  const std::uint64_t* bid = nullptr;

  FOAM_HOST_DEVICE auto operator()(Index i) const {
    const auto candidate = operation.candidates(mesh)[i];
    using Count = decltype(operation.count(mesh, candidate));
    return bid[i] == kNoBid ? Count{} : operation.count(mesh, candidate);
  }
};

} // namespace detail

/// The schedule, on a machine (parallel/host.h).
template <class Machine> class Bidding {
public:
  explicit Bidding(Machine& machine) : machine_(machine) {}

  /// One round: those who hold all that they bid for go ahead. At least the lowest bid of all does.
  /// \returns the sum of operation.count(mesh, c) over them, taken before they change the mesh.
  template <class Operation> auto round(const FoamView& mesh, const Operation& operation) {
    const ConstFoamView seen = const_view(mesh);
    const Index candidates = operation.candidates(seen).size();
    bid_.resize(place_of(candidates));
    lowest_.resize(place_of(mesh.bubbles));
    machine_.for_each(mesh.bubbles, parallel::Fill<std::uint64_t>{lowest_.data(), kNoBid});
    machine_.for_each(candidates,
                      detail::PlaceBids<Operation>{seen, operation, bid_.data(), lowest_.data()});
    machine_.for_each(
        candidates, detail::WithdrawBids<Operation>{seen, operation, bid_.data(), lowest_.data()});
    const detail::CountBid<Operation> count{seen, operation, bid_.data()};
    using Count = decltype(count(0));
    const Count performed = machine_.reduce(candidates, Count{}, count, parallel::Add{});
    machine_.for_each(candidates, detail::PerformBids<Operation>{mesh, operation, bid_.data()});
    return performed;
  }

  /// Rounds until there is no candidate left. \returns the sum over all rounds.
  template <class Operation> auto run(const FoamView& mesh, const Operation& operation) {
    auto total = round(mesh, operation);
    for (auto more = total; more.any();) {
      more = round(mesh, operation);
      total = total + more;
    }
    return total;
  }

private:
  Machine& machine_;
  typename Machine::template Array<std::uint64_t> bid_;
  typename Machine::template Array<std::uint64_t> lowest_;
};

/// A key that comes before another if its rank is lower, else its size (≥ 0; to single precision),
/// else its id.
FOAM_HOST_DEVICE inline std::uint64_t bid_key(bool second_rank, double size, Index id) {
  // The bits of floats that are not negative are ordered as the floats are.
  const auto rounded = static_cast<float>(size);
  std::uint32_t bits = 0;
  static_assert(sizeof bits == sizeof rounded);
  std::memcpy(&bits, &rounded, sizeof bits);
  return (std::uint64_t{second_rank} << 63) | (std::uint64_t{bits} << 32) |
         static_cast<std::uint32_t>(id);
}

} // namespace foam
