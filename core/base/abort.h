// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <stdexcept>

namespace foam {

/// Thrown out of long work when its abort check says so.
class Aborted : public std::runtime_error {
public:
  Aborted() : std::runtime_error("aborted") {}
};

/// Asked often during long work; true ends it with Aborted.
using AbortCheck = std::function<bool()>;

} // namespace foam
