// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "algebra/multifrontal_solver.h"
#include "equilibrium/unknowns.h"

namespace foam {

/// Nested dissection (A. George, SIAM J. Numer. Anal. 10 (1973) 345) by where the junctions are:
/// they are halved, and halved again. Of a film that is cut, one junction waits until both halves
/// are done, and so does the pressure of a bubble that is cut. A pressure comes after its bubble's
/// junctions, a half-angle after all that its film touches.
EliminationTree nested_dissection(const Foam& foam, const Region& region, const Unknowns& unknowns);

} // namespace foam
