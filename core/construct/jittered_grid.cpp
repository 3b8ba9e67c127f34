// SPDX-License-Identifier: GPL-3.0-or-later
#include "construct/jittered_grid.h"

#include <cmath>

#include "base/error.h"
#include "base/random.h"

namespace foam {
namespace {

void check(Index count, double spacing, double jitter) {
  if (count < 1) {
    throw FoamError("the number of points must be at least 1, but is " + std::to_string(count));
  }
  if (!(spacing > 0) || !std::isfinite(spacing)) {
    throw FoamError("the spacing must be positive, but is " + number(spacing));
  }
  if (!(jitter >= 0 && jitter <= 1)) {
    throw FoamError("the jitter must lie between 0 and 1, but is " + number(jitter));
  }
}

} // namespace

std::vector<Vec2> jittered_grid(Index count, double spacing, double jitter, std::uint64_t seed) {
  check(count, spacing, jitter);
  const auto columns = static_cast<Index>(std::ceil(std::sqrt(count)));
  Random random(seed);
  std::vector<Vec2> points(place_of(count));
  for (Index i = 0; i < count; ++i) {
    const double in_cell_x = 0.5 + jitter * (random.uniform() - 0.5);
    const double in_cell_y = 0.5 + jitter * (random.uniform() - 0.5);
    const Index column = i % columns;
    const Index row = i / columns;
    points[place_of(i)] = {spacing * (column + in_cell_x), spacing * (row + in_cell_y)};
  }
  return points;
}

} // namespace foam
