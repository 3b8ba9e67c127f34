// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton's matrix entry by entry, against the products without a matrix, and what comes of
// factorising it.
#include "equilibrium/compressed_matrix.h"

#include <gtest/gtest.h>

#include <Eigen/Sparse>
#include <algorithm>
#include <limits>

#include "../newton_on_host.h"
#include "../two_sided_bubbles.h"
#include "base/error.h"
#include "construct/honeycomb.h"
#include "engines/engines.h"
#include "foams.h"
#include "topology/operations.h"

namespace foam {
namespace {

using namespace newton;
using Matrix = Eigen::SparseMatrix<double, Eigen::RowMajor>;

Foam disordered(Index side) {
  return honeycomb({.columns = side, .rows = side, .displacement = 0.1, .swaps = 0.1});
}

Matrix lower(const LowerTriangle& m) {
  return Eigen::Map<const Matrix>(m.size, m.size, m.entries, m.first, m.column, m.value);
}

/// The matrix of a foam, both ways.
class BothMatrices {
public:
  explicit BothMatrices(Foam& foam, int threads = 1)
      : host_(threads, 1), system_(host_, view_of(foam), foam.mean_spacing(), 0.3),
        junctions_(foam.junction_slots().size()) {}

  Index size() const { return system_.size(); }
  LowerTriangle assemble() { return system_.assemble(); }

  Eigen::VectorXd product(const Eigen::VectorXd& x) {
    Eigen::VectorXd y(size());
    system_.multiply(x.data(), y.data());
    return y;
  }

  bool is_unknown(Index i) const { return system_.is_unknown(i); }
  double regularisation(Index i) const {
    return i < 2 * junctions_ ? kRegularisation : -kRegularisation;
  }

private:
  Host host_;
  test::NewtonSystem<Host> system_;
  Index junctions_;
};

/// One that has lost two-sided bubbles, so that its arrays have gaps.
Foam with_gaps() {
  Foam foam = test::with_two_sided_bubbles(disordered(6));
  for (const Bubble b : foam.bubble_slots()) {
    if (foam.sides[b] == 2 && can_perform_t3(foam, b)) {
      perform_t3(foam, b);
    }
  }
  return foam;
}

void expect_both_the_same(Foam foam) {
  BothMatrices both(foam);
  const LowerTriangle m = both.assemble();
  ASSERT_EQ(m.size, both.size());
  ASSERT_EQ(m.first[0], 0);
  ASSERT_EQ(m.first[m.size], m.entries);
  for (Index row = 0; row < m.size; ++row) {
    ASSERT_LT(m.first[row], m.first[row + 1]);
    for (Index k = m.first[row]; k + 1 < m.first[row + 1]; ++k) {
      EXPECT_LT(m.column[k], m.column[k + 1]);
    }
    EXPECT_EQ(m.column[m.first[row + 1] - 1], row);
  }
  const Matrix compressed = lower(m);
  for (Index column = 0; column < m.size; ++column) {
    const Eigen::VectorXd unit = Eigen::VectorXd::Unit(m.size, column);
    Eigen::VectorXd expected = unit;
    if (both.is_unknown(column)) {
      expected = both.product(unit);
      expected[column] += both.regularisation(column);
    }
    const Eigen::VectorXd found = compressed.selfadjointView<Eigen::Lower>() * unit;
    EXPECT_LT((found - expected).cwiseAbs().maxCoeff(), 1e-13 * (1 + expected.norm()))
        << "column " << column;
  }
}

TEST(CompressedMatrix, IsThatOfTheProducts) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic, Boundary::Fixed}) {
    expect_both_the_same(test::random_foam(16, boundary));
  }
  const Foam gaps = with_gaps();
  ASSERT_LT(gaps.bubble_count(), gaps.bubble_slots().size());
  expect_both_the_same(gaps);
}

TEST(CompressedMatrix, AddsUpWhatFilmsHaveInCommon) {
  expect_both_the_same(test::double_bubble(1, 2)); // whose three films join the same junctions
  const Foam foam = test::with_two_sided_bubbles(disordered(6));
  ASSERT_GT(std::ranges::count(foam.sides, 2), 0);
  expect_both_the_same(foam);
}

