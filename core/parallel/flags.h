// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "mesh/fields.h"
#include "parallel/kernels.h"

namespace foam::parallel {

/// One flag for each element of a mesh, on any executor (parallel/host.h).
template <class Executor> class Flags {
public:
  explicit Flags(Executor& executor) : executor_(executor) {}

  /// \returns a flag for each of the elements, all of them set; they stay until the next call.
  template <class Element> FieldView<Element, std::uint8_t> all_set(Slots<Element> slots) {
    flags_.resize(place_of(slots.size()));
    executor_.for_each(slots.size(), Fill<std::uint8_t>{flags_.data(), 1});
    return FieldView<Element, std::uint8_t>(flags_.data());
  }

private:
  Executor& executor_;
  typename Executor::template Array<std::uint8_t> flags_;
};

} // namespace foam::parallel
