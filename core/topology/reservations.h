// SPDX-License-Identifier: GPL-3.0-or-later
//
// Local operations on the mesh, many at once, with a result that depends on the mesh alone, by
// deterministic reservations (G. E. Blelloch, J. T. Fineman, P. B. Gibbons, J. Shun, Internally
// deterministic parallel algorithms can be fast, PPoPP 2012): every candidate reserves the bubbles
// that it touches, and goes ahead where none of them is reserved by another of higher priority. Two
// operations that touch the same film or junction touch a common bubble, so that those which go
// ahead do not meet.
//
// An operation has
//   candidates(mesh)   all that may be candidates, as Slots of elements or of numbers,
//   key(mesh, c)       by which c reserves, the lowest first, no two alike; kNoReservation where it
//                      cannot or will not,
//   bubbles(mesh, c)   the bubbles that it touches,
//   perform(mesh, c)   what it does. Nothing outside of these bubbles is read or written; and, if
//                      it is one that is reported,
//   describe(mesh, c)  what perform() is about to do, as a TopologicalOperation.
// The mesh is a ConstFoamView, and a FoamView where it is changed.
#pragma once

#include <array>
#include <cstdint>
#include <cstring>
#include <utility>
#include <vector>

#include "mesh/foam_view.h"
#include "mesh/topological_event.h"
#include "parallel/atomic.h"
#include "parallel/kernels.h"

namespace foam {

inline constexpr std::uint64_t kNoReservation = ~std::uint64_t{0};

/// The bubbles around a candidate, filled up with an outside, which nobody has to reserve: a
/// junction beside it has two other bubbles.
using Touched = std::array<Bubble, 5>;

/// The bubbles along a film and at its ends.
template <class Mesh> FOAM_HOST_DEVICE Touched bubbles_around_film(const Mesh& mesh, Film film) {
  const Half h = film.half();
  return {mesh.left(h), mesh.right(h), mesh.left(mesh.next_around_junction(h)),
          mesh.left(mesh.next_around_junction(h.twin())), kWorld};
}

namespace detail {

template <class Operation> struct Reserve {
  ConstFoamView mesh;
  Operation operation;
  std::uint64_t* key = nullptr; ///< by candidate
  std::uint64_t* lowest = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    const auto candidate = operation.candidates(mesh)[i];
    key[i] = operation.key(mesh, candidate);
    if (key[i] != kNoReservation) {
      for (const Bubble b : operation.bubbles(mesh, candidate)) {
        if (!b.is_outside()) {
          atomic_min(lowest + b.index(), key[i]);
        }
      }
    }
  }
};

/// Takes back the reservations of those that do not hold all of their bubbles.
template <class Operation> struct Withdraw {
  ConstFoamView mesh;
  Operation operation;
  std::uint64_t* key = nullptr; ///< by candidate
  const std::uint64_t* lowest = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    std::uint64_t& own = key[i];
    if (own != kNoReservation) {
      bool holds_all = true;
      for (const Bubble b : operation.bubbles(mesh, operation.candidates(mesh)[i])) {
        holds_all = holds_all && (b.is_outside() || lowest[b.index()] == own);
      }
      own = holds_all ? own : kNoReservation;
    }
  }
};

template <class Operation> struct Commit {
  FoamView mesh;
  Operation operation;
  const std::uint64_t* key = nullptr; ///< by candidate

  FOAM_HOST_DEVICE void operator()(Index i) const {
    if (key[i] != kNoReservation) {
      FoamView changed = mesh;
      operation.perform(changed, operation.candidates(mesh)[i]);
    }
  }
};

struct CountReserved {
  const std::uint64_t* key = nullptr; ///< by candidate

  FOAM_HOST_DEVICE Index operator()(Index i) const { return key[i] == kNoReservation ? 0 : 1; }
};

template <class Operation> struct DescribeReserved {
  ConstFoamView mesh;
  Operation operation;
  const std::uint64_t* key = nullptr; ///< by candidate
  const Index* number = nullptr;      ///< by candidate
  TopologicalOperation* list = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    if (key[i] != kNoReservation) {
      list[number[i]] = operation.describe(mesh, operation.candidates(mesh)[i]);
    }
  }
};

