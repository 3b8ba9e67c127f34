// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "topology/cascade.h"

namespace foam {

/// Where to look next after a topological operation.
struct Affected {
  bool performed = false;
  std::vector<Film> films;     ///< prolonged by it
  std::vector<Bubble> bubbles; ///< that lost a side or two, without outsides
};

/// Performs topological operations one at a time, each where it can be performed and the rules ask
/// for it, and remembers the bubbles around them. What the thesis's algorithms for whole foams are
/// made of.
class Collapse {
public:
  Collapse(Foam& foam, const CollapseRules& rules) : foam_(foam), rules_(rules) {}

  /// Swaps the film.
  Affected film(Film film);
  /// Removes the bubble, by a T2 or a T3.
  Affected bubble(Bubble bubble);

  CascadeResult result() &&;

private:
  void note(Bubble bubble);

  Foam& foam_;
  const CollapseRules& rules_;
  std::vector<Bubble> around_;
};

} // namespace foam
