// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/abort.h"
#include "mesh/foam.h"

namespace foam {

/// Brings a foam that is far from equilibrium within reach of Newton's method: a descent of the
/// energy of a foam whose gas is soft, so that there is no constraint to violate and a local move
/// is as good as a global one.
///
/// A bubble's gas has the pressure p + K(A^τ/A − 1) where it is compressed and p + K(1 − A/A^τ)
/// where it is stretched, with p (N/cm²) what foam.pressure has, and the bulk modulus K a multiple
/// of T/√A^τ. Junction by junction and film by film (nonlinear Gauss–Seidel), each takes one step
/// of Newton's method with a positive definite matrix of its own. Every few sweeps p takes over the
/// stretched gas's pressure (augmented Lagrangian: J. Nocedal, S. J. Wright, Numerical
/// Optimization, 2nd ed., 2006, ch. 17.3), so that areas become right, and films that are short and
/// pulled shut are swapped. The gas is no stiffer than the films at first,
/// so that bubbles find their neighbours before their areas, and hardens while junctions are nearly
/// balanced.
/// \param shortness of films that are short, beside √A^τ of the smaller bubble along them
/// \param closeness largest |Σ forces|/T at a junction, and |A − A^τ|/A^τ of a bubble, to come to
/// \returns whether it did, in a number of sweeps that is enough for any foam that can.
/// \throws Aborted
bool relax_compressible(Foam& foam, double shortness, double closeness, const AbortCheck& aborted);

} // namespace foam
