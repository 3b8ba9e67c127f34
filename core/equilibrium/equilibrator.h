// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/abort.h"
#include "mesh/foam.h"

namespace foam {

/// Finds a foam's equilibrium.
class Equilibrator {
public:
  Equilibrator() = default;
  Equilibrator(const Equilibrator&) = delete;
  Equilibrator& operator=(const Equilibrator&) = delete;
  virtual ~Equilibrator() = default;

  /// Brings the foam to equilibrium. A method that swaps films on the way (T1) swaps those that are
  /// shorter than t1_length (cm) and pulled shut.
  /// \returns what was reached, which is also left in foam.report: a foam that did not reach
  /// equilibrium is not `converged`.
  /// \throws Aborted, or what else goes wrong, with the foam as it was, or on its way and with what
  /// was measured of it as foam.report
  virtual EquilibriumReport equilibrate(Foam& foam, double t1_length,
                                        const AbortCheck& aborted) = 0;

  /// Drops all that is kept from earlier calls, so that the next result depends on the foam alone.
  virtual void forget() = 0;
};

} // namespace foam
