// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/filling.h"

#include <cmath>

#include "base/error.h"

namespace foam {

double space_of(const Foam& foam) {
  if (foam.surroundings.periodic()) {
    return foam.surroundings.lattice.area();
  }
  double covered = 0;
  for (const Bubble b : foam.bubble_slots()) {
    covered += foam.has_bubble(b) ? foam.area(b) : 0;
  }
  return covered;
}

double fill_space(Foam& foam, double slack, const std::string& remedy) {
  if (!foam.surroundings.closed()) {
    return 1;
  }
  double targets = 0;
  for (const Bubble b : foam.bubble_slots()) {
    targets += foam.has_bubble(b) ? foam.target_area[b] : 0;
  }
  const bool torus = foam.surroundings.periodic();
  const double space = space_of(foam);
  if (!(std::abs(targets - space) <= slack * space) || !std::isfinite(targets)) {
    throw FoamError("the target areas add up to " + number(targets) + ", but the area of the " +
                    (torus ? "torus" : "container") + " is " + number(space) + ": " + remedy);
  }
  for (double& area : foam.target_area) {
    area *= space / targets;
  }
  return space / targets;
}

} // namespace foam
