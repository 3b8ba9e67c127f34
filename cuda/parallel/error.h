// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cuda_runtime_api.h>

#include <string>

#include "base/error.h"

namespace foam::cuda {

/// \throws FoamError if a call of the CUDA runtime has failed.
inline void check(cudaError_t status, const char* call) {
  if (status != cudaSuccess) {
    throw FoamError(std::string("CUDA: ") + call + " failed: " + cudaGetErrorString(status));
  }
}

} // namespace foam::cuda
