// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "equilibrium/equilibrator.h"
#include "equilibrium/lagrangian_system.h"

namespace foam {

/// Newton's method on junctions, half-angles and pressures at once.
///
/// Steps are globalised by energy: each is a direction for the exact penalty function
/// T·Σl + μ·Σ|A − A^τ| with μ above the largest pressure (J. Nocedal, S. J. Wright, Numerical
/// Optimization, 2nd ed., 2006, ch. 18), from a matrix whose inertia is that of a minimum; no film
/// shrinks or turns by more than half of its length in one step, no arc by more than half a radian.
/// Films that are short and pulled shut are swapped on the way. Close to the solution a
/// factorisation serves as long as the iteration contracts.
class NewtonEquilibrator final : public Equilibrator {
public:
  explicit NewtonEquilibrator(const EquilibratorOptions& options);

  EquilibriumReport equilibrate(Foam& foam, double t1_length, const AbortCheck& aborted) override;
  void forget() override;

  /// The same to another tolerance, for a foam that is far from equilibrium only around some
  /// bubbles (or none): a patch of a few rings around them first, then all.
  EquilibriumReport equilibrate_around(Foam& foam, std::span<const Index> bubbles, double tolerance,
                                       double t1_length, const AbortCheck& aborted);

  /// How a foam in equilibrium moves while its target areas change (LagrangianSystem::response),
  /// in the order of region().
  const Step& response(const Foam& foam, const std::vector<double>& area_rate);
  const Region& region() const { return whole_.region(); }
  /// How a step of the whole foam changes the chord of a film, cm.
  Vec2 chord_change(const Foam& foam, Index film, const Step& step) const {
    return whole_.chord_change(foam, film, step);
  }

private:
  struct Outcome {
    bool converged = false;
    Residual residual;
  };

  template <class MakeRegion>
  Outcome relax(Foam& foam, LagrangianSystem& system, const MakeRegion& make_region,
                double tolerance, double t1_length, const AbortCheck& aborted);
  bool reuse_factorisation(Foam& foam, LagrangianSystem& system, double tolerance,
                           Residual& residual);
  bool search_line(Foam& foam, LagrangianSystem& system, const Step& step, Residual& residual);
  std::vector<Index> swap_films(Foam& foam, const LagrangianSystem& system, const Step& step,
                                double t1_length);
  EquilibriumReport report(Foam& foam, const Outcome& outcome) const;

  EquilibratorOptions options_;
  LagrangianSystem whole_;
  LagrangianSystem patch_;
  int iterations_ = 0;
  std::vector<unsigned char> swaps_; ///< of each film in this call
};

} // namespace foam
