// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <memory>
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
    std::size_t first_entry = 0; ///< in factor_
    std::size_t first_above = 0; ///< in above_
    Index above = 0;             ///< how many unknowns above it touches
    std::vector<Index> shares;
    std::vector<std::array<Index, 7>> places; ///< of the shares' unknowns in this front
    double work = 0;                          ///< of the front and all below, in multiplications
    std::vector<double> contribution;         ///< to the matrix of the front above
    bool broken = false;                      ///< a pivot is too small

    Index pivots() const { return node.end - node.begin; }
    Index size() const { return pivots() + above; }
    std::size_t entries() const;
  };

  template <class Part> static void both(Index first, Index second, int threads, const Part& part);
  template <class Visit>
  void upwards(Index front, int threads, double least, const Visit& visit) const;
  template <class Visit>
  void downwards(Index front, int threads, double least, const Visit& visit) const;
  void assemble(Front& front, std::span<const FilmShare> shares, std::span<const double> diagonal);
  void solve_upwards(Front& front);
  void solve_downwards(Front& front);
  bool accurate(std::span<const FilmShare> shares, std::span<const double> diagonal);

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
