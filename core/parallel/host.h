// SPDX-License-Identifier: GPL-3.0-or-later
//
// What a parallel algorithm is written against: an executor, with arrays of its own, loops,
// reductions and sorting. Host is that of the processor; cuda/ has the GPU under the same names.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <thread>
#include <utility>
#include <vector>

#include "mesh/ids.h"
#include "parallel/kernels.h"
#include "parallel/thread_count.h"

namespace foam {

/// The processor's own threads.
class Host {
public:
  template <class T> using Array = std::vector<T>;

  /// \param threads that a loop may use; 0 stands for all there are.
  /// \param least_per_thread fewer indices than these are not worth a thread of their own; a kernel
  /// that takes long for each of them says so itself.
  explicit Host(int threads = 0, std::size_t least_per_thread = 8192)
      : least_per_thread_(least_per_thread),
        threads_(static_cast<std::size_t>(thread_count(threads))) {}

  /// Calls kernel(i) for all i in [0, size), in no particular order and many at once.
  template <class Kernel> void for_each(Index size, const Kernel& kernel) const {
    const auto count = static_cast<std::size_t>(size);
    const std::size_t pieces = std::clamp<std::size_t>(
        count / std::min(parallel::least_per_thread<Kernel>(), least_per_thread_), 1, threads_);
    const auto work = [&](std::size_t begin, std::size_t end) {
      for (std::size_t i = begin; i < end; ++i) {
        kernel(static_cast<Index>(i));
      }
    };
    std::vector<std::jthread> others;
    others.reserve(pieces - 1);
    for (std::size_t piece = 1; piece < pieces; ++piece) {
      others.emplace_back(work, piece * count / pieces, (piece + 1) * count / pieces);
    }
    work(0, count / pieces);
  }

  /// The same for the elements of a range (parallel::OfRange).
  template <class Range, class Kernel>
  void for_each(const Range& range, const Kernel& kernel) const {
    for_each(range.size(), parallel::OfRange<Range, Kernel>{range, kernel});
  }

  /// combine(… combine(combine(zero, map(0)), map(1)) …, map(size − 1)); the same bits every time.
  template <class T, class Map, class Combine>
  T reduce(Index size, T zero, const Map& map, const Combine& combine) const {
    for (Index i = 0; i < size; ++i) {
      zero = combine(zero, map(i));
    }
    return zero;
  }

  template <class Range, class T, class Map, class Combine>
  T reduce(const Range& range, T zero, const Map& map, const Combine& combine) const {
    return reduce(range.size(), zero, parallel::OfRange<Range, Map>{range, map}, combine);
  }

  /// Each of counts[0], …, counts[size − 1] becomes the sum of those before it, and counts[size]
  /// the sum of all, which is returned. T is an integer.
  template <class T> T exclusive_scan(T* counts, Index size) const {
    T sum = 0;
    for (Index i = 0; i < size; ++i) {
      sum += std::exchange(counts[i], sum);
    }
    return counts[size] = sum;
  }

  /// Puts keys into ascending order.
  void sort(std::uint64_t* keys, Index size) const { std::sort(keys, keys + size); }

private:
  std::size_t least_per_thread_;
  std::size_t threads_;
};

/// The elements of an executor's array, in this machine's memory; an array that is there already is
/// emptied for it.
template <class T> std::vector<T> fetch(std::vector<T>&& array) {
  return std::move(array);
}

} // namespace foam
