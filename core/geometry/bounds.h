// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "geometry/vec2.h"

namespace foam {

/// The smallest rectangle around places, upright; nowhere to begin with.
struct Bounds {
  Vec2 low{1e300, 1e300};
  Vec2 high{-1e300, -1e300};

  FOAM_HOST_DEVICE Vec2 extent() const { return high - low; }

  /// Around both.
  friend FOAM_HOST_DEVICE Bounds operator+(const Bounds& a, const Bounds& b) {
    return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
            {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
  }
};

/// Around all places of a range.
template <class Places> Bounds bounds_of(const Places& places) {
  Bounds bounds;
  for (const Vec2 place : places) {
    bounds = bounds + Bounds{place, place};
  }
  return bounds;
}

} // namespace foam
