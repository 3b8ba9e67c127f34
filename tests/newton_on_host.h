// SPDX-License-Identifier: GPL-3.0-or-later
//
// What runs on a GPU, on the processor; compiled once, in newton_on_host.cpp.
#pragma once

#include <memory>

#include "equilibrium/equilibrator.h"
#include "equilibrium/options.h"
#include "equilibrium/whole_foam_newton.h"
#include "newton_system.h"
#include "parallel/host.h"

namespace foam::test {

/// ExecutorEquilibrator on the processor.
class KrylovEquilibrator final : public Equilibrator {
public:
  explicit KrylovEquilibrator(const EquilibratorOptions& options, const Host& host = Host());

  EquilibriumReport equilibrate(Foam& foam, double t1_length, const AbortCheck& aborted) override {
    return method_->equilibrate(foam, t1_length, aborted);
  }
  void forget() override { method_->forget(); }

private:
  std::unique_ptr<Equilibrator> method_;
};

/// WholeFoamNewton on the processor. \param direct see newton::KrylovSolver
newton::NewtonResult equilibrate_on_host(const FoamView& mesh, const EquilibratorOptions& options,
                                         double t1_length,
                                         std::unique_ptr<DirectSolver> direct = nullptr);

extern template class NewtonSystem<Host>;

} // namespace foam::test
