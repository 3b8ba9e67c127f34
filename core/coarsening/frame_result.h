// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/foam.h"
#include "topology/collapse_operations.h"

namespace foam {

/// What a frame has done on the view of a foam.
struct FrameResult {
  bool performed = false; ///< not, if the foam cannot go on
  OperationCount operations;
  EquilibriumReport report;
};

/// Notes a frame that has been performed in the foam.
inline void note(Foam& foam, const FrameResult& result, double time_step) {
  count(foam, result.operations);
  foam.report = result.report;
  foam.time += time_step;
}

} // namespace foam
