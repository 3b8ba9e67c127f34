// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coarsening/coarsening.h"
#include "coarsening/newton_frame.h"
#include "parallel/host.h"

namespace foam {

/// Newton's frames (NewtonFrame) on the processor's threads. The same bits for any number of them.
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
  Foam foam_;
};

} // namespace foam
