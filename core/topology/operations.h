// SPDX-License-Identifier: GPL-3.0-or-later
//
// The topological operations on a whole foam, which counts them.
#pragma once

#include <array>
#include <cstdint>
#include <span>

#include "mesh/foam.h"
#include "topology/local_operations.h"

namespace foam {

/// A record's number of operations of a kind.
std::int64_t& count_of(FoamRecord& record, TopologicalOperation::Kind kind);

/// Notes what has been done to the foam's arrays, at its time.
void note_performed(Foam& foam, TopologicalOperation performed);
void note_performed(Foam& foam, std::span<const TopologicalOperation> performed);

/// Swaps a film (swap_film). \returns the two bubbles that lost a side.
std::array<Bubble, 2> perform_t1(Foam& foam, Film film);

/// Removes a three-sided bubble (remove_three_sided_bubble).
T2Result perform_t2(Foam& foam, Bubble bubble);

/// Removes a two-sided bubble (remove_two_sided_bubble). \returns its two neighbours.
std::array<Bubble, 2> perform_t3(Foam& foam, Bubble bubble);

} // namespace foam