struct NumberReserved {
  CountReserved count;
  Index* number = nullptr; ///< by candidate

  FOAM_HOST_DEVICE void operator()(Index i) const { number[i] = count(i); }
};

template <class Operation>
concept IsReported = requires(const Operation& operation, const ConstFoamView& mesh) {
  operation.describe(mesh, operation.candidates(mesh)[0]);
};

} // namespace detail

/// The schedule, on an executor (parallel/host.h).
template <class Executor> class Reservations {
public:
  explicit Reservations(Executor& executor) : executor_(executor) {}

  /// One round: those who hold all that they have reserved go ahead. At least the first of all
  /// does. \returns how many
  template <class Operation> Index round(const FoamView& mesh, const Operation& operation) {
    const ConstFoamView seen = const_view(mesh);
    const Index candidates = operation.candidates(seen).size();
    key_.resize(place_of(candidates));
    lowest_.resize(place_of(mesh.bubbles));
    executor_.for_each(mesh.bubbles, parallel::Fill<std::uint64_t>{lowest_.data(), kNoReservation});
    executor_.for_each(candidates,
                       detail::Reserve<Operation>{seen, operation, key_.data(), lowest_.data()});
    executor_.for_each(candidates,
                       detail::Withdraw<Operation>{seen, operation, key_.data(), lowest_.data()});
    const Index performed =
        executor_.reduce(candidates, Index{0}, detail::CountReserved{key_.data()}, parallel::Add{});
    if constexpr (detail::IsReported<Operation>) {
      if (performed > 0) {
        describe(seen, operation, candidates, performed);
      }
    }
    executor_.for_each(candidates, detail::Commit<Operation>{mesh, operation, key_.data()});
    return performed;
  }

  /// Rounds until there is no candidate left. \returns how many operations were performed
  template <class Operation> std::int64_t run(const FoamView& mesh, const Operation& operation) {
    std::int64_t total = 0;
    while (const Index performed = round(mesh, operation)) {
      total += performed;
    }
    return total;
  }

  /// Those that are reported, of all rounds since this was asked last; by rounds, and in each by
  /// candidates.
  std::vector<TopologicalOperation> take_performed() { return std::exchange(performed_, {}); }

private:
  template <class Operation>
  void describe(const ConstFoamView& mesh, const Operation& operation, Index candidates,
                Index performed) {
    number_.resize(place_of(candidates) + 1);
    executor_.for_each(candidates, detail::NumberReserved{{key_.data()}, number_.data()});
    executor_.exclusive_scan(number_.data(), candidates);
    typename Executor::template Array<TopologicalOperation> list(place_of(performed));
    executor_.for_each(candidates, detail::DescribeReserved<Operation>{
                                       mesh, operation, key_.data(), number_.data(), list.data()});
    const std::vector<TopologicalOperation> described = fetch(std::move(list));
    performed_.insert(performed_.end(), described.begin(), described.end());
  }

  Executor& executor_;
  typename Executor::template Array<std::uint64_t> key_;
  typename Executor::template Array<std::uint64_t> lowest_;
  typename Executor::template Array<Index> number_; ///< of a candidate among those that go ahead
  std::vector<TopologicalOperation> performed_;
};

/// A key that comes before another if its rank is lower, else its size (≥ 0; to single precision),
/// else its id.
FOAM_HOST_DEVICE inline std::uint64_t reservation_key(bool second_rank, double size, Index id) {
  // The bits of floats that are not negative are ordered as the floats are.
  const auto rounded = static_cast<float>(size);
  std::uint32_t bits = 0;
  static_assert(sizeof bits == sizeof rounded);
  std::memcpy(&bits, &rounded, sizeof bits);
  return (std::uint64_t{second_rank} << 63) | (std::uint64_t{bits} << 32) |
         static_cast<std::uint32_t>(id);
}

} // namespace foam
