// SPDX-License-Identifier: GPL-3.0-or-later
#include <Eigen/OrderingMethods>
#include <Eigen/SparseCholesky>
#include <numeric>

#include "equilibrium/sparse_solver.h"

namespace foam {
namespace {

using Matrix = Eigen::SparseMatrix<double, Eigen::ColMajor, Index>;
using Permutation = Eigen::PermutationMatrix<Eigen::Dynamic, Eigen::Dynamic, Index>;

constexpr double kBackwardError = 1e-10; // of a factorisation that serves

/// LDLᵀ without pivoting. The matrices of a foam near equilibrium are quasi-definite up to the
/// delicate unknowns, and those come last.
class EigenSolver final : public SparseSolver {
public:
  void analyse(const SymmetricPattern& pattern) override {
    const Index n = pattern.size();
    const std::vector<double> ones(pattern.row.size(), 1.0);
    const Eigen::Map<const Matrix> lower(n, n, static_cast<Index>(pattern.row.size()),
                                         pattern.column_start.data(), pattern.row.data(),
                                         ones.data());
    order_ = elimination_order(lower, n - pattern.delicate);
    permuted_.resize(n, n);
    permuted_.selfadjointView<Eigen::Upper>() =
        lower.selfadjointView<Eigen::Lower>().twistedBy(order_);
    ldlt_.analyzePattern(permuted_);
    pattern_ = pattern;
  }

  Index factorise(std::span<const double> values) override {
    const Index n = pattern_.size();
    const Eigen::Map<const Matrix> lower(n, n, static_cast<Index>(pattern_.row.size()),
                                         pattern_.column_start.data(), pattern_.row.data(),
                                         values.data());
    permuted_.selfadjointView<Eigen::Upper>() =
        lower.selfadjointView<Eigen::Lower>().twistedBy(order_);
    ldlt_.factorize(permuted_);
    if (ldlt_.info() != Eigen::Success || !ldlt_.vectorD().allFinite() || !accurate(lower)) {
      return -1;
    }
    return static_cast<Index>((ldlt_.vectorD().array() < 0).count());
  }

  void solve(std::span<double> rhs) override {
    Eigen::Map<Eigen::VectorXd> b(rhs.data(), static_cast<Eigen::Index>(rhs.size()));
    const Eigen::VectorXd x = ldlt_.solve(Eigen::VectorXd(order_ * b));
    b = order_.transpose() * x;
  }

private:
  /// Whether small pivots have left enough digits: the backward error of one solution (N. J.
  /// Higham, Accuracy and Stability of Numerical Algorithms, 2nd ed., 2002, ch. 7).
  bool accurate(const Eigen::Map<const Matrix>& lower) {
    const Eigen::VectorXd load =
        Eigen::VectorXd::LinSpaced(lower.rows(), 1, static_cast<double>(lower.rows()))
            .array()
            .sin();
    Eigen::VectorXd solution = load;
    solve({solution.data(), static_cast<std::size_t>(solution.size())});
    const Eigen::VectorXd rest = load - lower.selfadjointView<Eigen::Lower>() * solution;
    const double scale = lower.coeffs().cwiseAbs().maxCoeff() * solution.cwiseAbs().maxCoeff();
    return rest.cwiseAbs().maxCoeff() < kBackwardError * scale;
  }

  /// Approximate minimum degree on the leading unknowns, the rest as they stand.
  static Permutation elimination_order(const Matrix& lower, Index leading) {
    const Matrix block = lower.topLeftCorner(leading, leading);
    Matrix full;
    full = block.selfadjointView<Eigen::Lower>();
    Permutation inverse;
    Eigen::AMDOrdering<Index>()(full, inverse);
    Permutation order(lower.rows());
    order.setIdentity();
    for (Index i = 0; i < leading; ++i) {
      order.indices()[inverse.indices()[i]] = i;
    }
    return order;
  }

  SymmetricPattern pattern_;
  Permutation order_;
  Matrix permuted_;
  Eigen::SimplicialLDLT<Matrix, Eigen::Upper, Eigen::NaturalOrdering<Index>> ldlt_;
};

} // namespace

std::unique_ptr<SparseSolver> make_eigen_solver() {
  return std::make_unique<EigenSolver>();
}

} // namespace foam
