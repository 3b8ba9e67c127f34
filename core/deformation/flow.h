// SPDX-License-Identifier: GPL-3.0-or-later
//
// How a torus is strained: by its periods, and with them everywhere alike.
#pragma once

#include "geometry/tensor.h"
#include "mesh/foam.h"

namespace foam {

enum class DeformationKind {
  SimpleShear, ///< rows along x slide over each other: F = [1 γ; 0 1]
  PureShear    ///< x is stretched and y compressed: F = diag(e^γ, e^−γ)
};

/// dF/dγ·F⁻¹, the velocity gradient per unit of strain: F = exp(γ·L).
inline Tensor velocity_gradient(DeformationKind kind) {
  return kind == DeformationKind::SimpleShear ? Tensor{0, 1, 0, 0} : Tensor{1, 0, 0, -1};
}

/// Strains a torus by F about its lattice's origin: its periods and the places of its junctions.
/// Half-angles and pressures stay, so that it is out of equilibrium.
void strain(Foam& foam, const Tensor& deformation);

/// Describes a torus by its shortest periods (reduced), and by the images of its junctions in its
/// cell. The foam stays where it is.
void make_compact(Foam& foam);

} // namespace foam
