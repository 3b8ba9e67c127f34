// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton's method without a factorisation, against the derivatives of the energy, against direct
// solvers, and against NewtonEquilibrator.
#include <gtest/gtest.h>

#include <Eigen/Dense>
#include <Eigen/SparseCore>

#include "../newton_on_host.h"
#include "construct/honeycomb.h"
#include "equilibrium/compressed_matrix.h"
#include "equilibrium/newton_equilibrator.h"
#include "foams.h"

namespace foam {
namespace {

using namespace multigrid;
using namespace newton;

Foam disordered(Index side, double displacement = 0.1, double swaps = 0.1) {
  return honeycomb({.columns = side, .rows = side, .displacement = displacement, .swaps = swaps});
}

/// The equations of a foam, on the host.
class Equations {
public:
  explicit Equations(Foam& foam) : system_(host_, view_of(foam), foam.mean_spacing()) {}

  Index size() const { return system_.size(); }
  const Units& units() const { return system_.units(); }
  bool is_unknown(Index i) const { return system_.is_unknown(i); }
  test::NewtonSystem<Host>& system() { return system_; }

  Eigen::VectorXd right() {
    Eigen::VectorXd vector = Eigen::VectorXd::Zero(size());
    system_.load(vector.data());
    return vector;
  }
  Eigen::VectorXd product(const Eigen::VectorXd& x) {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(size());
    system_.multiply(x.data(), y.data());
    return y;
  }
  Eigen::VectorXd preconditioned(const Eigen::VectorXd& x) {
    Eigen::VectorXd y = Eigen::VectorXd::Zero(size());
    system_.precondition(x.data(), y.data());
    return y;
  }
  int solve(const Eigen::VectorXd& b, Eigen::VectorXd& x, double tolerance) {
    x.resize(size());
    return system_.solve(b.data(), x.data(), tolerance);
  }
  /// The matrix of a linear function, of the unknowns' columns.
  template <class Map> Eigen::MatrixXd matrix_of(const Map& map) const {
    Eigen::MatrixXd all = Eigen::MatrixXd::Zero(size(), size());
    for (Index i = 0; i < size(); ++i) {
      if (is_unknown(i)) {
        all.col(i) = map(Eigen::VectorXd::Unit(size(), i));
      }
    }
    return all;
  }

private:
  Host host_{1};
  test::NewtonSystem<Host> system_;
};

Foam sample(Boundary boundary) {
  Foam foam = boundary == Boundary::Periodic ? disordered(4) : test::random_foam(14, boundary);
  if (boundary == Boundary::Periodic) {
    test::equilibrate(foam);
  }
  for (const Bubble b : foam.bubble_slots()) { // off equilibrium, arcs and all
    foam.pressure[b] += 0.01 * (b.index() % 3);
  }
  for (const Film f : foam.film_slots()) {
    if (!foam.wall(f.half())) {
      foam.film_angle[f] += 0.02 * (f.index() % 5 - 2);
    }
  }
  return foam;
}

class KrylovBoundaries : public testing::TestWithParam<Boundary> {};

/// The half-angles follow, so that to first order a solution takes all of the gradient away:
/// the right-hand side at x + εs is (1 − ε) of that at x, whatever has been eliminated.
TEST_P(KrylovBoundaries, MatrixIsTheGradientsDerivative) {
  Foam foam = sample(GetParam());
  Equations equations(foam);
  const Eigen::VectorXd before = equations.right();
  Eigen::VectorXd direction = Eigen::VectorXd::Zero(equations.size());
  const ConstFoamView mesh = view_of(std::as_const(foam));
  for (Index i = 0; i < equations.size(); ++i) {
    direction[i] = equations.is_unknown(i) ? std::sin(1.0 + i) : 0;
  }
  const Eigen::VectorXd expected = equations.product(direction);
  const auto right_at = [&](double epsilon) {
    Foam moved = foam;
    const FoamView view = view_of(moved);
    const Units units = equations.units();
    const Eigen::VectorXd change = epsilon * direction;
    // The elimination's own part of a half-angle's change, which is there without a step.
    const Eigen::VectorXd none = Eigen::VectorXd::Zero(equations.size());
    for (const Film f : mesh.film_slots()) {
      if (mesh.bends(f)) {
        view.film_angle[f] += angle_change(mesh, f, units, 0, change.data()) -
                              angle_change(mesh, f, units, 0, none.data());
      }
    }
    for (const Junction j : mesh.junction_slots()) {
      view.position[j] += units.length * displacement(change.data(), j);
    }
    for (const Bubble b : mesh.bubble_slots()) {
      view.pressure[b] += units.pressure() * pressure_in(mesh, change.data(), b);
    }
    // The gradient itself: the eliminated angles' residuals left out.
    Field<Film, FilmGradient> gradient(moved.film_angle.size());
    for (const Film f : mesh.film_slots()) {
      if (mesh.bends(f)) {
        const FilmLagrangian phi = film_derivatives(const_view(view), f, units, 0);
        gradient[f] = {{phi.gradient[0], phi.gradient[1]}, {phi.gradient[2], phi.gradient[3]}, 0};
      }
    }
    Host host(1);
    Evaluation<Host> state;
    state.evaluate(host, const_view(view), whole_mesh(const_view(view), units.length));
    Eigen::VectorXd right = Eigen::VectorXd::Zero(equations.size());
    gather_load(host, const_view(view), units, state.areas(),
                FieldView<Film, const FilmGradient>(gradient.data()), right.data());
    return right;
  };
  constexpr double kStep = 1e-5;
  const Eigen::VectorXd measured = -(right_at(kStep) - right_at(-kStep)) / (2 * kStep);
  EXPECT_LT((measured - expected).norm(), 1e-7 * expected.norm());
  EXPECT_GT(before.norm(), 1e-2) << "not in equilibrium";
}

TEST_P(KrylovBoundaries, MatrixIsSymmetric) {
  Foam foam = sample(GetParam());
  Equations equations(foam);
  const Eigen::MatrixXd k =
      equations.matrix_of([&](const auto& x) { return equations.product(x); });
  EXPECT_LT((k - k.transpose()).norm(), 1e-13 * k.norm());
}

/// What MINRES asks of it.
TEST_P(KrylovBoundaries, PreconditionerIsSymmetricAndPositive) {
  Foam foam = sample(GetParam());
  Equations equations(foam);
  const Eigen::MatrixXd p =
      equations.matrix_of([&](const auto& x) { return equations.preconditioned(x); });
  EXPECT_LT((p - p.transpose()).norm(), 1e-12 * p.norm());
  const Eigen::VectorXd eigenvalues =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(p).eigenvalues();
  EXPECT_GT(eigenvalues.minCoeff(), -1e-12 * eigenvalues.maxCoeff());
  Index unknowns = 0; // the others' rows are zero
  for (Index i = 0; i < equations.size(); ++i) {
    unknowns += equations.is_unknown(i) ? 1 : 0;
  }
  const auto positive = (eigenvalues.array() > 1e-6 * eigenvalues.maxCoeff()).count();
  EXPECT_EQ(positive, unknowns);
}

/// The step is that of a matrix that is factorised.
TEST_P(KrylovBoundaries, StepIsThatOfAFactorisation) {
  Foam foam = sample(GetParam());
  Equations equations(foam);
  Eigen::VectorXd right = equations.right();
  equations.system().remove_common_pressure(right.data());
  Eigen::VectorXd solution;
  equations.solve(right, solution, 1e-12);
  Host host;
  FactorisingSolver solver;
  solver.set_up(foam, whole_foam(foam));
  const Domain domain = domain_of(solver.region());
  Evaluation<Host> state;
  state.evaluate(host, view_of(std::as_const(foam)), domain);
  // Of the matrix as it is, wherever it leads: for a residual that is small.
  const StepView* const step = solver.find(foam, domain, state, Residual{});
  ASSERT_NE(step, nullptr);
  // Moves that cost nothing are of no account: compare how films grow.
  double largest = 0;
  double difference = 0;
  for (const Film f : solver.region().films) {
    const Half h = f.half();
    const Vec2 there = step->chord_change(view_of(std::as_const(foam)), f);
    const Vec2 here = equations.units().length * (displacement(solution.data(), foam.end(h)) -
                                                  displacement(solution.data(), foam.start(h)));
    const Vec2 along = (1 / norm(foam.chord(h))) * foam.chord(h);
    largest = std::max(largest, std::abs(dot(there, along)));
    difference = std::max(difference, std::abs(dot(here - there, along)));
  }
  EXPECT_LT(difference, 1e-5 * largest);
}

/// And that of the same matrix entry by entry, once moves that cost nothing are taken out.
TEST_P(KrylovBoundaries, StepIsThatOfTheCompressedMatrix) {
  Foam foam = sample(GetParam());
  Equations equations(foam);
  Eigen::VectorXd right = equations.right();
  equations.system().remove_common_pressure(right.data());
  Eigen::VectorXd iterative;
  equations.solve(right, iterative, 1e-12);
  const LowerTriangle m = equations.system().assemble();
  const Eigen::Map<const Eigen::SparseMatrix<double, Eigen::RowMajor>> lower(
      m.size, m.size, m.entries, m.first, m.column, m.value);
  const Eigen::MatrixXd all = Eigen::MatrixXd(lower).selfadjointView<Eigen::Lower>();
  Eigen::VectorXd direct = all.partialPivLu().solve(right);
  for (Eigen::VectorXd* solution : {&iterative, &direct}) {
    equations.system().remove_common_pressure(solution->data());
    equations.system().remove_rigid_motion(solution->data());
  }
  EXPECT_GT(direct.norm(), 1e-2);
  EXPECT_LT((direct - iterative).norm(), 1e-5 * direct.norm());
}

INSTANTIATE_TEST_SUITE_P(Krylov, KrylovBoundaries,
                         testing::Values(Boundary::Free, Boundary::Periodic, Boundary::Fixed));

/// Coarsened elements have the energy of what the coarse grid's displacements are on the fine one.
TEST(Krylov, CoarsenedElementsAreThoseOfTheNestedSpace) {
  const Grid fine{8, 4, true, {}, {0.5, 0}, {0.2, 1}};
  std::vector<Element> elements(place_of(fine.cells()));
  for (Index cell = 0; cell < fine.cells(); ++cell) {
    for (int corner = 0; corner < 4; ++corner) {
      ElementRows rows;
      rows.add_square({cell, {0.3, 0.6}}, fine, corner, {1, 0.2}, {-0.4, 0.7}, 1.0 + cell);
      rows.write(elements[place_of(cell)], corner);
    }
  }
  const Grid coarse = fine.coarsened();
  std::vector<Element> coarsened(place_of(coarse.cells()));
  Host host;
  coarsen_elements(host, fine, coarse, elements.data(), coarsened.data());
  const auto n = static_cast<std::size_t>(2 * fine.nodes());
  const auto m = static_cast<std::size_t>(2 * coarse.nodes());
  for (std::size_t i = 0; i < m; ++i) {
    std::vector<double> x(m), up(n), product(n), down(m);
    x[i] = 1;
    prolongate(host, fine, coarse, x.data(), up.data());
    for (Index node = 0; node < fine.nodes(); ++node) {
      set_displacement(product.data(), node,
                       GridMatrix{fine, elements.data()}.row(up.data(), node));
    }
    restrict_to(host, coarse, fine, product.data(), down.data());
    for (Index node = 0; node < coarse.nodes(); ++node) {
      const Vec2 row = GridMatrix{coarse, coarsened.data()}.row(x.data(), node);
      EXPECT_NEAR(row.x, down[place_of(2 * node)], 1e-12);
      EXPECT_NEAR(row.y, down[place_of(2 * node + 1)], 1e-12);
    }
  }
}

/// Sixteen times the bubbles, about the same iterations.
TEST(Krylov, IterationsDoNotGrowWithTheFoam) {
  const auto iterations = [](Index side) {
    Foam foam = disordered(side, 0.15, 0.2);
    EXPECT_TRUE(
        test::KrylovEquilibrator(EquilibratorOptions{}).equilibrate(foam, 0.05, {}).converged);
    Equations equations(foam);
    Eigen::VectorXd right = Eigen::VectorXd::Zero(equations.size());
    for (const Bubble b : foam.bubble_slots()) {
      right[2 * foam.junction_slots().size() + b.index()] = foam.sides[b] - 6;
    }
    Eigen::VectorXd solution;
    const int count = equations.solve(right, solution, 1e-6);
    EXPECT_LT((equations.product(solution) - right).norm(), 1e-5 * right.norm());
    return count;
  };
  const int few = iterations(16);
  const int many = iterations(64);
  EXPECT_LT(few, 40);
  EXPECT_LT(many, 1.3 * few);
}

EquilibratorOptions to(double tolerance) {
  EquilibratorOptions options;
  options.tolerance = tolerance;
  return options;
}

void expect_same_equilibrium(const Foam& a, const Foam& b) {
  ASSERT_EQ(a.half_junction, b.half_junction);
  for (const Film f : a.film_slots()) {
    if (a.has_film(f)) {
      EXPECT_NEAR(a.length(f.half()), b.length(f.half()), 1e-8 * a.mean_spacing());
    }
  }
}

TEST(Krylov, FindsTheEquilibriumOfThePeriodicFoam) {
  Foam here = disordered(12, 0.1, 0.1);
  Foam there = here;
  const double t1_length = 0.01;
  EXPECT_TRUE(test::KrylovEquilibrator(to(1e-11)).equilibrate(here, t1_length, {}).converged);
  EXPECT_TRUE(NewtonEquilibrator(to(1e-11)).equilibrate(there, t1_length, {}).converged);
  test::expect_equilibrium(here);
  test::expect_valid(here);
  expect_same_equilibrium(here, there);
}

/// A foam in equilibrium whose bubbles' targets change by a tenth, with every boundary.
TEST(Krylov, FollowsTheGas) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic, Boundary::Fixed}) {
    Foam here = test::random_foam(60, boundary, 3);
    test::exchange_gas(here);
    Foam there = here;
    EXPECT_TRUE(test::KrylovEquilibrator(to(1e-11)).equilibrate(here, 0, {}).converged)
        << static_cast<int>(boundary) << " " << here.report.residual;
    EXPECT_TRUE(NewtonEquilibrator(to(1e-11)).equilibrate(there, 0, {}).converged);
    test::expect_equilibrium(here);
    test::expect_valid(here);
    expect_same_equilibrium(here, there);
  }
}

