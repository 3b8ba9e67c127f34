// SPDX-License-Identifier: GPL-3.0-or-later
//
// The matrix of matrix_free.h entry by entry, for those who factorise it.
#pragma once

#include "algebra/direct_solver.h"
#include "equilibrium/matrix_free.h"
#include "equilibrium/zero_modes.h"

namespace foam::newton {
namespace detail {

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

/// How many entries a row may get, one index a junction, for its two rows, then one a bubble.
struct BoundRows {
  ConstFoamView mesh;
  Index* bound = nullptr; ///< by row

  FOAM_HOST_DEVICE void operator()(Index i) const {
    if (i < mesh.junctions) {
      const Index x = 2 * i;
      bound[x] = bound[x + 1] = mesh.moves(Junction(i)) ? 8 : 1; // it and three others
    } else {
      const Bubble bubble(i - mesh.junctions);
      bound[mesh.junctions + i] =
          mesh.has_bubble(bubble) ? 3 * mesh.sides[bubble] + 1 : 1; // junctions, neighbours, it
    }
  }
};

/// Lists the entries of rows, one index a junction, then one a bubble.
struct ListRows {
  WholeFoamMatrix matrix;
  const Index* begin = nullptr; ///< of each row in the next two
  Index* column = nullptr;
  double* value = nullptr;
  Index* length = nullptr; ///< by row

  FOAM_HOST_DEVICE void operator()(Index i) const {
    if (i < matrix.mesh.junctions) {
      list_junction(Junction(i));
    } else {
      list_bubble(Bubble(i - matrix.mesh.junctions));
    }
  }

private:
  FOAM_HOST_DEVICE GrowingRow row_of(Index row) const {
    return {row, column + begin[row], value + begin[row]};
  }

  FOAM_HOST_DEVICE void list_junction(Junction junction) const {
    const ConstFoamView& mesh = matrix.mesh;
    const Index own = 2 * junction.index();
    GrowingRow x = row_of(own);
    GrowingRow y = row_of(own + 1);
    const double diagonal = mesh.moves(junction) ? kRegularisation : 1;
    x.add(own, diagonal);
    y.add(own + 1, diagonal);
    if (mesh.moves(junction)) {
      for (const Half h : mesh.junction_half[junction]) {
        const FilmStiffness& f = matrix.film[h.film()];
        add_block(x, y, own, f, 1, 0);
        if (mesh.moves(mesh.end(h))) {
          add_block(x, y, 2 * mesh.end(h).index(), f, -1, h.reversed() ? -f.jump : f.jump);
        }
      }
    }
    length[own] = x.length;
    length[own + 1] = y.length;
  }

  /// sign · (xx, xy; xy, yy) + jump · (0, −1; 1, 0)
  FOAM_HOST_DEVICE static void add_block(GrowingRow& x, GrowingRow& y, Index at,
                                         const FilmStiffness& f, double sign, double jump) {
    x.add(at, sign * f.xx);
    x.add(at + 1, sign * f.xy - jump);
    y.add(at, sign * f.xy + jump);
    y.add(at + 1, sign * f.yy);
  }

  FOAM_HOST_DEVICE void list_bubble(Bubble bubble) const {
    const ConstFoamView& mesh = matrix.mesh;
    const Index first = 2 * mesh.junctions;
    const Index own = first + bubble.index();
    GrowingRow row = row_of(own);
    row.add(own, mesh.has_bubble(bubble) ? -kRegularisation : 1);
    if (mesh.has_bubble(bubble)) {
      for_each_half(mesh, bubble, [&](Half h) {
        const FilmStiffness& f = matrix.film[h.film()];
        add_slope(row, mesh.start(h), f.start_slope(h));
        add_slope(row, mesh.end(h), f.end_slope(h));
        row.add(own, -f.compliance);
        if (!mesh.right(h).is_outside()) {
          row.add(first + mesh.right(h).index(), f.compliance);
        }
      });
    }
    length[own] = row.length;
  }

  FOAM_HOST_DEVICE void add_slope(GrowingRow& row, Junction junction, Vec2 slope) const {
    if (matrix.mesh.moves(junction)) {
      row.add(2 * junction.index(), -slope.x);
      row.add(2 * junction.index() + 1, -slope.y);
    }
  }
};

/// Moves a row's entries to where its matrix has them.
struct PackRow {
  const Index* from = nullptr; ///< by row
  const Index* to = nullptr;   ///< by row
  const Index* listed_column = nullptr;
  const double* listed_value = nullptr;
  Index* column = nullptr;
  double* value = nullptr;

  FOAM_HOST_DEVICE void operator()(Index row) const {
    for (Index k = 0; k < to[row + 1] - to[row]; ++k) {
      column[to[row] + k] = listed_column[from[row] + k];
      value[to[row] + k] = listed_value[from[row] + k];
    }
  }
};

} // namespace detail

/// WholeFoamMatrix with kRegularisation, and for every element that is absent or held an equation
/// of its own, x = 0. On an executor (parallel/host.h); each row is summed by one thread in a fixed
/// order.
template <class Executor> class CompressedMatrix {
public:
  explicit CompressedMatrix(Executor& executor) : executor_(executor) {}

  /// \returns what stays as it is until the next call, or as long as this is there.
  LowerTriangle assemble(const WholeFoamMatrix& matrix) {
    const ConstFoamView& mesh = matrix.mesh;
    const Index size = size_of(mesh);
    const Index elements = mesh.junctions + mesh.bubbles;
    for (auto* array : {&begin_, &first_}) {
      array->resize(static_cast<std::size_t>(size) + 1);
    }
    executor_.for_each(elements, detail::BoundRows{mesh, begin_.data()});
    const auto listed = static_cast<std::size_t>(executor_.exclusive_scan(begin_.data(), size));
    listed_column_.resize(listed);
    listed_value_.resize(listed);
    executor_.for_each(elements, detail::ListRows{matrix, begin_.data(), listed_column_.data(),
                                                  listed_value_.data(), first_.data()});
    const Index entries = executor_.exclusive_scan(first_.data(), size);
    column_.resize(static_cast<std::size_t>(entries));
    value_.resize(static_cast<std::size_t>(entries));
    executor_.for_each(size, detail::PackRow{begin_.data(), first_.data(), listed_column_.data(),
                                             listed_value_.data(), column_.data(), value_.data()});
    return {size, entries, first_.data(), column_.data(), value_.data()};
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

} // namespace foam::newton
