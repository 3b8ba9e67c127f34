// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <span>
#include <vector>

#include "mesh/foam.h"

namespace foam {

/// When a film or a bubble wants to give way. Whether it can is checked by the algorithm, before
/// the rule is asked. An empty rule means never.
struct CollapseRules {
  std::function<bool(const Foam&, Film)> t1;   ///< of a film: swap it
  std::function<bool(const Foam&, Bubble)> t2; ///< of a three-sided bubble: remove it
  std::function<bool(const Foam&, Bubble)> t3; ///< of a two-sided bubble: remove it
};

/// What topological operations have left behind.
struct CascadeResult {
  /// The bubbles around the events, those that lost and those that gained a side, as far as they
  /// still exist; ascending, each once.
  std::vector<Bubble> bubbles;

  bool changed() const { return !bubbles.empty(); }
};

/// Performs all topological operations that the rules ask for, by the thesis's final algorithm
/// (4.3, Figures 4.8 to 4.11): first every bubble is tested for a T2, then every film for a T1. The
/// two bubbles that lose a side in a T1 are tested for a T2 at once; the bubbles around a T2 are
/// tested again at once and its three films after all others, until both queues are empty. Here a
/// T3 is tested for wherever a T2 is.
///
/// Only a T2 or a T3 puts films back into the queue, and every one of them uses up a bubble: a foam
/// of f films and b bubbles ends after at most f + 3b tests for a T1, whatever the rules say. A
/// film that has been swapped is tested again only if a bubble beside it has vanished since.
CascadeResult topological_cascade(Foam& foam, const CollapseRules& rules);

/// The same, beginning with the given films and bubbles alone. Those that no longer exist are
/// passed over.
CascadeResult topological_cascade(Foam& foam, const CollapseRules& rules,
                                  std::span<const Film> films, std::span<const Bubble> bubbles);

} // namespace foam
