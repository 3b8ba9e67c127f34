// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/cuda_frame_coarsening.h"

#include <utility>

#include "evolution/parallel_frame.h"
#include "junction/junction_equilibrator.h"
#include "mesh/device_foam.h"
#include "parallel/gpu.cuh"
#include "sampling/foam_sampler.h"
#include "statistics/parallel_statistics.h"

namespace foam::cuda {
namespace {

class CudaFrameCoarsening final : public Coarsening {
public:
  explicit CudaFrameCoarsening(const CoarseningOptions& options)
      : options_(options), frame_(gpu_, options), sampler_(gpu_), statistics_(gpu_) {
    check_junction_options(options.equilibrator);
  }

  void restart(Foam foam) override {
    foam_ = std::move(foam);
    now_.upload(foam_);
    names_ = BubbleNames<Gpu>(foam_.bubble_id);
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

  const FoamRecord& record() const override { return foam_; }

  SampledFoam sample(double chord_error) override {
    SampledFoam sampled = sampler_.sample(now_.view(), names_, chord_error);
    sampled.record = foam_;
    return sampled;
  }

  FoamStatistics statistics(bool include_boundary) override {
    return statistics_.measure(now_.view(), names_, include_boundary);
  }

private:
  CoarseningOptions options_;
  Gpu gpu_;
  ParallelFrame<Gpu> frame_;
  FoamSampler<Gpu> sampler_;
  ParallelStatistics<Gpu> statistics_;
  DeviceFoam now_;
  DeviceFoam next_;
  BubbleNames<Gpu> names_;
  mutable Foam foam_; ///< its arrays as they were when fetched last
  mutable bool fetched_ = true;
};

} // namespace

std::unique_ptr<Coarsening> make_frame_coarsening(const CoarseningOptions& options) {
  return std::make_unique<CudaFrameCoarsening>(options);
}

} // namespace foam::cuda
