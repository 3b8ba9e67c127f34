// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "coarsening/coarsening.h"
#include "coarsening/frame_result.h"
#include "mesh/device_foam.h"
#include "parallel/gpu.cuh"
#include "sampling/foam_sampler.h"
#include "statistics/parallel_statistics.h"

namespace foam::cuda {

/// Frames of a foam that stays on the device: it is sent there by restart() and fetched by foam().
/// It is sampled and measured there, and only what is shown of it is fetched. In a frame nothing
/// crosses but the results of reductions.
/// \tparam Frame ParallelFrame<Gpu> or NewtonFrame<Gpu>
template <class Frame> class ResidentCoarsening final : public Coarsening {
public:
  /// \param in_need does those frames on the processor that lead nowhere on the device; null if
  /// there is no other way. \param parts what else the frame is made of.
  template <class... Parts>
  explicit ResidentCoarsening(const CoarseningOptions& options, std::unique_ptr<Coarsening> in_need,
                              Parts&&... parts)
      : options_(options), in_need_(std::move(in_need)),
        frame_(gpu_, options, std::forward<Parts>(parts)...), sampler_(gpu_), statistics_(gpu_) {}

  void restart(Foam foam) override {
    foam_ = std::move(foam);
    now_.upload(foam_);
    foam_.thresholds = frame_.limits(now_.view());
    names_ = BubbleNames<Gpu>(foam_.bubble_id);
    fetched_ = true;
  }

  bool advance(const AbortCheck& aborted) override {
    const auto begin = [this] {
      next_.copy_from(now_);
      return next_.view();
    };
    const FrameResult result = frame_.advance(begin, aborted);
    if (result.performed()) {
      std::swap(now_, next_);
      fetched_ = false;
    } else {
      foam();
      if (in_need_) {
        return advance_on_processor(aborted);
      }
    }
    note(foam_, result, options_);
    return result.performed();
  }

  const Foam& foam() const override {
    if (!fetched_) {
      now_.download(foam_);
      fetched_ = true;
    }
    return foam_;
  }

  const FoamRecord& record() const override { return foam_; }

  std::vector<TopologicalEvent> events() const override { return events_of(foam_); }

  SampledFoam sample(double chord_error) override {
    SampledFoam sampled = sampler_.sample(const_view(now_.view()), names_, chord_error);
    sampled.record = foam_;
    take_outsides(foam_.surroundings.has_walls() ? foam() : foam_, sampled);
    return sampled;
  }

  FoamStatistics statistics(bool include_boundary) override {
    return statistics_.measure(const_view(now_.view()), names_, include_boundary);
  }

private:
  /// \pre the foam has been fetched.
  bool advance_on_processor(const AbortCheck& aborted) {
    in_need_->restart(foam_);
    const bool goes_on = in_need_->advance(aborted);
    foam_ = in_need_->foam();
    now_.upload(foam_);
    return goes_on;
  }

  CoarseningOptions options_;
  std::unique_ptr<Coarsening> in_need_;
  Gpu gpu_;
  Frame frame_;
  FoamSampler<Gpu> sampler_;
  ParallelStatistics<Gpu> statistics_;
  DeviceFoam now_;
  DeviceFoam next_;
  BubbleNames<Gpu> names_;
  mutable Foam foam_; ///< its arrays as they were when fetched last
  mutable bool fetched_ = true;
};

} // namespace foam::cuda
