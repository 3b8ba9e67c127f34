// SPDX-License-Identifier: GPL-3.0-or-later
//
// The lower triangle of a symmetric matrix in compressed rows, entry by entry, on an executor
// (parallel/host.h).
#pragma once

#include "algebra/direct_solver.h"
#include "parallel/kernels.h"

namespace foam {

/// A row of a lower triangle that takes up entries in any order: those of one column are added up,
/// and those beyond the diagonal left out.
struct GrowingRow {
  Index row = 0;
  Index* column = nullptr; ///< ascending
  double* value = nullptr;
  Index length = 0;

  FOAM_HOST_DEVICE void add(Index at, double what) {
    if (at > row) {
      return;
    }
    Index place = length;
    while (place > 0 && column[place - 1] > at) {
      --place;
    }
    if (place > 0 && column[place - 1] == at) {
      value[place - 1] += what;
      return;
    }
    for (Index k = length++; k > place; --k) {
      column[k] = column[k - 1];
      value[k] = value[k - 1];
    }
    column[place] = at;
    value[place] = what;
  }
};

/// All rows of a matrix while they grow.
struct GrowingRows {
  const Index* begin = nullptr; ///< of each row in the next two
  Index* column = nullptr;
  double* value = nullptr;
  Index* length = nullptr; ///< by row

  FOAM_HOST_DEVICE GrowingRow begun(Index row) const {
    return {row, column + begin[row], value + begin[row]};
  }
  FOAM_HOST_DEVICE void finish(const GrowingRow& row) const { length[row.row] = row.length; }
};

/// Puts a matrix together. Its rows come in groups, each the work of one thread: a row's entries
/// are added up in the order in which they are listed. A matrix has
///   size()               how many rows,
///   groups()             how many groups of them,
///   bound(group, bounds) sets bounds[row], for each row of a group, to how many entries it may
///   get, list(group, rows)    begins them in GrowingRows, adds the entries and finishes them.
template <class Executor> class CompressedRows {
public:
  explicit CompressedRows(Executor& executor) : executor_(executor) {}

  /// \returns what stays as it is until the next call, or as long as this is there.
  template <class Matrix> LowerTriangle assemble(const Matrix& matrix) {
    const Index size = matrix.size();
    for (auto* array : {&begin_, &first_}) {
      array->resize(place_of(size) + 1);
    }
    Index* const begin = begin_.data();
    Index* const first = first_.data();
    executor_.for_each(
        matrix.groups(), FOAM_KERNEL(Index group) { matrix.bound(group, begin); });
    const Index listed = executor_.exclusive_scan(begin, size);
    listed_column_.resize(place_of(listed));
    listed_value_.resize(place_of(listed));
    const GrowingRows rows{begin, listed_column_.data(), listed_value_.data(), first};
    executor_.for_each(
        matrix.groups(), FOAM_KERNEL(Index group) { matrix.list(group, rows); });
    const Index entries = executor_.exclusive_scan(first, size);
    column_.resize(place_of(entries));
    value_.resize(place_of(entries));
    Index* const column = column_.data();
    double* const value = value_.data();
    executor_.for_each(
        size, FOAM_KERNEL(Index row) {
          for (Index k = 0; k < first[row + 1] - first[row]; ++k) {
            column[first[row] + k] = rows.column[begin[row] + k];
            value[first[row] + k] = rows.value[begin[row] + k];
          }
        });
    return {size, entries, first, column, value};
  }

private:
  template <class T> using Array = typename Executor::template Array<T>;

  Executor& executor_;
  Array<Index> begin_; ///< of each row as it was listed
  Array<Index> listed_column_;
  Array<double> listed_value_;
  Array<Index> first_, column_;
  Array<double> value_;
};

} // namespace foam
