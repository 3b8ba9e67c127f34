// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
#include <span>
#include <vector>

#include "algebra/element_matrix.h"
#include "mesh/ids.h"

namespace foam {

/// An order in which unknowns are eliminated, and what of it can be done at once.
struct EliminationTree {
  struct Node {
    Index begin = 0, end = 0;                    ///< the unknowns that it eliminates, in order
    std::array<Index, 2> children{kNone, kNone}; ///< eliminated before; they share no equation
  };
  std::vector<Index> order; ///< unknowns
  std::vector<Node> nodes;  ///< children before their parent; the root is the last
};

/// Solves symmetric systems whose matrix is a sum of elements' and a diagonal: multifrontal LDLᵀ
/// (I. S. Duff, J. K. Reid, ACM Trans. Math. Softw. 9 (1983) 302), in a given order and without
/// pivoting, on all processors, to the same bits for any number of them.
///
/// It takes the three steps of any direct solver, DirectSolver's too, one call each:
///   analyse    from where the matrix has entries, where its factors do,
///   factorise  L and D from the entries' values,
///   solve      one right-hand side.
/// One analysis serves for any values in the same places, one factorisation for any right-hand
/// side. Unlike a DirectSolver this one is told the order and tells a matrix's inertia.
/// Quasi-definite matrices have factors in every order (R. J. Vanderbei, SIAM J. Optim. 5 (1995)
/// 100); others may not, or none that are accurate, which is found out.
class MultifrontalSolver {
public:
  /// \param threads 0 stands for all processors.
  explicit MultifrontalSolver(int threads = 0);

  /// \param elements their unknowns alone matter.
  template <std::size_t N>
  void analyse(const EliminationTree& tree, std::span<const ElementMatrix<N>> elements);
  /// \param elements of the same unknowns as those analysed; \param diagonal by unknown.
  /// \returns the number of negative pivots, which is that of negative eigenvalues, or −1 if the
  /// matrix cannot be factorised without pivoting, or not accurately.
  template <std::size_t N>
  Index factorise(std::span<const ElementMatrix<N>> elements, std::span<const double> diagonal);
  /// Rounds the factors to single precision from now on: solutions are then no better than a
  /// preconditioner's need be, and sooner there, as it is reading the factors that takes the time.
  void round();
  /// Replaces the right-hand side by the solution.
  void solve(std::span<double> rhs);

private:
  /// A node of the tree: a dense matrix of its own unknowns, pivots, and of those above it that
  /// they touch. What a solution reads of it lies in memory behind what it reads of the last.
  struct Front {
    EliminationTree::Node node;
    std::size_t first_entry = 0;      ///< in factor_
    std::size_t first_above = 0;      ///< in above_
    Index above = 0;                  ///< how many unknowns above it touches
    std::vector<Index> elements;      ///< of which it eliminates the first unknown
    std::vector<Index> places;        ///< of their unknowns in this front, one after the other
    double work = 0;                  ///< of the front and all below, in multiplications
    std::vector<double> contribution; ///< to the matrix of the front above
    bool broken = false;              ///< a pivot is too small

    Index pivots() const { return node.end - node.begin; }
    Index size() const { return pivots() + above; }
    std::size_t entries() const;
  };
  /// Where unknowns are, while a matrix is analysed.
  struct Numbering {
    std::vector<Index> position; ///< in order_, by unknown
    std::vector<Index> place;    ///< in the front at hand, by position; kNone where it is not there
  };

  template <class Part> static void both(Index first, Index second, int threads, const Part& part);
  template <class Visit>
  void upwards(Index front, int threads, double least, const Visit& visit) const;
  template <class Visit>
  void downwards(Index front, int threads, double least, const Visit& visit) const;
  template <std::size_t N>
  void find_above(Front& front, std::span<const ElementMatrix<N>> elements, Numbering& numbering);
  template <std::size_t N>
  void find_places(Front& front, std::span<const ElementMatrix<N>> elements, Numbering& numbering);
  template <std::size_t N>
  void assemble(Front& front, std::span<const ElementMatrix<N>> elements,
                std::span<const double> diagonal);
  void solve_upwards(Front& front);
  void solve_downwards(Front& front);
  template <std::size_t N>
  bool accurate(std::span<const ElementMatrix<N>> elements, std::span<const double> diagonal);

  std::span<Index> above(const Front& front);
  std::span<Index> places_above(const Front& front);
  template <class Entry> std::span<Entry> columns(const Front& front);
  std::span<double> pivots(const Front& front);
  std::span<double> vector(const Front& front);

  int threads_;
  std::vector<Index> order_;     ///< unknowns by position
  std::vector<Front> fronts_;    ///< children before their parent
  std::vector<Index> above_;     ///< positions of the unknowns above each front, ascending
  std::vector<Index> parent_;    ///< their places in the parent's front
  std::vector<double> vector_;   ///< of each front's unknowns
  std::vector<double> solution_; ///< by position

  std::vector<double> pivot_;           ///< D, by position
  std::unique_ptr<std::byte[]> factor_; ///< L, its diagonal not stored, as columns of each front
  std::size_t entries_ = 0;             ///< of it
  std::size_t capacity_ = 0;            ///< entries that there is room for
  bool rounded_ = false;                ///< whether they are floats, not doubles
};

} // namespace foam
