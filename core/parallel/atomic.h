// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <cstdint>

#include "geometry/host_device.h"

namespace foam {

/// *place ← min(*place, value), whoever else does the same at the same time.
FOAM_HOST_DEVICE inline void atomic_min(std::uint64_t* place, std::uint64_t value) {
#ifdef __CUDA_ARCH__
  static_assert(sizeof(unsigned long long) == sizeof(std::uint64_t));
  atomicMin(reinterpret_cast<unsigned long long*>(place), value);
#else
  const std::atomic_ref<std::uint64_t> shared(*place);
  std::uint64_t now = shared.load(std::memory_order_relaxed);
  while (value < now && !shared.compare_exchange_weak(now, value, std::memory_order_relaxed)) {
  }
#endif
}

} // namespace foam
