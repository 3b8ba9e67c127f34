// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarsening/newton_frame_coarsening.h"

#include <utility>

namespace foam {

NewtonFrameCoarsening::NewtonFrameCoarsening(const CoarseningOptions& options, int threads,
                                             std::size_t least_per_thread)
    : options_(options), host_(threads, least_per_thread), frame_(host_, options) {}

void NewtonFrameCoarsening::restart(Foam foam) {
  foam_ = std::move(foam);
}

bool NewtonFrameCoarsening::advance(const AbortCheck& aborted) {
  Foam next;
  const auto begin = [&] {
    next = foam_;
    return view_of(next);
  };
  const FrameResult result = frame_.advance(begin, aborted);
  if (result.performed()) {
    foam_ = std::move(next);
  }
  note(foam_, result, options_.time_step);
  return result.performed();
}

} // namespace foam
