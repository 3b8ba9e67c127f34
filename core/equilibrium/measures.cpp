// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>
#include <numbers>

#include "equilibrium/equilibrator.h"

namespace foam {

double max_angle_error(const Foam& foam) {
  double largest = 0;
  for (Index j = 0; j < foam.junction_capacity(); ++j) {
    if (!foam.has_junction(j) || foam.pinned(j)) {
      continue;
    }
    const auto& halves = foam.junction_half[Foam::size(j)];
    const std::array tangents{foam.tangent(halves[0]), foam.tangent(halves[1]),
                              foam.tangent(halves[2])};
    for (std::size_t k = 0; k < 3; ++k) {
      const double angle = angle_from_to(tangents[k], tangents[(k + 1) % 3]);
      const double positive = angle < 0 ? angle + 2 * std::numbers::pi : angle;
      largest = std::max(largest, std::abs(positive - 2 * std::numbers::pi / 3));
    }
  }
  return largest;
}

double max_area_error(const Foam& foam) {
  double largest = 0;
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    if (foam.has_bubble(b)) {
      const double target = foam.target_area[Foam::size(b)];
      largest = std::max(largest, std::abs(foam.area(b) - target) / target);
    }
  }
  return largest;
}

} // namespace foam
