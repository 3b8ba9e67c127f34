// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/engines.h"

#include "coarsening/event_coarsening.h"
#include "coarsening/newton_frame_coarsening.h"
#include "engines/accelerator.h"
#include "engines/own_units.h"
#include "equilibrium/newton_equilibrator.h"
#include "thesis/frame_coarsening.h"
#include "thesis/junction_equilibrator.h"

namespace foam {
namespace {

std::unique_ptr<Equilibrator> equilibrator_here(const EquilibratorOptions& options) {
  if (options.kind == EquilibratorKind::Junction) {
    return std::make_unique<JunctionEquilibrator>(options);
  }
  return std::make_unique<NewtonEquilibrator>(options);
}

std::unique_ptr<Coarsening> coarsening_here(const CoarseningOptions& options) {
  if (options.equilibrator.kind == EquilibratorKind::Junction) {
    return std::make_unique<FrameCoarsening>(options, make_equilibrator(options.equilibrator));
  }
  if (options.stepping == Stepping::FixedSteps) {
    return std::make_unique<NewtonFrameCoarsening>(options);
  }
  return std::make_unique<EventCoarsening>(options);
}

} // namespace

std::unique_ptr<Equilibrator> make_equilibrator(const EquilibratorOptions& options) {
  check(options);
  CoarseningOptions all;
  all.equilibrator = options;
  const Method& method = method_for(Method::Work::Equilibrium, all);
  const Accelerator* const accelerator = accelerator_for(options.device, method);
  return std::make_unique<OwnUnitsEquilibrator>(
      accelerator != nullptr ? accelerator->make_equilibrator(options) : equilibrator_here(options),
      unit_steps(options.kind));
}

std::unique_ptr<Coarsening> make_coarsening(const CoarseningOptions& options) {
  check(options);
  const Method& method = method_for(Method::Work::Coarsening, options);
  const Accelerator* const accelerator = accelerator_for(options.equilibrator.device, method);
  return std::make_unique<OwnUnitsCoarsening>(
      options, accelerator != nullptr ? accelerator->make_coarsening : coarsening_here);
}

} // namespace foam
