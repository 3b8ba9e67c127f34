// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/fields.h"

namespace foam {

/// A number for each of a few elements among many, kNone for the others. To empty it takes no more
/// time than they are many.
template <class Element> class SparseNumbers {
public:
  /// Empties it. \param capacity how many elements there are
  void clear(std::size_t capacity) {
    for (const Element element : elements_) {
      numbers_[element] = kNone;
    }
    elements_.clear();
    numbers_.resize(capacity, kNone);
  }
  void put(Element element, Index number) {
    elements_.push_back(element);
    numbers_[element] = number;
  }
  Index at(Element element) const {
    return element.place() < numbers_.size() ? numbers_[element] : kNone;
  }

private:
  Field<Element, Index> numbers_;
  std::vector<Element> elements_; ///< that have one
};

} // namespace foam
