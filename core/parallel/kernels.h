// SPDX-License-Identifier: GPL-3.0-or-later
//
// Kernels and combinations that every parallel algorithm needs (parallel/host.h).
#pragma once

#include "mesh/elements.h"

namespace foam::parallel {

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
