// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/ids.h"

namespace foam {

/// Some elements of a kind, listed or all of them. A range for an executor (parallel/host.h).
template <class Element> class Elements {
public:
  Elements() = default;
  /// \param list ascending; it must outlive this
  // NOLINTNEXTLINE(google-explicit-constructor): it is a list, looked at
  Elements(const std::vector<Element>& list)
      : list_(list.data()), size_(static_cast<Index>(list.size())) {}
  FOAM_HOST_DEVICE explicit Elements(Slots<Element> all) : size_(all.size()) {}

  FOAM_HOST_DEVICE Index size() const { return size_; }
  FOAM_HOST_DEVICE Element operator[](Index i) const {
    return list_ == nullptr ? Element(i) : list_[i];
  }

private:
  const Element* list_ = nullptr;
  Index size_ = 0;
};

} // namespace foam
