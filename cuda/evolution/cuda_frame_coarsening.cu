// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/cuda_frame_coarsening.h"

#include "evolution/parallel_frame.h"
#include "evolution/resident_coarsening.cuh"
#include "junction/junction_equilibrator.h"
#include "parallel/gpu.cuh"

namespace foam::cuda {

std::unique_ptr<Coarsening> make_frame_coarsening(const CoarseningOptions& options) {
  check_junction_options(options.equilibrator);
  return std::make_unique<ResidentCoarsening<ParallelFrame<Gpu>>>(options);
}

} // namespace foam::cuda
