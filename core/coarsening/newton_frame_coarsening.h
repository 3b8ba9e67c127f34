// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coarsening/coarsening.h"
#include "coarsening/newton_frame.h"
#include "equilibrium/newton_equilibrator.h"
#include "parallel/host.h"

namespace foam {

/// Newton's frames (NewtonFrame) on the processor's threads. The same bits for any number of them.
/// Where MINRES leads to no equilibrium the frame is done with factorisations, which keep arcs
/// about 90° their half-angles and tell a minimum from a saddle.
class NewtonFrameCoarsening final : public Coarsening {
public:
  /// \param options in range: make_coarsening checks them.
  /// \param threads, least_per_thread as Host has them
  explicit NewtonFrameCoarsening(const CoarseningOptions& options, int threads = 0,
                                 std::size_t least_per_thread = 8192);

  void restart(Foam foam) override;
  bool advance(const AbortCheck& aborted) override;
  const Foam& foam() const override { return foam_; }

private:
  CoarseningOptions options_;
  Host host_;
  NewtonFrame<Host> frame_;
  NewtonEquilibrator in_need_;
  Foam foam_;
};

} // namespace foam
