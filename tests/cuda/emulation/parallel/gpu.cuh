// SPDX-License-Identifier: GPL-3.0-or-later
//
// In the place of cuda/parallel/gpu.cuh: the processor, with the device's arrays.
#pragma once

#include "parallel/device_array.h"
#include "parallel/host.h"

namespace foam::cuda {

class Gpu : public Host {
public:
  template <class T> using Array = DeviceArray<T>;
};

} // namespace foam::cuda
