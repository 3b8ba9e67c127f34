// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cub/device/device_radix_sort.cuh>
#include <cub/device/device_reduce.cuh>
#include <cub/device/device_scan.cuh>
#include <thrust/iterator/counting_iterator.h>

#include <cstddef>
#include <cstdint>

#include "mesh/ids.h"
#include "parallel/device_array.h"
#include "parallel/kernels.h"

namespace foam::cuda {

/// The kernel stays where kernels' arguments lie, also when its functions take its address.
template <class Kernel>
__global__ void call_for_each(Index size, const __grid_constant__ Kernel kernel) {
  const Index i = static_cast<Index>(blockIdx.x * blockDim.x + threadIdx.x);
  if (i < size) {
    kernel(i);
  }
}

/// The GPU as an executor for parallel algorithms, under the names of core's Host
/// (core/parallel/host.h). Everything runs on the default stream, one after the other; only
/// reduce() and exclusive_scan() wait for it.
class Gpu {
public:
  template <class T> using Array = DeviceArray<T>;

  /// Calls kernel(i) for all i in [0, size), in no particular order and many at once.
  template <class Kernel> void for_each(Index size, const Kernel& kernel) {
    if (size > 0) {
      const auto blocks = static_cast<unsigned>((size + kThreads - 1) / kThreads);
      call_for_each<<<blocks, kThreads>>>(size, kernel);
      check(cudaGetLastError(), "a kernel's launch");
    }
  }

  /// The same for the elements of a range (parallel::OfRange).
  template <class Range, class Kernel> void for_each(const Range& range, const Kernel& kernel) {
    for_each(range.size(), foam::parallel::OfRange<Range, Kernel>{range, kernel});
  }

  /// zero, map(0), …, map(size − 1) combined; in an order that is the same every time on one
  /// device (CUB: run-to-run deterministic).
  template <class T, class Map, class Combine>
  T reduce(Index size, T zero, const Map& map, const Combine& combine) {
    result_.resize(sizeof(T));
    T* const result = reinterpret_cast<T*>(result_.data());
    const thrust::counting_iterator<Index> indices(0);
    std::size_t bytes = 0;
    check(cub::DeviceReduce::TransformReduce(nullptr, bytes, indices, result, size, combine, map,
                                             zero),
          "a reduction");
    scratch_.resize(bytes);
    check(cub::DeviceReduce::TransformReduce(scratch_.data(), bytes, indices, result, size, combine,
                                             map, zero),
          "a reduction");
    T value = zero;
    check(cudaMemcpy(&value, result, sizeof(T), cudaMemcpyDeviceToHost), "cudaMemcpy");
    return value;
  }

  template <class Range, class T, class Map, class Combine>
  T reduce(const Range& range, T zero, const Map& map, const Combine& combine) {
    return reduce(range.size(), zero, foam::parallel::OfRange<Range, Map>{range, map}, combine);
  }

  /// Each of counts[0], …, counts[size − 1] becomes the sum of those before it, and counts[size]
  /// the sum of all, which is returned. T is an integer.
  template <class T> T exclusive_scan(T* counts, Index size) {
    std::size_t bytes = 0;
    check(cub::DeviceScan::ExclusiveSum(nullptr, bytes, counts, size + 1), "a sum");
    scratch_.resize(bytes);
    check(cub::DeviceScan::ExclusiveSum(scratch_.data(), bytes, counts, size + 1), "a sum");
    T sum = 0;
    check(cudaMemcpy(&sum, counts + size, sizeof(T), cudaMemcpyDeviceToHost), "cudaMemcpy");
    return sum;
  }

  /// Puts keys into ascending order.
  void sort(std::uint64_t* keys, Index size) {
    sorted_.resize(static_cast<std::size_t>(size));
    std::size_t bytes = 0;
    check(cub::DeviceRadixSort::SortKeys(nullptr, bytes, keys, sorted_.data(), size), "a sort");
    scratch_.resize(bytes);
    check(cub::DeviceRadixSort::SortKeys(scratch_.data(), bytes, keys, sorted_.data(), size),
          "a sort");
    check(cudaMemcpy(keys, sorted_.data(), sorted_.size() * sizeof(std::uint64_t),
                     cudaMemcpyDeviceToDevice),
          "cudaMemcpy");
  }

private:
  static constexpr Index kThreads = 128; // to a block

  DeviceArray<std::byte> scratch_;
  DeviceArray<std::byte> result_;
  DeviceArray<std::uint64_t> sorted_;
};

} // namespace foam::cuda
