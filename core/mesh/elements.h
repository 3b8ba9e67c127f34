// SPDX-License-Identifier: GPL-3.0-or-later
//
// The small types that every mesh is made of.
#pragma once

#include <cstdint>

#include "geometry/host_device.h"

namespace foam {

using Index = std::int32_t;

/// The outside, in every place where a bubble's index or id may stand.
inline constexpr Index kWorld = -1;
/// No element.
inline constexpr Index kNone = -1;

enum class Boundary {
  Free,     ///< the foam floats in the world, whose pressure is 0
  Periodic, ///< the foam fills a torus
  Fixed     ///< a sealed container: junctions on its wall are pinned, wall films straight and tight
};

/// The rectangle of a torus, cm.
struct Box {
  double xmin = 0, xmax = 0, ymin = 0, ymax = 0;

  FOAM_HOST_DEVICE double width() const { return xmax - xmin; }
  FOAM_HOST_DEVICE double height() const { return ymax - ymin; }
  friend bool operator==(const Box& a, const Box& b) = default;
};

/// How many periods lie between a film's start and its end on a torus.
struct Wrap {
  Index x = 0;
  Index y = 0;

  friend FOAM_HOST_DEVICE Wrap operator+(Wrap a, Wrap b) { return {a.x + b.x, a.y + b.y}; }
  friend FOAM_HOST_DEVICE Wrap operator-(Wrap a) { return {-a.x, -a.y}; }
  friend FOAM_HOST_DEVICE Wrap operator-(Wrap a, Wrap b) { return a + (-b); }
  friend bool operator==(Wrap a, Wrap b) = default;
};

} // namespace foam
