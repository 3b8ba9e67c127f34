// SPDX-License-Identifier: GPL-3.0-or-later
//
// The two algorithms for topological operations that the thesis gives up for its final one
// (topological_cascade), kept for comparison.
#pragma once

#include <functional>

#include "topology/cascade.h"

namespace foam {

/// The original algorithm (thesis Figure 4.4, from Kelager): one walk over the junctions, in each
/// of which either a bubble is removed, or a film swapped, or, where nothing wants to give way, the
/// junction equilibrated. It misses cascades.
CascadeResult original_algorithm(Foam& foam, const CollapseRules& rules,
                                 const std::function<void(Foam&, Junction junction)>& equilibrate);

/// The improved algorithm (thesis Figure 4.6): all bubbles, then all films, again and again until
/// nothing gives way. It misses a T2 that one T1 makes possible and the next one impossible.
///
/// The thesis's loop does not end where films are swapped back and forth. Here a film is swapped at
/// most three times in a call.
CascadeResult improved_algorithm(Foam& foam, const CollapseRules& rules);

} // namespace foam
