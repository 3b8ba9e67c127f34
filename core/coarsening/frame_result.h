// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <vector>

#include "coarsening/end.h"
#include "coarsening/options.h"
#include "mesh/foam.h"
#include "topology/operations.h"

namespace foam {

/// What a frame has done on the view of a foam.
struct FrameResult {
  std::optional<Obstacle> end; ///< why the foam cannot go on; the frame is not performed then
  Thresholds limit;            ///< in force in the next frame; in this one if it is not performed
  std::vector<TopologicalOperation> operations; ///< with times from the frame's begin on
  EquilibriumReport report;

  bool performed() const { return !end; }

  /// Adds operations of some time (s) after the frame's begin.
  void add(const std::vector<TopologicalOperation>& performed, double time) {
    for (const TopologicalOperation& operation : performed) {
      operations.push_back(operation);
      operations.back().time = time;
    }
  }
};

/// Notes the operations of a frame that begins at the foam's time.
inline void note_operations(Foam& foam, const FrameResult& result) {
  for (const TopologicalOperation& operation : result.operations) {
    note_performed(foam, operation);
    foam.operations.back().time += operation.time;
  }
}

/// Notes a frame in the foam: in the next one if it has been performed, or else in the last.
inline void note(Foam& foam, const FrameResult& result, const CoarseningOptions& options) {
  foam.ended.reset();
  foam.operations.clear();
  if (!result.performed()) {
    foam.ended = end_at(foam, *result.end, result.limit, options.thresholds);
    return;
  }
  note_operations(foam, result);
  foam.report = result.report;
  foam.thresholds = result.limit;
  foam.time += options.time_step;
}

} // namespace foam
