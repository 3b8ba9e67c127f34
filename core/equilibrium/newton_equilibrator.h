// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <unordered_map>
#include <vector>

#include "equilibrium/equilibrator.h"
#include "equilibrium/lagrangian_system.h"
#include "equilibrium/options.h"

namespace foam {

/// Newton's method on junctions, half-angles and pressures at once.
///
/// Steps are globalised by energy: each is a direction for the exact penalty function
/// T·Σl + μ·Σ|A − A^τ| with μ above the largest pressure (J. Nocedal, S. J. Wright, Numerical
/// Optimization, 2nd ed., 2006, ch. 18), from a matrix whose inertia is that of a minimum; no film
/// shrinks or turns by more than half of its length in one step, no arc by more than half a radian.
/// A foam far from equilibrium is first relaxed as if its gas were soft (relax_compressible). Films
/// that are short and pulled shut are swapped on the way. Close to the solution a factorisation
/// serves as long as the iteration contracts.
class NewtonEquilibrator final : public Equilibrator {
public:
  explicit NewtonEquilibrator(const EquilibratorOptions& options);

  EquilibriumReport equilibrate(Foam& foam, double t1_length, const AbortCheck& aborted) override;
  void forget() override;

  /// The same to another tolerance.
  EquilibriumReport equilibrate_to(Foam& foam, double tolerance, double t1_length,
                                   const AbortCheck& aborted);

  /// Relaxes a patch of a few rings around some bubbles, roughly: what lies beyond has not moved.
  /// \param prepare called with every region before it is looked at.
  /// \returns whether it found an equilibrium of the patch.
  bool relax_patch(Foam& foam, std::span<const Index> bubbles, double t1_length,
                   const std::function<void(const Region&)>& prepare, const AbortCheck& aborted);
  /// Iterations of the last call.
  int iterations() const { return iterations_; }

  /// How a foam in equilibrium moves while its target areas change (LagrangianSystem::response),
  /// in the order of region(); nothing if it has no definite response.
  const Step* response(const Foam& foam, const std::vector<double>& area_rate,
                       const Rates& expected, double drift);
  const Region& region() const { return whole_.region(); }
  /// The same of the last patch, in the order of patch_region(). \param around how the rest of the
  /// foam moves
  const Step* patch_response(const Foam& foam, const std::vector<double>& area_rate,
                             const Rates& around, double drift);
  const Region& patch_region() const { return patch_.region(); }

private:
  const Step* response(LagrangianSystem& system, const Foam& foam,
                       const std::vector<double>& area_rate, const Rates& expected,
                       double drift) const;

  struct Outcome {
    bool converged = false;
    Residual residual;
  };

  void relax_rough_spots(Foam& foam, double t1_length, const AbortCheck& aborted);
  bool relax_patch_to(double tolerance, Foam& foam, std::span<const Index> bubbles,
                      double t1_length, const std::function<void(const Region&)>& prepare,
                      const AbortCheck& aborted);
  template <class MakeRegion>
  Outcome relax(Foam& foam, LagrangianSystem& system, const MakeRegion& make_region,
                double tolerance, double t1_length, const AbortCheck& aborted);
  bool reuse_factorisation(Foam& foam, LagrangianSystem& system, double tolerance,
                           Residual& residual, bool& adapted);
  bool search_line(Foam& foam, LagrangianSystem& system, const Step& step, Residual& residual);
  std::vector<Index> closing_films(const Foam& foam, const LagrangianSystem& system,
                                   const Step& step, double t1_length) const;
  std::vector<Index> swap_films(Foam& foam, std::span<const Index> films);
  bool hemmed_in(const Foam& foam);
  EquilibriumReport report(Foam& foam, const Outcome& outcome) const;

  EquilibratorOptions options_;
  LagrangianSystem whole_;
  LagrangianSystem patch_;
  int iterations_ = 0;
  std::unordered_map<Index, int> swaps_; ///< of films in this call
};

} // namespace foam
