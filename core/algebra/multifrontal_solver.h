// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "algebra/film_share.h"
#include "mesh/elements.h"

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

/// Factorises a sum of films' shares and a diagonal: multifrontal LDLᵀ (I. S. Duff, J. K. Reid, ACM
/// Trans. Math. Softw. 9 (1983) 302), in a given order and without pivoting, on all processors, to
/// the same bits for any number of them. The matrices of a foam near equilibrium are quasi-definite
/// but for directions that matter little; whether a factorisation is accurate is found out.
class MultifrontalSolver {
public:
  /// \param threads 0 stands for all processors.
  explicit MultifrontalSolver(int threads = 0);

  /// Symbolic factorisation. \param shares their unknowns alone matter.
  void analyse(const EliminationTree& tree, std::span<const FilmShare> shares);
  /// Numeric factorisation. \param shares of the same unknowns as those analysed; \param diagonal
  /// by unknown. \returns the number of negative pivots, or −1 if the matrix cannot be factorised
  /// without pivoting, or not accurately.
  Index factorise(std::span<const FilmShare> shares, std::span<const double> diagonal);
  /// Replaces the right-hand side by the solution.
  void solve(std::span<double> rhs);

private:
  /// A node of the tree: a dense matrix of its own unknowns, pivots, and of those above it that
  /// they touch.
  struct Front {
    EliminationTree::Node node;
    std::vector<Index> above;  ///< positions, ascending
    std::vector<Index> parent; ///< of those above, by place in the parent's front
    std::vector<Index> shares;
    std::vector<std::array<Index, 7>> places; ///< of the shares' unknowns in this front
    double work = 0;                          ///< of the front and all below, in multiplications

    std::vector<double> panel;        ///< columns of L of the pivots, unit diagonal not stored
    std::vector<double> pivot;        ///< D
    std::vector<double> contribution; ///< to the front above: a matrix, then a vector
    bool broken = false;              ///< a pivot is too small

    Index pivots() const { return node.end - node.begin; }
    Index size() const { return pivots() + static_cast<Index>(above.size()); }
  };

  template <class Part>
  void both_children(Index front, int threads, double least, const Part& part) const;
  template <class Visit>
  void upwards(Index front, int threads, double least, const Visit& visit) const;
  template <class Visit>
  void downwards(Index front, int threads, double least, const Visit& visit) const;
  void assemble(Front& front, std::span<const FilmShare> shares, std::span<const double> diagonal);
  void solve_upwards(Front& front);
  void solve_downwards(Front& front);
  bool accurate(std::span<const FilmShare> shares, std::span<const double> diagonal);

  int threads_;
  std::vector<Index> order_;   ///< unknowns by position
  std::vector<Front> fronts_;  ///< children before their parent
  std::vector<double> vector_; ///< right-hand side and solution, by position
};

} // namespace foam
