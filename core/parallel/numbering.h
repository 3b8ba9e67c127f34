// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/number.h"
#include "mesh/elements.h"

namespace foam::parallel {
namespace detail {

/// number[i] ← 1 where there is an i-th element.
template <class Element> struct CountElement {
  Element element;
  Index* number = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const { number[i] = element(i) == kNone ? 0 : 1; }
};

template <class Element> struct ListElement {
  Element element;
  const Index* number = nullptr;
  Index* list = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    if (element(i) != kNone) {
      list[number[i]] = element(i);
    }
  }
};

} // namespace detail

/// The elements of a mesh that are there, counted from 0 on, on any machine (parallel/host.h).
template <class Machine> class Numbering {
public:
  explicit Numbering(Machine& machine) : machine_(machine) {}

  /// \param element element(i), for i in [0, size), is the i-th, or kNone where it is gone.
  template <class Element> void find(Index size, const Element& element) {
    const auto length = static_cast<std::size_t>(size);
    number_.resize(length + 1);
    machine_.for_each(size, detail::CountElement<Element>{element, number_.data()});
    count_ = machine_.sum_up(number_.data(), size);
    list_.resize(static_cast<std::size_t>(count_));
    machine_.for_each(size, detail::ListElement<Element>{element, number_.data(), list_.data()});
  }

  Index count() const { return count_; }
  /// Those that are there, in their order; count() of them.
  const Index* list() const { return list_.data(); }
  /// Where in list() the i-th is, if it is there.
  const Index* number() const { return number_.data(); }

private:
  Machine& machine_;
  typename Machine::template Array<Index> number_;
  typename Machine::template Array<Index> list_;
  Index count_ = 0;
};

} // namespace foam::parallel
