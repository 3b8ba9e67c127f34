// SPDX-License-Identifier: GPL-3.0-or-later
#include "thesis/cuda_junction_equilibrator.h"

#include "mesh/device_foam.h"
#include "parallel/gpu.cuh"
#include "thesis/jacobi_sweep.h"

namespace foam::cuda {
namespace {

class CudaJunctionEquilibrator final : public Equilibrator {
public:
  explicit CudaJunctionEquilibrator(const EquilibratorOptions& options)
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

std::unique_ptr<Equilibrator> make_junction_equilibrator(const EquilibratorOptions& options) {
  return std::make_unique<CudaJunctionEquilibrator>(options);
}

} // namespace foam::cuda
