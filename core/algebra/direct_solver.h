// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/ids.h"

namespace foam {

/// The lower triangle of a symmetric matrix in compressed rows, wherever its arrays lie. Row i has
/// the entries from first[i] to first[i + 1], their columns ascending and the diagonal last.
struct LowerTriangle {
  Index size = 0;                ///< rows
  Index entries = 0;             ///< first[size]
  const Index* first = nullptr;  ///< size + 1 of them
  const Index* column = nullptr; ///< entries of them, from 0 on
  const double* value = nullptr; ///< entries of them
};

/// Solves sparse symmetric systems by a factorisation, on the executor (parallel/host.h) in whose
/// memory they are. It takes the three steps of any direct solver, MultifrontalSolver's too, in one
/// call:
///   analyse    from where the matrix has entries, in which order unknowns are eliminated and where
///              the factors have entries; not again while they stay in the same places,
///   factorise  from the entries' values,
///   solve      the right-hand side.
/// Unlike MultifrontalSolver it takes a matrix that is summed up, finds an order itself, tells
/// nothing of inertia, and leaves it to others to find out how accurate it was.
class DirectSolver {
public:
  DirectSolver() = default;
  DirectSolver(const DirectSolver&) = delete;
  DirectSolver& operator=(const DirectSolver&) = delete;
  virtual ~DirectSolver() = default;

  /// Solves matrix · x = b: as well as pivots allow, some of which may have been too small where
  /// the matrix is indefinite. \param b right-hand side and \param x solution, size numbers each.
  /// \throws FoamError if the solver fails.
  virtual void solve(const LowerTriangle& matrix, const double* b, double* x) = 0;
};

} // namespace foam
