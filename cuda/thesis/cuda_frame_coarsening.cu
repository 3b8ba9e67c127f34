// SPDX-License-Identifier: GPL-3.0-or-later
#include "thesis/cuda_frame_coarsening.h"

#include "coarsening/resident_coarsening.cuh"
#include "parallel/gpu.cuh"
#include "thesis/parallel_frame.h"

namespace foam::cuda {

std::unique_ptr<Coarsening> make_frame_coarsening(const CoarseningOptions& options) {
  return std::make_unique<ResidentCoarsening<ParallelFrame<Gpu>>>(options);
}

} // namespace foam::cuda
