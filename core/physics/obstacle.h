// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "mesh/foam.h"

namespace foam {

/// What stands most in the way of a foam's equilibrium, in words: the junction whose films pull it
/// the hardest, the film that is bent the most against its pressures, or the bubble whose area is
/// the furthest off, whichever has the largest dimensionless residual (docs/mathematics.md); and
/// what of it is held by a wall, or has shrunk to nothing. A sentence without its full stop.
std::string obstacle(const Foam& foam);

} // namespace foam
