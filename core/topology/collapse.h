// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "topology/cascade.h"

namespace foam {

/// Where to look next after a topological operation.
struct Aftermath {
  bool performed = false;
  std::vector<Index> films;   ///< prolonged by it
  std::vector<Index> bubbles; ///< that lost a side or two, without the world
};

/// Performs topological operations one at a time, each where it can be performed and the rules ask
/// for it, and remembers the bubbles around them. What the thesis's algorithms for whole foams are
/// made of.
class Collapse {
public:
  Collapse(Foam& foam, const CollapseRules& rules) : foam_(foam), rules_(rules) {}

  /// Swaps the film.
  Aftermath film(Index film);
  /// Removes the bubble, by a T2 or a T3.
  Aftermath bubble(Index bubble);

  CascadeResult result() &&;

private:
  void note(Index bubble);

  Foam& foam_;
  const CollapseRules& rules_;
  std::vector<Index> around_;
};

} // namespace foam
