// SPDX-License-Identifier: GPL-3.0-or-later
#include "build/jittered_grid.h"

#include <cmath>

#include "mesh/number.h"

namespace foam {
namespace {

/// SplitMix64 (G. L. Steele, D. Lea, C. H. Flood, OOPSLA 2014). The standard library's
/// distributions are not the same on every platform.
class Random {
public:
  explicit Random(std::uint64_t seed) : state_(seed) {}

  /// Uniform on [0, 1), a multiple of 2⁻⁵³.
  double uniform() { return static_cast<double>(next() >> 11) * 0x1p-53; }

private:
  std::uint64_t next() {
    std::uint64_t z = (state_ += 0x9e3779b97f4a7c15);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
    z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
    return z ^ (z >> 31);
  }

  std::uint64_t state_;
};

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
  std::vector<Vec2> points(Foam::size(count));
  for (Index i = 0; i < count; ++i) {
    const double in_cell_x = 0.5 + jitter * (random.uniform() - 0.5);
    const double in_cell_y = 0.5 + jitter * (random.uniform() - 0.5);
    const Index column = i % columns;
    const Index row = i / columns;
    points[Foam::size(i)] = {spacing * (column + in_cell_x), spacing * (row + in_cell_y)};
  }
  return points;
}

} // namespace foam
