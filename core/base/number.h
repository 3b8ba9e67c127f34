// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <charconv>
#include <string>

#include "geometry/vec2.h"

namespace foam {

/// The shortest text that reads back as the number; for messages.
inline std::string number(double value) {
  std::array<char, 32> text{};
  const auto result = std::to_chars(text.data(), text.data() + text.size(), value);
  return {text.data(), result.ptr};
}

inline std::string number(Vec2 point) {
  return "(" + number(point.x) + ", " + number(point.y) + ")";
}

} // namespace foam
