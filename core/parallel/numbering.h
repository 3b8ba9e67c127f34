// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/ids.h"
#include "parallel/kernels.h"

namespace foam::parallel {
namespace detail {

/// number[i] ← 1 where there is an i-th element.
template <class ElementAt> struct CountElement {
  ElementAt at;
  Index* number = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const { number[i] = at(i) == kNone ? 0 : 1; }
};

template <class Element, class ElementAt> struct ListElement {
  ElementAt at;
  const Index* number = nullptr;
  Element* list = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    const Element element = at(i);
    if (element != kNone) {
      list[number[i]] = element;
    }
  }
};

} // namespace detail

/// The elements of a mesh that are there, counted from 0 on, on any executor (parallel/host.h).
template <class Executor, class Element> class Numbering {
public:
  explicit Numbering(Executor& executor) : executor_(executor) {}

  /// \param at at(i), for i in [0, size), is the i-th, or kNone where it is gone.
  template <class ElementAt> void find(Index size, const ElementAt& at) {
    number_.resize(place_of(size) + 1);
    executor_.for_each(size, detail::CountElement<ElementAt>{at, number_.data()});
    count_ = executor_.exclusive_scan(number_.data(), size);
    list_.resize(place_of(count_));
    executor_.for_each(size,
                       detail::ListElement<Element, ElementAt>{at, number_.data(), list_.data()});
  }
  /// The same for the elements of a range, such as Slots. \param at at(element) is the element, or
  /// kNone where it is gone.
  template <class Range, class ElementAt> void find(const Range& range, const ElementAt& at) {
    find(range.size(), OfRange<Range, ElementAt>{range, at});
  }

  Index count() const { return count_; }
  /// Those that are there, in their order; count() of them.
  const Element* list() const { return list_.data(); }
  /// Where in list() the i-th is, if it is there.
  const Index* number() const { return number_.data(); }

private:
  Executor& executor_;
  typename Executor::template Array<Index> number_;
  typename Executor::template Array<Element> list_;
  Index count_ = 0;
};

} // namespace foam::parallel
