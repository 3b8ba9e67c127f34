// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/instances.h"

#include <utility>

#include "algebra/device_direct_solver.h"
#include "coarsening/newton_frame.h"
#include "coarsening/newton_frame_coarsening.h"
#include "coarsening/resident_coarsening.cuh"
#include "equilibrium/executor_equilibrator.h"
#include "mesh/device_foam.h"
#include "parallel/gpu.cuh"
#include "thesis/jacobi_sweep.h"
#include "thesis/parallel_frame.h"

namespace foam::cuda {
namespace {

class DeviceJunctions final : public Equilibrator {
public:
  explicit DeviceJunctions(const EquilibratorOptions& options)
      : options_(options), jacobi_(gpu_, options.junction) {}

  EquilibriumReport equilibrate(Foam& foam, double /*t1_length*/,
                                const AbortCheck& aborted) override {
    foam_.upload(foam);
    const FoamView mesh = foam_.view();
    jacobi_.prepare(mesh);
    foam.report =
        thesis::sweep_to_rest(gpu_, mesh, options_, aborted, [&] { return jacobi_.sweep(mesh); });
    foam_.download(foam);
    return foam.report;
  }

  void forget() override {}

private:
  EquilibratorOptions options_;
  Gpu gpu_;
  thesis::JacobiSweep<Gpu> jacobi_;
  DeviceFoam foam_;
};

} // namespace

std::unique_ptr<Equilibrator> make_equilibrator(const EquilibratorOptions& options) {
  if (options.kind == EquilibratorKind::Newton) {
    return std::make_unique<ExecutorEquilibrator<Gpu, DeviceFoam>>(options, Gpu(),
                                                                   direct_solver_for(options));
  }
  return std::make_unique<DeviceJunctions>(options);
}

std::unique_ptr<Coarsening> make_coarsening(const CoarseningOptions& options) {
  if (options.equilibrator.kind == EquilibratorKind::Newton) {
    return std::make_unique<ResidentCoarsening<NewtonFrame<Gpu>>>(
        options, std::make_unique<NewtonFrameCoarsening>(options),
        direct_solver_for(options.equilibrator));
  }
  return std::make_unique<ResidentCoarsening<ParallelFrame<Gpu>>>(options, nullptr);
}

} // namespace foam::cuda
