// SPDX-License-Identifier: GPL-3.0-or-later
#include "thesis/junction_step.h"

namespace foam::thesis {

JunctionChange equilibrate_junction(Foam& foam, Index junction, const JunctionOptions& options) {
  const JunctionStep step = junction_step(foam, junction, options);
  const JunctionChange change = move_junction(foam, junction, step, options);
  const auto& halves = foam.junction_half[Foam::size(junction)];
  for (std::size_t k = 0; k < 3; ++k) {
    if (const Index b = foam.left(halves[k]); b != kWorld) {
      foam.pressure[Foam::size(b)] += change.pressure[k] / foam.sides[Foam::size(b)];
    }
  }
  return change;
}

} // namespace foam::thesis
