// SPDX-License-Identifier: GPL-3.0-or-later
#include "thesis/junction_step.h"

namespace foam::thesis {

JunctionChange equilibrate_junction(Foam& foam, Junction junction, const JunctionOptions& options) {
  const JunctionStep step = junction_step(foam, junction, options);
  const JunctionChange change = move_junction(foam, junction, step, options);
  const auto& halves = foam.junction_half[junction];
  for (std::size_t k = 0; k < 3; ++k) {
    if (const Bubble b = foam.left(halves[k]); !b.is_outside()) {
      foam.pressure[b] += change.pressure[k] / foam.sides[b];
    }
  }
  return change;
}

} // namespace foam::thesis
