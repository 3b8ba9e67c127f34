// SPDX-License-Identifier: GPL-3.0-or-later
#include "parallel/accelerator.h"

#include <iostream>
#include <mutex>
#include <optional>

#include "evolution/coarsening.h"

namespace foam {
namespace {

std::optional<Accelerator>& cuda() {
  static std::optional<Accelerator> accelerator;
  return accelerator;
}

} // namespace

void register_cuda(const Accelerator& accelerator) {
  cuda() = accelerator;
}

const Accelerator* accelerator_for(Device device, const std::string& obstacle) {
  const bool demanded = device == Device::CUDA;
  const auto without = [&](const std::string& reason) -> const Accelerator* {
    if (demanded) {
      throw FoamError("Device = CUDA, but " + reason);
    }
    return nullptr;
  };
  if (device == Device::CPU) {
    return nullptr;
  }
  if (!cuda()) {
    return without("this build has no CUDA support");
  }
  if (!obstacle.empty()) {
    return without(obstacle);
  }
  const std::string reason = cuda()->unavailable();
  if (!reason.empty()) {
    static std::once_flag said;
    if (!demanded) {
      std::call_once(said, [&] {
        std::clog << "Foam: Device = Auto computes on the CPU: " << reason << std::endl;
      });
    }
    return without(reason);
  }
  return &*cuda();
}

std::string accelerator_obstacle(const EquilibratorOptions& options) {
  if (options.kind == EquilibratorKind::Newton) {
    return options.device == Device::CUDA
               ? ""
               : "Equilibrator = Newton may swap other films there, so that it has to be asked for";
  }
  if (options.junction.sweep != Sweep::Jacobi) {
    return "Sweep = GaussSeidel, one junction after the other, is computed on the CPU alone";
  }
  return {};
}

std::string accelerator_obstacle(const CoarseningOptions& options) {
  const bool newton = options.equilibrator.kind == EquilibratorKind::Newton;
  if (options.topological_algorithm != TopologicalAlgorithm::Bidding) {
    return newton
               ? "Equilibrator = Newton steps from one topological event to the next on the CPU "
                 "alone; with TopologicalAlgorithm = Bidding it goes in fixed steps, there as well"
               : "of the TopologicalAlgorithms only Bidding is computed there";
  }
  return newton ? "" : accelerator_obstacle(options.equilibrator);
}

} // namespace foam
