// SPDX-License-Identifier: GPL-3.0-or-later
#include "deformation/flow.h"

namespace foam {

void strain(Foam& foam, const Tensor& deformation) {
  Lattice& lattice = foam.surroundings.lattice;
  lattice = {deformation * lattice.origin, deformation * lattice.first,
             deformation * lattice.second};
  for (Vec2& place : foam.position) {
    place = deformation * place;
  }
}

void make_compact(Foam& foam) {
  const ReducedLattice compact = reduced(foam.surroundings.lattice);
  if (compact.lattice == foam.surroundings.lattice) {
    return;
  }
  foam.surroundings.lattice = compact.lattice;
  for (Wrap& wrap : foam.film_wrap) {
    wrap = compact.wrap(wrap);
  }
}

} // namespace foam
