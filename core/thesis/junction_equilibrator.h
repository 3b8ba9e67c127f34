// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "equilibrium/equilibrator.h"
#include "equilibrium/options.h"
#include "parallel/host.h"
#include "thesis/jacobi_sweep.h"

namespace foam {

/// The thesis's own method (B. K. Vedel-Larsen, Quasi-static Simulation of Foam in the Vertex
/// Model, 2010, chapters 3 and 4): every junction in turn is brought nearer to 120° and its bubbles
/// nearer to their target areas, until the changes no longer change. It is local, stops where its
/// halting rule says so and not at an equilibrium, cannot express arcs beyond the half circle, and
/// may diverge; all that is the thesis's. `converged` says that the rule was met and that no
/// junction is inverted and no bubble inside out, not that the foam is in equilibrium:
/// max_angle_error and max_area_error say how far it is from that.
///
/// With RootSearch::Energies it asks what the thesis proposes in its 7.1.1, see EnergyRootSearch.
///
/// It knows one tension: a foam of films with their own is refused. Topology is left alone:
/// t1_length is not used. The result depends on the foam alone, not on the number of threads.
class JunctionEquilibrator final : public Equilibrator {
public:
  /// \param options in range. \param threads that a Jacobi sweep may use; 0 stands for all there
  /// are.
  explicit JunctionEquilibrator(const EquilibratorOptions& options, int threads = 0);

  EquilibriumReport equilibrate(Foam& foam, double t1_length, const AbortCheck& aborted) override;
  void forget() override {}

private:
  EquilibratorOptions options_;
  Host host_;
  thesis::JacobiSweep<Host> jacobi_;
};

} // namespace foam
