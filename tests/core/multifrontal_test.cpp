// SPDX-License-Identifier: GPL-3.0-or-later
//
// The factorisation of a foam's Newton matrix against dense linear algebra.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <numeric>
#include <random>

#include "algebra/dense_elimination.h"
#include "algebra/generalised_conjugate_residuals.h"
#include "algebra/patch_correction.h"
#include "equilibrium/nested_dissection.h"
#include "equilibrium/newton_matrix.h"
#include "foams.h"

namespace foam {
namespace {

/// A region's Newton matrix, and the same as a dense one.
struct System {
  System(const Foam& foam, Region of, bool keep_angles) : region(std::move(of)) {
    std::vector<char> keep(region.films.size(), keep_angles ? 1 : 0);
    matrix.set_up(foam, region, keep);
    EXPECT_TRUE(matrix.assemble(foam, region, 0));
    const auto size = matrix.unknowns().count();
    const std::vector<double> diagonal = matrix.diagonal();
    dense = Eigen::Map<const Eigen::VectorXd>(diagonal.data(), size).asDiagonal();
    for (const FilmMatrix& share : matrix.shares()) {
      for_each_lower<7>([&](std::size_t row, std::size_t column, std::size_t k) {
        const Index u = share.unknown[row];
        const Index v = share.unknown[column];
        if (u != kNone && v != kNone) {
          dense(u, v) += share.value[k];
          if (row != column) {
            dense(v, u) += share.value[k];
          }
        }
      });
    }
  }

  EliminationTree tree(const Foam& foam) const {
    return nested_dissection(foam, region, matrix.unknowns());
  }

