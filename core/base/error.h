// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <stdexcept>
#include <string>

#include "base/number.h"

namespace foam {

/// Bad input. The message names the cause and the offending value.
class FoamError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

/// \throws FoamError saying that `name` must be `range`, but is `value`, unless that holds and the
/// value is finite.
inline void require(bool holds, const std::string& name, const std::string& range, double value) {
  if (!holds || !std::isfinite(value)) {
    throw FoamError(name + " must be " + range + ", but is " + number(value));
  }
}

} // namespace foam
