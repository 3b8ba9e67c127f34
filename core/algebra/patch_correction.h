// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "algebra/multifrontal_solver.h"

namespace foam {

/// Puts approximate solutions of a system of elements right in a patch of it, by a second solve
/// with the patch's own matrix, all else held (multiplicative Schwarz: B. F. Smith, P. E. Bjørstad,
/// W. D. Gropp, Domain Decomposition, 1996, ch. 1).
template <std::size_t N> class PatchCorrection {
public:
  /// \param elements of the patch, their unknowns numbered by themselves; \param diagonal that is
  /// added to them; \param columns the elements' unknowns in the whole system, kNone where held;
  /// \param tree of the patch. \returns false if the patch's matrix cannot be factorised.
  bool set_up(std::vector<ElementMatrix<N>> elements, std::vector<double> diagonal,
              std::vector<std::array<Index, N>> columns, const EliminationTree& tree) {
    elements_ = std::move(elements);
    diagonal_ = std::move(diagonal);
    columns_ = std::move(columns);
    rows_ = renumbering(all(), diagonal_.size(), columns_);
    solver_.analyse(tree, all());
    return solver_.factorise(all(), diagonal_) >= 0;
  }

  /// The patch's part of a vector.
  std::vector<double> part_of(std::span<const double> whole) const {
    std::vector<double> part;
    part.reserve(rows_.size());
    for (const Index row : rows_) {
      part.push_back(whole[place_of(row)]);
    }
    return part;
  }

  /// Puts an approximate solution x right. \param load the patch's part of the right-hand side
  void correct(std::vector<double> load, std::span<double> x) {
    for (std::size_t u = 0; u < load.size(); ++u) {
      load[u] -= diagonal_[u] * x[place_of(rows_[u])];
    }
    for (std::size_t e = 0; e < elements_.size(); ++e) {
      subtract_product(elements_[e], columns_[e], x, load);
    }
    solver_.solve(load);
    for (std::size_t u = 0; u < load.size(); ++u) {
      x[place_of(rows_[u])] += load[u];
    }
  }

private:
  std::span<const ElementMatrix<N>> all() const { return elements_; }

  std::vector<ElementMatrix<N>> elements_;
  std::vector<double> diagonal_;
  std::vector<std::array<Index, N>> columns_;
  std::vector<Index> rows_; ///< the patch's unknowns in the whole system
  MultifrontalSolver solver_;
};

} // namespace foam
