// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>

#include "geometry/vec2.h"
#include "mesh/ids.h"

namespace foam {

// Displacements in a vector, x and y of each place, or of each junction, in turn.
FOAM_HOST_DEVICE inline Vec2 displacement(const double* vector, Index place) {
  const std::ptrdiff_t x = 2 * std::ptrdiff_t{place};
  return {vector[x], vector[x + 1]};
}

FOAM_HOST_DEVICE inline void set_displacement(double* vector, Index place, Vec2 value) {
  const std::ptrdiff_t x = 2 * std::ptrdiff_t{place};
  vector[x] = value.x;
  vector[x + 1] = value.y;
}

FOAM_HOST_DEVICE inline Vec2 displacement(const double* vector, Junction junction) {
  return displacement(vector, junction.index());
}

FOAM_HOST_DEVICE inline void set_displacement(double* vector, Junction junction, Vec2 value) {
  set_displacement(vector, junction.index(), value);
}

} // namespace foam
