// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/engines.h"

#include "coarsening/event_coarsening.h"
#include "coarsening/newton_frame_coarsening.h"
#include "engines/accelerator.h"
#include "equilibrium/newton_equilibrator.h"
#include "thesis/frame_coarsening.h"
#include "thesis/junction_equilibrator.h"

namespace foam {

std::unique_ptr<Equilibrator> make_equilibrator(const EquilibratorOptions& options) {
  check(options);
  CoarseningOptions all;
  all.equilibrator = options;
  const Method& method = method_for(Method::Work::Equilibrium, all);
  if (const Accelerator* const accelerator = accelerator_for(options.device, method)) {
    return accelerator->make_equilibrator(options);
  }
  if (options.kind == EquilibratorKind::Junction) {
    return std::make_unique<JunctionEquilibrator>(options);
  }
  return std::make_unique<NewtonEquilibrator>(options);
}

std::unique_ptr<Coarsening> make_coarsening(const CoarseningOptions& options) {
  check(options);
  const Method& method = method_for(Method::Work::Coarsening, options);
  if (const Accelerator* const accelerator = accelerator_for(options.equilibrator.device, method)) {
    return accelerator->make_coarsening(options);
  }
  if (options.equilibrator.kind == EquilibratorKind::Junction) {
    return std::make_unique<FrameCoarsening>(options, make_equilibrator(options.equilibrator));
  }
  if (options.stepping == Stepping::FixedSteps) {
    return std::make_unique<NewtonFrameCoarsening>(options);
  }
  return std::make_unique<EventCoarsening>(options);
}

} // namespace foam
