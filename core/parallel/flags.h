// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>

#include "mesh/fields.h"
#include "parallel/kernels.h"

namespace foam::parallel {

/// One flag for each element of a mesh, on any machine (parallel/host.h).
template <class Machine> class Flags {
public:
  explicit Flags(Machine& machine) : machine_(machine) {}

  /// \returns a flag for each of the elements, all of them set; they stay until the next call.
  template <class Element> FieldView<Element, std::uint8_t> all_set(Slots<Element> slots) {
    flags_.resize(place_of(slots.size()));
    machine_.for_each(slots.size(), Fill<std::uint8_t>{flags_.data(), 1});
    return FieldView<Element, std::uint8_t>(flags_.data());
  }

private:
  Machine& machine_;
  typename Machine::template Array<std::uint8_t> flags_;
};

} // namespace foam::parallel