/// Its outer films are semicircles, for which ∂²φ/∂α² is 0; its length is known in closed form.
TEST(Krylov, FindsTheTripleBubble) {
  BuildOptions options;
  options.surface_tension = 0.5;
  options.target_areas = TargetAreas::Array;
  options.target_area_array = {1, 1, 1};
  Foam foam = build_from_points(std::vector<Vec2>{{0, 0}, {1, 0}, {0.5, 0.8}}, options);
  test::KrylovEquilibrator(to(1e-10)).equilibrate(foam, 0, {});
  test::expect_equilibrium(foam);
  EXPECT_NEAR(foam.energy(), 8.793934128446, 1e-9);
}

/// Films that are short and pulled shut are swapped on the way.
TEST(Krylov, SwapsFilmsThatArePulledShut) {
  Foam foam = disordered(16, 0.15, 0.5);
  test::KrylovEquilibrator(EquilibratorOptions{}).equilibrate(foam, 0.4, {});
  EXPECT_GT(foam.t1_count, 0);
  test::expect_equilibrium(foam);
  test::expect_valid(foam);
}

TEST(Krylov, GivesTheSameBitsForAnyNumberOfThreads) {
  std::vector<Foam> foams;
  for (const int threads : {1, 2, 5}) {
    foams.push_back(disordered(12, 0.15, 0.5));
    test::KrylovEquilibrator(EquilibratorOptions{}, Host(threads, 64))
        .equilibrate(foams.back(), 0.4, {});
    EXPECT_TRUE(foams.back().report.converged);
    EXPECT_EQ(foams.back().position, foams.front().position);
    EXPECT_EQ(foams.back().pressure, foams.front().pressure);
    EXPECT_EQ(foams.back().film_angle, foams.front().film_angle);
    EXPECT_EQ(foams.back().half_junction, foams.front().half_junction);
  }
}

TEST(Krylov, LeavesTheFoamAsItWasWhenItIsAborted) {
  const Foam start = disordered(8);
  Foam foam = start;
  int calls = 0;
  EXPECT_THROW(test::KrylovEquilibrator(EquilibratorOptions{})
                   .equilibrate(foam, 0.1, [&] { return ++calls > 2; }),
               Aborted);
  EXPECT_EQ(foam.position, start.position);
  EXPECT_EQ(foam.pressure, start.pressure);
  EXPECT_EQ(foam.topology, start.topology);
}

} // namespace
} // namespace foam
