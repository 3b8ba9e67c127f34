// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>

#include "coarsening/end.h"
#include "coarsening/options.h"
#include "mesh/foam.h"
#include "topology/collapse_operations.h"

namespace foam {

/// What a frame has done on the view of a foam.
struct FrameResult {
  std::optional<Obstacle> end; ///< why the foam cannot go on; the frame is not performed then
  Thresholds limit;            ///< in force in the next frame; in this one if it is not performed
  OperationCount operations;
  EquilibriumReport report;

  bool performed() const { return !end; }
};

/// Notes a frame in the foam: in the next one if it has been performed, or else in the last.
inline void note(Foam& foam, const FrameResult& result, const CoarseningOptions& options) {
  foam.ended.reset();
  if (!result.performed()) {
    foam.ended = end_at(foam, *result.end, result.limit, options.thresholds);
    return;
  }
  count(foam, result.operations);
  foam.report = result.report;
  foam.thresholds = result.limit;
  foam.time += options.time_step;
}

} // namespace foam
