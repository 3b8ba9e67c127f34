// SPDX-License-Identifier: GPL-3.0-or-later
#include "newton_on_host.h"

#include <utility>

#include "equilibrium/executor_equilibrator.h"
#include "newton_system_members.h"

namespace foam::test {

namespace {

/// A foam's copy on the processor, as ExecutorEquilibrator wants one.
class HostCopy {
public:
  void upload(const Foam& foam) { foam_ = foam; }
  FoamView view() { return view_of(foam_); }
  void download(Foam& foam) const {
    static_cast<FoamArrays<Field>&>(foam) = static_cast<const FoamArrays<Field>&>(foam_);
  }

private:
  Foam foam_;
};

} // namespace

KrylovEquilibrator::KrylovEquilibrator(const EquilibratorOptions& options, const Host& host)
    : method_(std::make_unique<ExecutorEquilibrator<Host, HostCopy>>(options, host)) {}

newton::NewtonResult equilibrate_on_host(const FoamView& mesh, const EquilibratorOptions& options,
                                         double t1_length, std::unique_ptr<DirectSolver> direct) {
  Host host;
  newton::WholeFoamNewton<Host> newton(host, options, std::move(direct));
  return newton.equilibrate(mesh, t1_length, {});
}

template class NewtonSystem<Host>;

} // namespace foam::test
