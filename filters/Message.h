// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <limits>
#include <sstream>
#include <string>

#include "base/error.h"
#include "mesh/foam.h"

namespace foam::filters {

/// The parts one after the other, numbers to their last digit.
template <class... Parts> std::string message(const Parts&... parts) {
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  (out << ... << parts);
  return out.str();
}

/// Throws a FoamError with the parts as its message.
template <class... Parts> [[noreturn]] void fail(const Parts&... parts) {
  throw FoamError(message(parts...));
}

/// Says that target areas of this sum (cm²) were scaled to fill a torus or a container; nothing
/// where that is by their own rounding alone.
inline std::string told_scaling(double sum, double scale) {
  constexpr double kUntold = 1e-6;
  if (std::abs(scale - 1) <= kUntold) {
    return {};
  }
  std::ostringstream out;
  out << "The target areas add up to " << sum << ", but have to fill " << scale * sum
      << ": they were scaled by " << scale << ".";
  return out.str();
}

} // namespace foam::filters
