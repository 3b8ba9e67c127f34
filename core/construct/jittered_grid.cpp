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

Index columns_of(Index count) {
  return static_cast<Index>(std::ceil(std::sqrt(count)));
}

} // namespace

std::vector<Vec2> jittered_grid(Index count, double spacing, double jitter, std::uint64_t seed) {
  check(count, spacing, jitter);
  const Index columns = columns_of(count);
  const Index rows = (count + columns - 1) / columns;
  Random random(seed);
  std::vector<Vec2> points;
  double bottom = 0; // of a row, in spacings
  for (Index row = 0; row < rows; ++row) {
    const Index cells = count / rows + (row < count % rows ? 1 : 0);
    const double width = static_cast<double>(columns) / cells;
    const double height = 1 / width;
    for (Index column = 0; column < cells; ++column) {
      const double in_cell_x = 0.5 + jitter * (random.uniform() - 0.5);
      const double in_cell_y = 0.5 + jitter * (random.uniform() - 0.5);
      points.push_back(
          {spacing * (width * (column + in_cell_x)), spacing * (bottom + height * in_cell_y)});
    }
    bottom += height;
  }
  return points;
}

Vec2 grid_corner(Index count, double spacing) {
  const Index columns = columns_of(count);
  return {spacing * columns, spacing * count / columns};
}

} // namespace foam
