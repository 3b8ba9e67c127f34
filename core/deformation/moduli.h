// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "deformation/flow.h"
#include "mesh/foam.h"

namespace foam {

/// How the stress of a torus in equilibrium (statistics/stress.h) changes per unit of strain by a
/// flow, N/cm²: by one solution of Newton's equations, with what the flow does to their right-hand
/// side. \param flow velocity gradient without a trace, times the unit of strain
/// \throws FoamError if the foam is not periodic, or its equilibrium has no definite response
SymmetricTensor stress_change(const Foam& foam, const Tensor& flow);

/// G = (1/A)·d²E/dγ², N/cm², at the strain that the torus in equilibrium has: dσ_xy/dγ in simple
/// shear, ¼·d(σ_xx − σ_yy)/dγ in pure shear, so that an isotropic foam has the same in both.
/// \throws FoamError likewise
double shear_modulus(Foam foam, DeformationKind kind);

} // namespace foam
