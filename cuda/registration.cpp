// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the GPU known to core.
#include "engines/accelerator.h"

#include <cuda_runtime_api.h>

#include "engines/instances.h"

namespace foam::cuda {
namespace {

std::string unavailable() {
  const std::string nothing = "there is no CUDA device to use: ";
  int driver = 0;
  int devices = 0;
  if (cudaDriverGetVersion(&driver) == cudaSuccess && driver == 0) {
    return nothing + "no driver is loaded";
  }
  const cudaError_t status = cudaGetDeviceCount(&devices);
  if (status != cudaSuccess) {
    return nothing + cudaGetErrorString(status);
  }
  return devices > 0 ? "" : nothing + "there are 0";
}

[[maybe_unused]] const bool registered = [] {
  register_cuda({unavailable, make_equilibrator, make_coarsening});
  return true;
}();

} // namespace
} // namespace foam::cuda
