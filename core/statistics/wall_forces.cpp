// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/wall_forces.h"

namespace foam {

std::vector<WallForce> wall_forces(const Foam& foam) {
  std::vector<WallForce> forces;
  if (!foam.surroundings.has_walls()) {
    return forces;
  }
  forces.resize(foam.exterior.size());
  for (const Junction j : foam.junction_slots()) {
    if (foam.has_junction(j) && foam.on_wall(j)) {
      const Half h = foam.off_wall(j);
      forces[foam.piece_outside[foam.junction_piece[j]].place()].network +=
          foam.tension(h.film()) * foam.tangent(h);
    }
  }
  for (const Half h : foam.half_slots()) {
    if (foam.start(h) != kNone && foam.solid(foam.right(h))) {
      forces[foam.right(h).outside().place()].pressure -=
          foam.pressure_of(foam.left(h)) * left_normal(foam.chord(h));
    }
  }
  return forces;
}

} // namespace foam
