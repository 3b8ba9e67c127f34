// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/cuda_newton_frame_coarsening.h"

#include "evolution/newton_frame.h"
#include "evolution/resident_coarsening.cuh"
#include "parallel/gpu.cuh"

namespace foam::cuda {

std::unique_ptr<Coarsening> make_newton_frame_coarsening(const CoarseningOptions& options) {
  return std::make_unique<ResidentCoarsening<NewtonFrame<Gpu>>>(options);
}

} // namespace foam::cuda
