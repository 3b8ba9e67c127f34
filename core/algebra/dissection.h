// SPDX-License-Identifier: GPL-3.0-or-later
//
// Nested dissection (A. George, SIAM J. Numer. Anal. 10 (1973) 345) of unknowns that lie in a
// plane: a binary tree that says which are eliminated before which.
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "algebra/multifrontal_solver.h"
#include "geometry/vec2.h"

namespace foam {

/// A node of the tree. They are numbered from the root, 1; those below p are 2p and 2p + 1.
using TreePlace = std::uint32_t;
inline constexpr TreePlace kNowhere = 0;
inline constexpr TreePlace kRoot = 1;

/// The lowest that is above both, or one of them.
inline TreePlace common(TreePlace a, TreePlace b) {
  if (a == kNowhere || b == kNowhere) {
    return std::max(a, b);
  }
  while (a != b) {
    (a > b ? a : b) >>= 1;
  }
  return a;
}

/// Of two, one of them above the other, the upper one.
inline TreePlace upper(TreePlace a, TreePlace b) {
  return a == kNowhere || b == kNowhere ? std::max(a, b) : std::min(a, b);
}

/// Levels of a tree for so many points, below its root.
int levels_for(std::size_t points);

/// Halves points across the longer side of what they cover, then the halves, and so on.
/// \returns for each point its leaf, a node of the lowest level
std::vector<TreePlace> bisect(std::span<const Vec2> points, int levels);

/// The order in which all below a node is eliminated before it.
/// \param places where each unknown is eliminated: two that share an equation are in one place, or
/// one is above the other. \param levels of the tree
EliminationTree elimination_tree(std::span<const TreePlace> places, int levels);

} // namespace foam
