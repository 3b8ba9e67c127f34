// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/cuda_frame_coarsening.h"

#include <utility>

#include "evolution/parallel_frame.h"
#include "junction/junction_equilibrator.h"
#include "mesh/device_foam.h"
#include "parallel/gpu.cuh"

namespace foam::cuda {
namespace {

class CudaFrameCoarsening final : public Coarsening {
public:
  explicit CudaFrameCoarsening(const CoarseningOptions& options)
      : options_(options), frame_(gpu_, options) {
    check_junction_options(options.equilibrator);
  }

  void restart(Foam foam) override {
    foam_ = std::move(foam);
    now_.upload(foam_);
    fetched_ = true;
  }

  bool advance(const AbortCheck& aborted) override {
    next_.copy_from(now_);
    const FrameResult result = frame_.advance(next_.view(), aborted);
    if (!result.performed) {
      return false;
    }
    std::swap(now_, next_);
    count(foam_, result.operations);
    foam_.report = result.report;
    foam_.time += options_.time_step;
    fetched_ = false;
    return true;
  }

  const Foam& foam() const override {
    if (!fetched_) {
      now_.download(foam_);
      fetched_ = true;
    }
    return foam_;
  }

private:
  CoarseningOptions options_;
  Gpu gpu_;
  ParallelFrame<Gpu> frame_;
  DeviceFoam now_;
  DeviceFoam next_;
  mutable Foam foam_; ///< its arrays as they were when fetched last
  mutable bool fetched_ = true;
};

} // namespace

std::unique_ptr<Coarsening> make_frame_coarsening(const CoarseningOptions& options) {
  return std::make_unique<CudaFrameCoarsening>(options);
}

} // namespace foam::cuda
