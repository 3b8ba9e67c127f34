// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>

#include "equilibrium/equilibrator.h"
#include "mesh/element_measures.h"

namespace foam {

double max_angle_error(const Foam& foam) {
  double largest = 0;
  for (Index j = 0; j < foam.junction_capacity(); ++j) {
    if (foam.has_junction(j) && !foam.pinned(j)) {
      largest = std::max(largest, angle_error(foam, j));
    }
  }
  return largest;
}

double max_area_error(const Foam& foam) {
  double largest = 0;
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    if (foam.has_bubble(b)) {
      largest = std::max(largest, area_error(foam, b));
    }
  }
  return largest;
}

} // namespace foam
