// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/methods.h"

#include <algorithm>
#include <array>

namespace foam {
namespace {

using Work = Method::Work;

bool newton(const CoarseningOptions& options) {
  return options.equilibrator.kind == EquilibratorKind::Newton;
}

bool jacobi(const CoarseningOptions& options) {
  return options.equilibrator.junction.sweep == Sweep::Jacobi;
}

bool any(const CoarseningOptions& /*options*/) {
  return true;
}

constexpr const char* kSweeps =
    "Sweep = GaussSeidel, one junction after the other, is computed on the CPU alone";

constexpr std::array kMethods{
    Method{Work::Equilibrium, "Equilibrator Newton", newton, OnGpu::Asked,
           "Equilibrator = Newton may swap other films there, so that it has to be asked for"},
    Method{Work::Equilibrium, "Equilibrator Junction, Sweep Jacobi", jacobi, OnGpu::Yes, ""},
    Method{Work::Equilibrium, "Equilibrator Junction, Sweep GaussSeidel", any, OnGpu::No, kSweeps},
    Method{
        Work::Coarsening, "Equilibrator Newton, Stepping FixedSteps",
        [](const CoarseningOptions& o) { return newton(o) && o.stepping == Stepping::FixedSteps; },
        OnGpu::Yes, ""},
    Method{Work::Coarsening, "Equilibrator Newton, Stepping Events", newton, OnGpu::No,
           "Stepping = Events, from one topological event to the next, is computed on the CPU "
           "alone; FixedSteps is computed there as well"},
    Method{Work::Coarsening,
           "Equilibrator Junction, TopologicalAlgorithm Simultaneous, Sweep Jacobi",
           [](const CoarseningOptions& o) {
             return o.topological_algorithm == TopologicalAlgorithm::Simultaneous && jacobi(o);
           },
           OnGpu::Yes, ""},
    Method{Work::Coarsening,
           "Equilibrator Junction, TopologicalAlgorithm Simultaneous, Sweep GaussSeidel",
           [](const CoarseningOptions& o) {
             return o.topological_algorithm == TopologicalAlgorithm::Simultaneous;
           },
           OnGpu::No, kSweeps},
    Method{Work::Coarsening,
           "Equilibrator Junction, TopologicalAlgorithm Final, Original or Improved", any,
           OnGpu::No, "of the TopologicalAlgorithms only Simultaneous is computed there"}};

} // namespace

std::span<const Method> methods() {
  return kMethods;
}

const Method& method_for(Method::Work work, const CoarseningOptions& options) {
  return *std::ranges::find_if(kMethods, [&](const Method& method) {
    return method.work == work && method.chosen_by(options);
  });
}

} // namespace foam
