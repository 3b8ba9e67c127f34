// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "geometry/vec2.h"

namespace foam {

/// The smallest rectangle around places, upright; nowhere to begin with.
struct Bounds {
  Vec2 low{1e300, 1e300};
  Vec2 high{-1e300, -1e300};

  /// Around both.
  friend FOAM_HOST_DEVICE Bounds operator+(const Bounds& a, const Bounds& b) {
    return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
            {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
  }
};

} // namespace foam