  Region region;
  NewtonMatrix matrix;
  Eigen::MatrixXd dense;
};

Eigen::VectorXd some_load(Eigen::Index size) {
  return Eigen::VectorXd::LinSpaced(size, 0, 10).array().cos();
}

void expect_solved(const Foam& foam, const Region& region, bool keep_angles) {
  const System system(foam, region, keep_angles);
  MultifrontalSolver solver;
  solver.analyse(system.tree(foam), system.matrix.shares());
  const Index negative = solver.factorise(system.matrix.shares(), system.matrix.diagonal());

  const Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd> exact(system.dense, Eigen::EigenvaluesOnly);
  EXPECT_EQ(negative, (exact.eigenvalues().array() < 0).count());
  const Eigen::VectorXd load = some_load(system.dense.rows());
  Eigen::VectorXd solution = load;
  solver.solve({solution.data(), static_cast<std::size_t>(solution.size())});
  const double scale = system.dense.cwiseAbs().maxCoeff() * solution.cwiseAbs().maxCoeff();
  EXPECT_LT((system.dense * solution - load).cwiseAbs().maxCoeff(), 1e-9 * scale);
}

class MultifrontalOfAnyBoundary : public testing::TestWithParam<Boundary> {};

TEST_P(MultifrontalOfAnyBoundary, SolvesWhatDenseAlgebraSolvesAndHasItsInertia) {
  const Foam foam = test::random_foam(90, GetParam());
  for (const bool keep_angles : {false, true}) {
    expect_solved(foam, whole_foam(foam), keep_angles || GetParam() == Boundary::Free);
    for (const int rings : {0, 1, 2}) { // with films whose ends are held between bubbles
      expect_solved(foam, patch(foam, std::array{Bubble(20), Bubble(70)}, rings), true);
    }
  }
}

/// Unknowns of one film are eliminated one above the other in the tree, so that different branches
/// share no equation.
TEST_P(MultifrontalOfAnyBoundary, BranchesShareNoEquation) {
  const Foam foam = test::random_foam(300, GetParam());
  const System system(foam, whole_foam(foam), true);
  const EliminationTree tree = system.tree(foam);

  std::vector<Index> sorted = tree.order;
  std::ranges::sort(sorted);
  std::vector<Index> all(sorted.size());
  std::iota(all.begin(), all.end(), 0);
  ASSERT_EQ(sorted, all);
  std::vector<Index> node_of(sorted.size(), kNone);
  std::vector<Index> parent(tree.nodes.size(), kNone);
  for (std::size_t n = 0; n < tree.nodes.size(); ++n) {
    for (Index i = tree.nodes[n].begin; i < tree.nodes[n].end; ++i) {
      node_of[place_of(tree.order[place_of(i)])] = static_cast<Index>(n);
    }
    for (const Index child : tree.nodes[n].children) {
      if (child != kNone) {
        EXPECT_LT(child, static_cast<Index>(n));
        EXPECT_EQ(parent[place_of(child)], kNone);
        parent[place_of(child)] = static_cast<Index>(n);
      }
    }
  }
  const auto above = [&](Index upper, Index lower) {
    while (lower != kNone && lower != upper) {
      lower = parent[place_of(lower)];
    }
    return lower == upper;
  };
  for (const FilmMatrix& share : system.matrix.shares()) {
    for (const Index u : share.unknown) {
      for (const Index v : share.unknown) {
        if (u != kNone && v != kNone) {
          const Index p = node_of[place_of(u)];
          const Index q = node_of[place_of(v)];
          EXPECT_TRUE(above(p, q) || above(q, p)) << u << ' ' << v;
        }
      }
    }
  }
}

INSTANTIATE_TEST_SUITE_P(Boundaries, MultifrontalOfAnyBoundary,
                         testing::Values(Boundary::Free, Boundary::Periodic, Boundary::Fixed));

TEST(Multifrontal, GivesTheSameBitsForAnyNumberOfThreads) {
  const Foam foam = test::random_foam(4000, Boundary::Periodic);
  NewtonMatrix matrix;
  const Region region = whole_foam(foam);
  matrix.set_up(foam, region, std::vector<char>(region.films.size(), 0));
  matrix.assemble(foam, region, 0);
  std::vector<double> first;
  for (const int threads : {1, 2, 5}) {
    MultifrontalSolver solver(threads);
    solver.analyse(nested_dissection(foam, region, matrix.unknowns()), matrix.shares());
    EXPECT_EQ(solver.factorise(matrix.shares(), matrix.diagonal()), 4000);
    std::vector<double> solution(place_of(matrix.unknowns().count()), 1.0);
    solver.solve(solution);
    solver.round();
    solver.solve(solution);
    if (first.empty()) {
      first = solution;
    }
    EXPECT_EQ(solution, first) << threads;
  }
}

/// Refinement with rounded factors finds the solution, translations and the common pressure
/// included.
TEST_P(MultifrontalOfAnyBoundary, RoundedFactorsPreconditionARefinement) {
  const Foam foam = test::random_foam(300, GetParam());
  const System system(foam, whole_foam(foam), true);
  MultifrontalSolver solver;
  solver.analyse(system.tree(foam), system.matrix.shares());
  solver.factorise(system.matrix.shares(), system.matrix.diagonal());
  const auto size = static_cast<std::size_t>(system.dense.rows());
  const Eigen::VectorXd wanted = some_load(system.dense.rows());
  Eigen::VectorXd rest = system.dense * wanted;
  Eigen::VectorXd found = Eigen::VectorXd::Zero(wanted.size());
  solver.round();
  for (int step = 0; step < 8; ++step) {
    Eigen::VectorXd change = rest;
    solver.solve({change.data(), size});
    found += change;
    rest = system.dense * (wanted - found);
  }
  EXPECT_LT((found - wanted).norm(), 1e-9 * wanted.norm());
}

TEST(Multifrontal, RefusesAMatrixThatIsSingular) {
  const Foam foam = test::random_foam(20, Boundary::Periodic);
  const System system(foam, whole_foam(foam), false);
  MultifrontalSolver solver;
  solver.analyse(system.tree(foam), system.matrix.shares());
  const std::vector<double> nothing(place_of(system.matrix.unknowns().count()), 0.0);
  std::vector<FilmMatrix> shares(system.matrix.shares().begin(), system.matrix.shares().end());
  for (FilmMatrix& share : shares) {
    share.value.fill(0);
  }
  EXPECT_EQ(solver.factorise(std::span<const FilmMatrix>(shares), nothing), -1);
}

TEST(PatchCorrection, RestoresASolutionThatIsWrongInThePatchAlone) {
  const Foam foam = test::random_foam(300, Boundary::Periodic);
  const System whole(foam, whole_foam(foam), false);
  const System part(foam, patch(foam, std::array{Bubble(150)}, 1), false);
  const auto columns = whole.matrix.unknowns().of_films(foam, part.region.films);
  const Eigen::VectorXd solution = some_load(whole.dense.rows());
  const Eigen::VectorXd load = whole.dense * solution;
  Eigen::VectorXd found = solution;
  for (std::size_t f = 0; f < columns.size(); ++f) {
    for (std::size_t k = 0; k < columns[f].size(); ++k) {
      if (part.matrix.shares()[f].unknown[k] != kNone) {
        found[columns[f][k]] += 0.1 * static_cast<double>(k + 1);
      }
    }
  }
  EXPECT_GT((found - solution).norm(), 1);
  PatchCorrection<7> correction;
  ASSERT_TRUE(correction.set_up({part.matrix.shares().begin(), part.matrix.shares().end()},
                                part.matrix.diagonal(), columns, part.tree(foam)));
  const auto size = static_cast<std::size_t>(found.size());
  correction.correct(correction.part_of({load.data(), size}), {found.data(), size});
  EXPECT_LT((found - solution).norm(), 1e-6 * solution.norm()); // regularised a little otherwise
}

/// K = L·D·Lᵀ put together again, for sizes around those of tiles and blocks.
TEST(DenseElimination, LeavesFactorsAndTheSchurComplement) {
  std::mt19937_64 generator(1);
  std::uniform_real_distribution<double> entry(-1, 1);
  for (const Eigen::Index size : {1, 5, 8, 47, 100, 333}) {
    for (const Eigen::Index count : {Eigen::Index{0}, size / 3, size}) {
      Eigen::MatrixXd k =
          Eigen::MatrixXd::NullaryExpr(size, size, [&] { return entry(generator); });
      k = (k + k.transpose()).eval();
      for (Eigen::Index i = 0; i < size; ++i) {
        k(i, i) = (i % 3 == 0 ? -2.0 : 2.0) * static_cast<double>(size);
      }
      const Eigen::Index left = size - count;
      Eigen::MatrixXd columns = k.leftCols(count);
      Eigen::MatrixXd rest = k.bottomRightCorner(left, left);
      Eigen::VectorXd pivots(count);
      ASSERT_TRUE(eliminate_densely({columns.data(), static_cast<std::size_t>(columns.size())},
                                    {rest.data(), static_cast<std::size_t>(rest.size())},
                                    {pivots.data(), static_cast<std::size_t>(count)}, 1e-10));
      Eigen::MatrixXd l = columns;
      l.topRows(count) = l.topRows(count).triangularView<Eigen::UnitLower>();
      Eigen::MatrixXd again = l * pivots.asDiagonal() * l.transpose();
      again.bottomRightCorner(left, left) += rest.selfadjointView<Eigen::Lower>();
      const double error = (again - k).cwiseAbs().maxCoeff();
      EXPECT_LT(error, 1e-13 * k.cwiseAbs().maxCoeff()) << size << ' ' << count;
    }
  }
}

/// For sizes around those of columns that are taken together.
TEST(DenseElimination, SolvesWithWhatIsLeftAndWithTheSameRounded) {
  std::mt19937_64 generator(2);
  std::uniform_real_distribution<double> entry(-1, 1);
  for (const Eigen::Index size : {1, 4, 9, 30, 101}) {
    for (const Eigen::Index count : {Eigen::Index{0}, (size + 2) / 3, size}) {
      const Eigen::MatrixXd columns = Eigen::MatrixXd::NullaryExpr(
          size, count, [&] { return entry(generator) / static_cast<double>(size); });
      Eigen::MatrixXd l = Eigen::MatrixXd::Identity(size, size);
      l.leftCols(count).triangularView<Eigen::StrictlyLower>() = columns;
      const Eigen::MatrixXf rounded = columns.cast<float>();
      const auto length = static_cast<std::size_t>(size);
      const auto entries = static_cast<std::size_t>(columns.size());
      const Eigen::VectorXd load = some_load(size);
      const auto expect_solved = [&](const auto& lower, const auto& upper, double error) {
        Eigen::VectorXd x = load;
        lower(std::span(x.data(), length));
        EXPECT_LT((l * x - load).cwiseAbs().maxCoeff(), error) << size << ' ' << count;
        x = load;
        upper(std::span(x.data(), length));
        EXPECT_LT((l.transpose() * x - load).cwiseAbs().maxCoeff(), error) << size << ' ' << count;
      };
      const std::span all(columns.data(), entries);
      expect_solved([&](std::span<double> x) { solve_lower(all, x); },
                    [&](std::span<double> x) { solve_upper(all, x); }, 1e-13);
      const std::span all_rounded(rounded.data(), entries);
      expect_solved([&](std::span<double> x) { solve_lower(all_rounded, x); },
                    [&](std::span<double> x) { solve_upper(all_rounded, x); }, 1e-5);
    }
  }
}

TEST(DenseElimination, RefusesASmallPivot) {
  std::vector<double> columns{1e-12, 1, 1, 1};
  std::vector<double> pivots(2);
  EXPECT_FALSE(eliminate_densely(columns, {}, pivots, 1e-10));
}

/// An indefinite system whose preconditioner is wrong in three entries is solved in four steps.
TEST(ConjugateResiduals, NeedOneDirectionForEachKindOfError) {
  const std::vector<double> k{1, -2, 3, 4, -5, 6, 7, 8};
  const std::vector<double> load{1, 1, 1, 1, 1, 1, 1, 1};
  const std::vector<double> weight(8, 1.0);
  std::vector<double> x(8, 0.0);
  std::vector<double> rest = load;
  int steps = 0;
  const bool solved = generalised_conjugate_residuals(
      std::span<double>(x), rest, weight, 1e-12, 4,
      [&](std::span<const double> z, std::span<double> from) {
        for (std::size_t i = 0; i < 8; ++i) {
          from[i] -= k[i] * z[i];
        }
      },
      [&](std::span<double> z) {
        ++steps;
        for (std::size_t i = 0; i < 8; ++i) {
          z[i] *= (i == 2 ? 2.0 : i == 5 ? 0.5 : i == 6 ? 3.0 : 1.0) / k[i];
        }
      });
  EXPECT_TRUE(solved);
  EXPECT_EQ(steps, 4);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_NEAR(x[i], 1 / k[i], 1e-12);
  }
}

} // namespace
} // namespace foam
