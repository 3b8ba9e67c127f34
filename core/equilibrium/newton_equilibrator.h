// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "equilibrium/equilibrator.h"
#include "equilibrium/factorising_solver.h"
#include "equilibrium/newton.h"
#include "equilibrium/options.h"
#include "equilibrium/swaps.h"

namespace foam {

/// Newton's method (equilibrium/newton.h) on a foam or a patch of it, with a matrix that is
/// factorised (equilibrium/factorising_solver.h). A foam far from equilibrium is first relaxed as
/// if its gas were soft (relax_compressible).
class NewtonEquilibrator final : public Equilibrator {
public:
  explicit NewtonEquilibrator(const EquilibratorOptions& options);

  EquilibriumReport equilibrate(Foam& foam, double t1_length, const AbortCheck& aborted) override;
  void forget() override;

  /// The same to another tolerance, from a foam that is not far, in so many iterations at most.
  EquilibriumReport equilibrate_to(Foam& foam, double tolerance, double t1_length,
                                   int most_iterations, const AbortCheck& aborted);

  /// Relaxes a patch of a few rings around some bubbles, roughly: what lies beyond has not moved.
  /// \param prepare called with every region before it is looked at.
  /// \returns whether it found an equilibrium of the patch.
  bool relax_patch(Foam& foam, std::span<const Bubble> bubbles, double t1_length,
                   const std::function<void(const Region&)>& prepare, const AbortCheck& aborted);
  /// Iterations of the last call.
  int iterations() const { return iterations_; }

  /// How a foam in equilibrium moves while its target areas change, or a torus is strained
  /// (newton::FactorisingSolver::response); null if it has no definite response. Of the elements of
  /// region().
  const newton::StepView* response(const Foam& foam, const Field<Bubble, double>& area_rate,
                                   const Rates& expected, double drift, const Tensor& flow = {});
  const Region& region() const { return whole_.region(); }
  /// The same of the last patch and patch_region(). \param around how the rest of the foam moves
  const newton::StepView* patch_response(const Foam& foam, const Field<Bubble, double>& area_rate,
                                         const Rates& around, double drift);
  const Region& patch_region() const { return patch_.region(); }

private:
  /// Of the bubbles around the films swapped last.
  using MakeRegion = std::function<Region(const Foam&, std::span<const Bubble> touched)>;
  class Problem;

  bool is_far(Foam& foam);
  void relax_to(Foam& foam, double tolerance, double t1_length, int most_iterations,
                const AbortCheck& aborted);
  void relax_unrelaxed_regions(Foam& foam, double t1_length, int most_iterations,
                               const AbortCheck& aborted);
  bool relax_patch_to(double tolerance, Foam& foam, std::span<const Bubble> bubbles,
                      double t1_length, int most_iterations,
                      const std::function<void(const Region&)>& prepare, const AbortCheck& aborted);
  std::vector<Bubble> unrelaxed_bubbles(const Foam& foam) const;

  EquilibratorOptions options_;
  Host host_;
  newton::Newton<Host> newton_;
  newton::FactorisingSolver whole_;
  newton::FactorisingSolver patch_;
  newton::SwapsInTurn swaps_;
  int iterations_ = 0;
};

} // namespace foam
