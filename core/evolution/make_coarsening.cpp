// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>

#include "evolution/event_coarsening.h"
#include "evolution/frame_coarsening.h"
#include "evolution/newton_frame_coarsening.h"
#include "mesh/number.h"
#include "parallel/accelerator.h"

namespace foam {
namespace {

void require(bool holds, const char* name, const char* condition, double value) {
  if (!holds || !std::isfinite(value)) {
    throw FoamError(std::string(name) + " must be " + condition + ", but is " + number(value));
  }
}

} // namespace

std::unique_ptr<Coarsening> make_coarsening(const CoarseningOptions& options) {
  require(options.time_step > 0, "TimeStep", "positive", options.time_step);
  require(options.permeability >= 0, "Permeability", "at least 0", options.permeability);
  const ThresholdOptions& t = options.thresholds;
  require(t.t1_length >= 0, "T1Length", "at least 0", t.t1_length);
  require(t.t2_area >= 0, "T2Area", "at least 0", t.t2_area);
  require(t.alpha > 0, "Alpha", "positive", t.alpha);
  check_options(options.equilibrator);
  if (const Accelerator* const accelerator =
          accelerator_for(options.equilibrator.device, accelerator_obstacle(options))) {
    return accelerator->make_coarsening(options);
  }
  if (options.equilibrator.kind == EquilibratorKind::Junction) {
    return std::make_unique<FrameCoarsening>(options);
  }
  if (options.topological_algorithm == TopologicalAlgorithm::Bidding) {
    return std::make_unique<NewtonFrameCoarsening>(options);
  }
  return std::make_unique<EventCoarsening>(options);
}

} // namespace foam
