// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/foam.h"

namespace foam {

/// The same foam on the cell of its torus's shortest periods. What has that already, or is on no
/// torus, stays as it is.
Foam reduced(const Foam& foam);

} // namespace foam
