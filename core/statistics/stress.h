// SPDX-License-Identifier: GPL-3.0-or-later
//
// The stress of a foam, exact for arcs (G. K. Batchelor, J. Fluid Mech. 41 (1970) 545): over an
// area A, with the films' unit tangents t,
//
//   σ = (1/A)·[Σ_films T·∫t⊗t ds − Σ_bubbles p·A_b·I],
//
// tension positive. A bubble's own has the half of each film beside another bubble and the whole of
// one beside an outside, so that the foam's is the mean over its bubbles, weighted by area. In
// closed surroundings the pressures have a constant in common that means nothing, and so has the
// isotropic part; the shear stress σ_xy and the normal stress difference N₁ = σ_xx − σ_yy have none
// of it. Strained at a rate L without a trace, a torus gains energy at dE/dt = A·σ:L. A free
// cluster in equilibrium has no stress (the virial theorem).
#pragma once

#include <vector>

#include "geometry/tensor.h"
#include "mesh/foam.h"
#include "statistics/statistics.h"

namespace foam {

/// Of the whole foam, N/cm².
SymmetricTensor mean_stress(const std::vector<BubbleStatistics>& bubbles);
SymmetricTensor stress(const Foam& foam);

/// N₁ = σ_xx − σ_yy, N/cm².
inline double normal_stress_difference(const SymmetricTensor& stress) {
  return stress.xx - stress.yy;
}

/// The texture M = ⟨ℓ⊗ℓ⟩, cm², over the links ℓ between the centroids of bubbles that share a film
/// (M. Aubouy, Y. Jiang, J. A. Glazier, F. Graner, Granul. Matter 5 (2003) 67), each film once. A
/// torus that is strained by F without a T1, with its centroids, has F·M·Fᵀ then. \pre two bubbles
/// share a film
SymmetricTensor texture(const Foam& foam);

} // namespace foam
