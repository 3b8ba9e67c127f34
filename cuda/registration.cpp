// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the GPU known to core.
#include "parallel/accelerator.h"

#include <cuda_runtime_api.h>

#include "evolution/cuda_frame_coarsening.h"
#include "junction/cuda_junction_equilibrator.h"

namespace foam::cuda {
namespace {

std::string unavailable() {
  int devices = 0;
  const cudaError_t status = cudaGetDeviceCount(&devices);
  if (status != cudaSuccess) {
    return std::string("there is no CUDA device to use: ") + cudaGetErrorString(status);
  }
  return devices > 0 ? "" : "there is no CUDA device";
}

[[maybe_unused]] const bool registered = [] {
  register_cuda({unavailable, make_junction_equilibrator, make_frame_coarsening});
  return true;
}();

} // namespace
} // namespace foam::cuda
