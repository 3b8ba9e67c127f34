// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

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

} // namespace foam::filters
