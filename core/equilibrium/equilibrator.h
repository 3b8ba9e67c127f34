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

/// Largest deviation at junctions that may move from the angles that their films' tensions ask for
/// (rad).
double max_angle_error(const Foam& foam);

/// Largest |A − A^τ|/A^τ.
double max_area_error(const Foam& foam);

/// Largest |2 sin α − q·d/T| of films: how far they are from Laplace and Young's law. One whose
/// pressure difference q asks for less than half its chord d as radius counts as a half circle.
double max_curvature_error(const Foam& foam);

/// How far a foam is from equilibrium, found by measuring it. Nobody has said that it converged.
EquilibriumReport measured_report(const Foam& foam);

/// A report of a foam, if it is true: if the foam's angles, areas and curvatures are no further off
/// than it says and than they can be by rounding. Otherwise what is measured, not `converged`.
/// \param rounding of a coordinate, cm
EquilibriumReport confirmed(const EquilibriumReport& report, const Foam& foam, double rounding);

} // namespace foam
