// SPDX-License-Identifier: GPL-3.0-or-later
//
// Kernels and combinations that every parallel algorithm needs (parallel/host.h).
#pragma once

#include <cstddef>
#include <limits>

#include "mesh/ids.h"

namespace foam::parallel {

/// So few indices are not worth a thread of their own to a kernel, if it says so itself.
template <class Kernel> constexpr std::size_t least_per_thread() {
  if constexpr (requires { Kernel::kLeastPerThread; }) {
    return Kernel::kLeastPerThread;
  } else {
    return std::numeric_limits<std::size_t>::max();
  }
}

/// array[i] ← value
template <class T> struct Fill {
  T* array = nullptr;
  T value{};

  FOAM_HOST_DEVICE void operator()(Index i) const { array[i] = value; }
};

/// to[i] ← from[i]
template <class T> struct Copy {
  const T* from = nullptr;
  T* to = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const { to[i] = from[i]; }
};

/// A kernel or a map of the elements of a range as one of numbers. \tparam Range has a size() and
/// elements [0], [1], …
template <class Range, class Kernel> struct OfRange {
  static constexpr std::size_t kLeastPerThread = least_per_thread<Kernel>();

  Range range;
  Kernel kernel;

  FOAM_HOST_DEVICE decltype(auto) operator()(Index i) const { return kernel(range[i]); }
};

struct Add {
  template <class T> FOAM_HOST_DEVICE T operator()(const T& a, const T& b) const { return a + b; }
};

/// Not-a-number wins, so that it is seen.
struct Larger {
  FOAM_HOST_DEVICE double operator()(double a, double b) const { return a >= b || a != a ? a : b; }
};

struct Smaller {
  FOAM_HOST_DEVICE double operator()(double a, double b) const { return b < a ? b : a; }
};

struct Or {
  FOAM_HOST_DEVICE bool operator()(bool a, bool b) const { return a || b; }
};

} // namespace foam::parallel
