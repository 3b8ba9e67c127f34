// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>
#include <span>
#include <vector>

#include "mesh/foam.h"

namespace foam {

/// The lower triangle of a sparse symmetric matrix, column by column, rows ascending, every
/// diagonal entry present.
struct SymmetricPattern {
  std::vector<Index> column_start; ///< size n + 1
  std::vector<Index> row;
  /// The last so many unknowns may have a zero on the diagonal; a solver without pivoting is to
  /// eliminate them last.
  Index delicate = 0;

  Index size() const { return static_cast<Index>(column_start.size()) - 1; }
};

/// A direct solver of sparse symmetric indefinite systems.
class SparseSolver {
public:
  SparseSolver() = default;
  SparseSolver(const SparseSolver&) = delete;
  SparseSolver& operator=(const SparseSolver&) = delete;
  virtual ~SparseSolver() = default;

  /// Symbolic factorisation.
  virtual void analyse(const SymmetricPattern& pattern) = 0;
  /// Numeric factorisation of the values in the pattern's order.
  /// \returns the number of negative pivots, or −1 if the matrix cannot be factorised, or not
  /// accurately.
  virtual Index factorise(std::span<const double> values) = 0;
  /// Replaces the right-hand side by the solution.
  virtual void solve(std::span<double> rhs) = 0;
};

/// MUMPS for large systems where it was found, Eigen's LDLᵀ otherwise.
std::unique_ptr<SparseSolver> make_sparse_solver();

std::unique_ptr<SparseSolver> make_eigen_solver();
#ifdef FOAM_HAVE_MUMPS
std::unique_ptr<SparseSolver> make_mumps_solver();
#endif

} // namespace foam
