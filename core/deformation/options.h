// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "deformation/flow.h"
#include "equilibrium/options.h"

namespace foam {

struct DeformationOptions {
  DeformationKind kind = DeformationKind::SimpleShear;
  double strain_step = 0.01; ///< by which the strain grows in a frame, not 0
  double amplitude = 0; ///< > 0: the strain goes to and fro between ± it; at least |strain_step|
  EquilibratorOptions equilibrator;

  friend bool operator==(const DeformationOptions&, const DeformationOptions&) = default;
};

/// \throws FoamError for options out of range, or an equilibrator that does not go from T1 to T1.
void check(const DeformationOptions& options);

} // namespace foam
