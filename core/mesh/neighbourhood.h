// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "mesh/foam.h"

namespace foam {

/// The given bubbles that are there and so many rings of neighbours around them, ascending.
std::vector<Bubble> rings_around(const Foam& foam, std::span<const Bubble> bubbles, int rings);

} // namespace foam
