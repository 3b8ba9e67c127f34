// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarsening/newton_frame_coarsening.h"

#include <utility>

#include "topology/wall_contact.h"

namespace foam {

NewtonFrameCoarsening::NewtonFrameCoarsening(const CoarseningOptions& options, int threads,
                                             std::size_t least_per_thread)
    : options_(options), host_(threads, least_per_thread), frame_(host_, options),
      in_need_(options.equilibrator) {}

void NewtonFrameCoarsening::restart(Foam foam) {
  foam.thresholds = frame_.limits(view_of(foam));
  foam_ = std::move(foam);
}

bool NewtonFrameCoarsening::advance(const AbortCheck& aborted) {
  Foam next;
  const auto begin = [&] {
    next = foam_;
    next.operations.clear();
    return view_of(next);
  };
  const auto in_need = [&](double t1_length) {
    in_need_.forget(); // the topology of a view changes unseen
    newton::NewtonResult found;
    const std::int64_t before = next.t1_count;
    found.report = in_need_.equilibrate(next, t1_length, aborted);
    found.swaps = std::exchange(next.operations, {});
    next.t1_count = before;
    return found;
  };
  const FrameResult result = frame_.advance(begin, aborted, in_need);
  if (result.performed()) {
    foam_ = std::move(next);
  }
  note(foam_, result, options_);
  if (result.performed() && touch_walls(foam_)) {
    in_need_.forget();
    in_need_.equilibrate(foam_, foam_.thresholds.t1_length, aborted);
  }
  return result.performed();
}

} // namespace foam
