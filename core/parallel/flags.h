// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "mesh/elements.h"
#include "parallel/kernels.h"

namespace foam::parallel {

/// One flag for each element of a mesh, on any machine (parallel/host.h).
template <class Machine> class Flags {
public:
  explicit Flags(Machine& machine) : machine_(machine) {}

  /// \returns `size` flags that are all set; they stay until the next call.
  std::uint8_t* all_set(Index size) {
    flags_.resize(static_cast<std::size_t>(size));
    machine_.for_each(size, Fill<std::uint8_t>{flags_.data(), 1});
    return flags_.data();
  }

private:
  Machine& machine_;
  typename Machine::template Array<std::uint8_t> flags_;
};

} // namespace foam::parallel
