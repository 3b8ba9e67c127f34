// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "equilibrium/equilibrator.h"
#include "equilibrium/parallel_newton.h"
#include "parallel/host.h"

namespace foam {

/// ParallelNewton on the processor's threads: Newton's method for a whole foam without a matrix to
/// factorise. A foam far from equilibrium is first relaxed as if its gas were soft
/// (relax_compressible). The result is the same to the bit for any number of threads.
class KrylovEquilibrator final : public Equilibrator {
public:
  /// \param threads 0 stands for all there are. \param least_per_thread see Host.
  explicit KrylovEquilibrator(const EquilibratorOptions& options, int threads = 0,
                              std::size_t least_per_thread = 8192);

  EquilibriumReport equilibrate(Foam& foam, double t1_length, const AbortCheck& aborted) override;
  void forget() override {}

private:
  Host host_;
  newton::ParallelNewton<Host> newton_;
};

} // namespace foam