TEST(CompressedMatrix, IsTheSameForAnyNumberOfThreads) {
  Foam foam = test::with_two_sided_bubbles(disordered(6));
  BothMatrices by_one(foam);
  BothMatrices by_three(foam, 3);
  const LowerTriangle a = by_one.assemble();
  const LowerTriangle b = by_three.assemble();
  ASSERT_EQ(a.entries, b.entries);
  EXPECT_TRUE(std::equal(a.first, a.first + a.size + 1, b.first));
  EXPECT_TRUE(std::equal(a.column, a.column + a.entries, b.column));
  EXPECT_TRUE(std::equal(a.value, a.value + a.entries, b.value));
}

/// Eigen's LU. \param spoil multiplies its solutions.
class EigenSolver final : public DirectSolver {
public:
  explicit EigenSolver(double spoil = 1) : spoil_(spoil) {}

  void solve(const LowerTriangle& matrix, const double* b, double* x) override {
    const Eigen::SparseMatrix<double> all =
        lower(matrix).selfadjointView<Eigen::Lower>() * identity(matrix.size);
    const Eigen::SparseLU<Eigen::SparseMatrix<double>> factors(all);
    Eigen::Map<Eigen::VectorXd>(x, matrix.size) =
        spoil_ * factors.solve(Eigen::Map<const Eigen::VectorXd>(b, matrix.size));
  }

private:
  static Eigen::SparseMatrix<double> identity(Index size) {
    Eigen::SparseMatrix<double> one(size, size);
    one.setIdentity();
    return one;
  }

  double spoil_;
};

/// A foam whose bubbles' targets change by a tenth, and the equilibrium found for it.
struct Found {
  Foam foam;
  NewtonResult result;
};

Found equilibrate(Boundary boundary, std::unique_ptr<DirectSolver> direct) {
  Foam foam = test::random_foam(60, boundary, 3);
  test::exchange_gas(foam);
  EquilibratorOptions options;
  options.tolerance = 1e-11;
  const NewtonResult result =
      test::equilibrate_on_host(view_of(foam), options, 0, std::move(direct));
  return {foam, result};
}

void expect_same_equilibrium(const Found& a, const Found& b) {
  EXPECT_TRUE(a.result.report.converged);
  EXPECT_TRUE(b.result.report.converged);
  for (const Film f : a.foam.film_slots()) {
    if (a.foam.has_film(f)) {
      EXPECT_NEAR(a.foam.length(f.half()), b.foam.length(f.half()), 1e-9);
    }
  }
}

TEST(DirectSolver, LeadsToTheEquilibriumOfMinres) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic, Boundary::Fixed}) {
    const Found direct = equilibrate(boundary, std::make_unique<EigenSolver>());
    const Found iterative = equilibrate(boundary, nullptr);
    expect_same_equilibrium(direct, iterative);
    EXPECT_EQ(direct.result.inner_iterations, 0) << "every system was solved directly";
    EXPECT_LE(direct.result.report.iterations, iterative.result.report.iterations);
  }
}

/// What is not a solution is not taken for one.
TEST(DirectSolver, IsRelievedByMinresWhereItFails) {
  const Found iterative = equilibrate(Boundary::Periodic, nullptr);
  for (const double spoil : {1.001, std::numeric_limits<double>::quiet_NaN()}) {
    const Found spoilt = equilibrate(Boundary::Periodic, std::make_unique<EigenSolver>(spoil));
    expect_same_equilibrium(spoilt, iterative);
    EXPECT_EQ(spoilt.result.inner_iterations, iterative.result.inner_iterations);
    EXPECT_EQ(spoilt.foam.position, iterative.foam.position);
  }
}

TEST(DirectSolver, IsForTheDeviceAlone) {
  for (const auto& [kind, device] : {std::pair{EquilibratorKind::Newton, Device::CPU},
                                     std::pair{EquilibratorKind::Newton, Device::Auto},
                                     std::pair{EquilibratorKind::Junction, Device::CUDA}}) {
    EquilibratorOptions options;
    options.kind = kind;
    options.device = device;
    options.linear_solver = LinearSolver::Direct;
    try {
      make_equilibrator(options);
      FAIL();
    } catch (const FoamError& error) {
      EXPECT_EQ(std::string(error.what()),
                "LinearSolver = Direct is for Equilibrator = Newton with Device = CUDA alone");
    }
  }
}

} // namespace
} // namespace foam
