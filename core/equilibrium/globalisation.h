// SPDX-License-Identifier: GPL-3.0-or-later
//
// What keeps Newton's method on the way down while it is far from the solution.
#pragma once

#include "equilibrium/lagrangian_system.h"

namespace foam {

/// The unknowns of a region, to step from and to return to.
class Snapshot {
public:
  Snapshot(const Foam& foam, const Region& region);

  void restore(Foam& foam) const;
  /// The snapshot plus a fraction of a step.
  void advance(Foam& foam, const Step& step, double fraction) const;

private:
  const Region& region_;
  Step values_;
};

/// The largest fraction ≤ 1 of a step with which no film shrinks or turns by more than half of its
/// length and no arc by more than half a radian.
double longest_step(const Foam& foam, const LagrangianSystem& system, const Step& step);

/// The step, but no junction moves by more than a part of its shortest film and no arc turns by
/// more than half a radian. Where one film alone is in the way of a whole foam this gets on, though
/// it is no direction of descent for sure.
Step limited_step(const Foam& foam, const LagrangianSystem& system, const Step& step);

/// The exact penalty function of a region along a step, T·Σl − Σ_rim p·A + μ·Σ|A − A^τ|: films'
/// energy, less the work of bubbles whose pressure is held, and the areas' violation (J. Nocedal,
/// S. J. Wright, Numerical Optimization, 2nd ed., 2006, ch. 18).
class Merit {
public:
  Merit(const Foam& foam, const LagrangianSystem& system, const Step& step);

  double operator()(const Foam& foam) const;

private:
  double violation(const Foam& foam) const;
  double penalty(const Foam& foam, const LagrangianSystem& system, const Step& step) const;

  const Region& region_;
  double mu_;
};

} // namespace foam
