// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <utility>

#include "equilibrium/equilibrator.h"
#include "equilibrium/far_start.h"
#include "equilibrium/whole_foam_newton.h"

namespace foam {

/// Newton's method for a whole foam on an executor (equilibrium/whole_foam_newton.h): the foam is
/// sent there, brought to equilibrium and fetched back. One that is far from it is first relaxed on
/// the processor as if its gas were soft (relax_compressible). The result is the same to the bit
/// for any number of threads. \tparam Copy of a foam on the executor: upload(foam), view(),
/// download(foam)
template <class Executor, class Copy> class ExecutorEquilibrator final : public Equilibrator {
public:
  /// \param direct see newton::KrylovSolver
  explicit ExecutorEquilibrator(const EquilibratorOptions& options, Executor executor = Executor(),
                                std::unique_ptr<DirectSolver> direct = nullptr)
      : executor_(std::move(executor)), newton_(executor_, options, std::move(direct)),
        most_iterations_(options.maximum_iterations) {}

  EquilibriumReport equilibrate(Foam& foam, double t1_length, const AbortCheck& aborted) override {
    Foam changed = foam;
    const auto is_far = [&](const Foam& start) {
      copy_.upload(start);
      return newton_.is_far(copy_.view());
    };
    equilibrate_from_afar(changed, is_far, t1_length, most_iterations_, aborted,
                          [&](Foam& start, int most_iterations) {
                            copy_.upload(start);
                            const newton::NewtonResult result = newton_.equilibrate(
                                copy_.view(), t1_length, most_iterations, aborted);
                            copy_.download(start);
                            newton::note(start, result);
                          });
    foam = std::move(changed);
    return foam.report;
  }

  void forget() override {}

private:
  Executor executor_;
  newton::WholeFoamNewton<Executor> newton_;
  int most_iterations_;
  Copy copy_;
};

} // namespace foam
