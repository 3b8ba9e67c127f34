// SPDX-License-Identifier: GPL-3.0-or-later
//
// Makes the GPU known to core.
#include "engines/accelerator.h"

#include <cuda_runtime_api.h>

#include "coarsening/cuda_newton_frame_coarsening.h"
#include "equilibrium/cuda_newton_equilibrator.h"
#include "thesis/cuda_frame_coarsening.h"
#include "thesis/cuda_junction_equilibrator.h"

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

std::unique_ptr<Equilibrator> make_equilibrator(const EquilibratorOptions& options) {
  return options.kind == EquilibratorKind::Newton ? make_newton_equilibrator(options)
                                                  : make_junction_equilibrator(options);
}

std::unique_ptr<Coarsening> make_coarsening(const CoarseningOptions& options) {
  return options.equilibrator.kind == EquilibratorKind::Newton
             ? make_newton_frame_coarsening(options)
             : make_frame_coarsening(options);
}

[[maybe_unused]] const bool registered = [] {
  register_cuda({unavailable, make_equilibrator, make_coarsening});
  return true;
}();

} // namespace
} // namespace foam::cuda
