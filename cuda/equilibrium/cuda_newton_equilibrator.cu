// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/cuda_newton_equilibrator.h"

#include <utility>

#include "algebra/device_direct_solver.h"
#include "equilibrium/compressible_relaxation.h"
#include "equilibrium/parallel_newton.h"
#include "mesh/device_foam.h"
#include "parallel/gpu.cuh"

namespace foam::cuda {
namespace {

class CudaNewtonEquilibrator final : public Equilibrator {
public:
  explicit CudaNewtonEquilibrator(const EquilibratorOptions& options)
      : newton_(gpu_, options, direct_solver_for(options)) {}

  EquilibriumReport equilibrate(Foam& foam, double t1_length, const AbortCheck& aborted) override {
    Foam changed = foam;
    foam_.upload(changed);
    if (newton_.hemmed_in(foam_.view())) {
      relax_compressible(changed, t1_length, aborted);
      foam_.upload(changed);
    }
    const newton::NewtonResult result = newton_.equilibrate(foam_.view(), t1_length, aborted);
    foam_.download(changed);
    foam = std::move(changed);
    newton::note(foam, result);
    return foam.report;
  }

  void forget() override {}

private:
  Gpu gpu_;
  newton::ParallelNewton<Gpu> newton_;
  DeviceFoam foam_;
};

} // namespace

std::unique_ptr<Equilibrator> make_newton_equilibrator(const EquilibratorOptions& options) {
  return std::make_unique<CudaNewtonEquilibrator>(options);
}

} // namespace foam::cuda
