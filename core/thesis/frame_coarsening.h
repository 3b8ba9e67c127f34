// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "coarsening/coarsening.h"
#include "equilibrium/equilibrator.h"

namespace foam {

/// The thesis's frame (3.7, Figures 3.13 and 4.12): one Euler step of diffusion for the target
/// areas, two-sided bubbles, the topological operations that the thresholds ask for, and one
/// equilibration.
class FrameCoarsening final : public Coarsening {
public:
  /// \param options in range. \param equilibrator the thesis's, somewhere
  FrameCoarsening(const CoarseningOptions& options, std::unique_ptr<Equilibrator> equilibrator);

  void restart(Foam foam) override;
  bool advance(const AbortCheck& aborted) override;
  const Foam& foam() const override { return foam_; }

private:
  CoarseningOptions options_;
  std::unique_ptr<Equilibrator> equilibrator_;
  Foam foam_;
};

} // namespace foam
