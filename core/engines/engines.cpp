// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/engines.h"

#include <variant>

#include "base/error.h"
#include "coarsening/event_coarsening.h"
#include "coarsening/newton_frame_coarsening.h"
#include "deformation/torus_deformation.h"
#include "engines/accelerator.h"
#include "engines/own_units.h"
#include "equilibrium/newton_equilibrator.h"
#include "mesh/hosted_walls.h"
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

std::unique_ptr<Evolution> coarsening_here(const CoarseningOptions& options) {
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

std::unique_ptr<Evolution> make_coarsening(const CoarseningOptions& options) {
  check(options);
  const Method& method = method_for(Method::Work::Coarsening, options);
  const Device device = options.equilibrator.device;
  const Accelerator* const accelerator = accelerator_for(device, method);
  return std::make_unique<OwnUnitsCoarsening>(
      options, [accelerator, device](const CoarseningOptions& its, const Foam& foam) {
        if (accelerator != nullptr && has_obstacles(foam)) {
          if (device == Device::CUDA) {
            throw FoamError("Device = CUDA, but there are obstacles in the foam: how films come "
                            "upon them is computed on the CPU alone");
          }
          return coarsening_here(its);
        }
        return accelerator != nullptr ? accelerator->make_coarsening(its) : coarsening_here(its);
      });
}

std::unique_ptr<Evolution> make_deformation(const DeformationOptions& options) {
  check(options);
  return std::make_unique<OwnUnitsDeformation>(
      options, [](const DeformationOptions& asked, const Foam& /*foam*/) {
        return std::make_unique<TorusDeformation>(asked);
      });
}

std::unique_ptr<Evolution> make_evolution(const EvolutionOptions& options) {
  const auto* const coarsening = std::get_if<CoarseningOptions>(&options.kind);
  return coarsening != nullptr ? make_coarsening(*coarsening)
                               : make_deformation(std::get<DeformationOptions>(options.kind));
}

} // namespace foam
