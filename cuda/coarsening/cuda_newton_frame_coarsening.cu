// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarsening/cuda_newton_frame_coarsening.h"

#include "algebra/device_direct_solver.h"
#include "coarsening/newton_frame.h"
#include "coarsening/resident_coarsening.cuh"
#include "parallel/gpu.cuh"

namespace foam::cuda {

std::unique_ptr<Coarsening> make_newton_frame_coarsening(const CoarseningOptions& options) {
  return std::make_unique<ResidentCoarsening<NewtonFrame<Gpu>>>(
      options, direct_solver_for(options.equilibrator));
}

} // namespace foam::cuda
