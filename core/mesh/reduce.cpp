// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/reduce.h"

namespace foam {

Foam reduced(const Foam& foam) {
  Foam result = foam;
  if (foam.surroundings.periodic()) {
    const ReducedLattice compact = reduced(foam.surroundings.lattice);
    result.surroundings.lattice = compact.lattice;
    for (Wrap& wrap : result.film_wrap) {
      wrap = compact.wrap(wrap);
    }
  }
  return result;
}

} // namespace foam
