// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "mesh/foam.h"
#include "physics/thresholds.h"

namespace foam {

/// The end of a run at its last foam. \param bubble that is to vanish; if none is given the
/// smallest, or the largest if all vanish \param limit in force, in the foam's units
End end_at(const Foam& last, End::Cause cause, const Thresholds& limit, Bubble bubble = kNone);

/// An end in words: what stands in the way, with its figures, and what would help.
std::string reason(const End& end);

} // namespace foam
