// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "mesh/ids.h"

namespace foam {

/// What one element adds to a symmetric matrix that is a sum over elements, as those of finite
/// elements are: a matrix of its own N unknowns.
template <std::size_t N> struct ElementMatrix {
  std::array<Index, N> unknown{};            ///< their numbers in the sum; kNone where held
  std::array<double, N*(N + 1) / 2> value{}; ///< lower triangle, row by row
};

/// Calls visit(row, column, place) for every entry of the lower triangle of N rows, in its order.
template <std::size_t N, class Visit> void for_each_lower(const Visit& visit) {
  std::size_t place = 0;
  for (std::size_t row = 0; row < N; ++row) {
    for (std::size_t column = 0; column <= row; ++column, ++place) {
      visit(row, column, place);
    }
  }
}

/// The largest entry by magnitude between unknowns that are not held.
template <std::size_t N> double largest_entry(const ElementMatrix<N>& element) {
  double largest = 0;
  for_each_lower<N>([&](std::size_t row, std::size_t column, std::size_t k) {
    if (element.unknown[row] != kNone && element.unknown[column] != kNone) {
      largest = std::max(largest, std::abs(element.value[k]));
    }
  });
  return largest;
}

/// from −= element · x, where x is the element's own. An element whose last unknown is held is
/// taken to be one without it: nothing is multiplied by its part of x.
template <std::size_t N>
void subtract_product(const ElementMatrix<N>& element, const std::array<double, N>& x,
                      std::span<double> from) {
  std::array<double, N> force{};
  const std::size_t size = element.unknown.back() == kNone ? N - 1 : N;
  std::size_t k = 0;
  for (std::size_t row = 0; row < size; ++row) {
    for (std::size_t column = 0; column < row; ++column, ++k) {
      force[row] += element.value[k] * x[column];
      force[column] += element.value[k] * x[row];
    }
    force[row] += element.value[k++] * x[row];
  }
  for (std::size_t row = 0; row < size; ++row) {
    if (element.unknown[row] != kNone) {
      from[place_of(element.unknown[row])] -= force[row];
    }
  }
}

/// The same. \param columns of the element's unknowns in x, kNone where held.
template <std::size_t N>
void subtract_product(const ElementMatrix<N>& element, const std::array<Index, N>& columns,
                      std::span<const double> x, std::span<double> from) {
  std::array<double, N> own{};
  for (std::size_t k = 0; k < N; ++k) {
    own[k] = columns[k] == kNone ? 0 : x[place_of(columns[k])];
  }
  subtract_product(element, own, from);
}

/// By the elements' `unknowns` numbers, those that the same unknowns have elsewhere, or kNone.
/// \param elsewhere by element
template <std::size_t N>
std::vector<Index> renumbering(std::span<const ElementMatrix<N>> elements, std::size_t unknowns,
                               const std::vector<std::array<Index, N>>& elsewhere) {
  std::vector<Index> numbers(unknowns, kNone);
  for (std::size_t e = 0; e < elements.size(); ++e) {
    for (std::size_t k = 0; k < N; ++k) {
      if (elements[e].unknown[k] != kNone) {
        numbers[place_of(elements[e].unknown[k])] = elsewhere[e][k];
      }
    }
  }
  return numbers;
}

} // namespace foam
