// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <random>

#include "base/error.h"
#include "construct/jittered_grid.h"
#include "engines/engines.h"
#include "junction_foams.h"
#include "thesis/junction_equilibrator.h"

namespace foam {
namespace {

using namespace thesis;
using std::numbers::pi;

constexpr AngleRootSearch kAngles;
constexpr std::array<bool, 5> kNoneIgnored{};

/// A_i, A_j, A_k, θ_i, θ_j, θ_k of a junction as the mesh itself measures them.
std::array<double, 6> measured(Foam foam, Junction j) {
  set_half_angles(foam);
  std::array<double, 6> result{};
  const auto& halves = foam.junction_half[j];
  for (std::size_t k = 0; k < 3; ++k) {
    const Bubble b = foam.left(halves[k]);
    result[k] = b.is_outside() ? 0 : foam.area(b);
    const double angle = angle_from_to(foam.tangent(halves[k]), foam.tangent(halves[(k + 1) % 3]));
    result[3 + k] = angle < 0 ? angle + 2 * pi : angle;
  }
  return result;
}

/// Adds s to the unknown c (p_i, p_j, p_k, x, y) of a junction.
void vary(Foam& foam, Junction j, std::size_t c, double s) {
  if (c < 3) {
    foam.pressure[foam.left(foam.junction_half[j][c])] += s;
  } else {
    (c == 3 ? foam.position[j].x : foam.position[j].y) += s;
  }
}

/// ∂(measured)/∂(unknown c) by differences of sixth order.
std::array<double, 6> measured_derivative(const Foam& foam, Junction j, std::size_t c) {
  constexpr std::array<double, 3> kWeights{45.0 / 60, -9.0 / 60, 1.0 / 60};
  constexpr double kStep = 1e-3;
  std::array<double, 6> derivative{};
  for (std::size_t i = 0; i < 3; ++i) {
    for (const double sign : {1.0, -1.0}) {
      Foam moved = foam;
      vary(moved, j, c, sign * static_cast<double>(i + 1) * kStep);
      const auto value = measured(moved, j);
      for (std::size_t r = 0; r < 6; ++r) {
        derivative[r] += sign * kWeights[i] * value[r] / kStep;
      }
    }
  }
  return derivative;
}

double local_energy_of(const Foam& foam, Junction j) {
  return local_energy(junction_star(foam, j));
}

JunctionStep movement(Vec2 step) {
  return {{}, step};
}

EquilibratorOptions options_with(Sweep sweep, bool energy_decay, bool orientation_invariant) {
  EquilibratorOptions options;
  options.kind = EquilibratorKind::Junction;
  options.junction.sweep = sweep;
  options.junction.energy_decay = energy_decay;
  options.junction.orientation_invariant = orientation_invariant;
  return options;
}

// The thesis's film (3.3).

TEST(ThesisFilm, HalfAngleIsThatOfACircle) {
  const double radius = 2;
  const double tension = 0.5;
  const double dp = tension / radius; // Laplace–Young
  const double alpha = 0.4;
  const double chord = 2 * radius * std::sin(alpha);
  EXPECT_NEAR(thesis_half_angle(chord, dp, tension), alpha, 1e-15);
  EXPECT_NEAR(thesis_half_angle(chord, -dp, tension), -alpha, 1e-15);
  EXPECT_EQ(thesis_half_angle(chord, 0, tension), 0);
  // Sector less triangle (3.3.10).
  EXPECT_NEAR(segment_area(chord, alpha), 0.5 * radius * radius * (2 * alpha - std::sin(2 * alpha)),
              1e-15);
  EXPECT_NEAR(arc_length(chord, alpha), 2 * alpha * radius, 1e-15); // (3.5.1)
}

TEST(ThesisFilm, IsClampedToTheHalfCircle) {
  EXPECT_DOUBLE_EQ(thesis_half_angle(1, 100, 0.5), pi / 2);
  EXPECT_DOUBLE_EQ(thesis_half_angle(1, -100, 0.5), -pi / 2);
}

// Areas and angles (3.3.7, 3.3.12).

TEST(JunctionSystem, AreasAndAnglesAreTheMeshes) {
  Foam foam = honeycomb(6, 3);
  disturb(foam, 0.1, 1);
  for (const Junction j : foam.junction_slots()) {
    const JunctionStar star = junction_star(foam, j);
    const auto expected = measured(foam, j);
    const auto angle = angles_between(star);
    for (std::size_t k = 0; k < 3; ++k) {
      EXPECT_NEAR(thesis_area(foam, star.half[k]), expected[k], 1e-13);
      EXPECT_NEAR(angle[k], expected[3 + k], 1e-13);
    }
    EXPECT_NEAR(angle[0] + angle[1] + angle[2], 2 * pi, 1e-13);
  }
}

TEST(JunctionSystem, AreaOfALens) { // two half circles of radius 1 and a straight chord's worth
  Foam foam = triple();
  // One bubble's outer film becomes a half circle over the chord √3, in the limit of the clamp.
  foam.pressure[Bubble(0)] = 1e3;
  const Half first = foam.bubble_half[Bubble(0)];
  const double chord = std::sqrt(3);
  const double outer = pi / 8 * chord * chord;
  const double inner = pi / 8; // over the two films of length 1, on the neighbours' account
  EXPECT_NEAR(thesis_area(foam, first), foam.target_area[Bubble(0)] + outer + 2 * inner, 1e-12);
}

TEST(JunctionSystem, EdgeAngleRunsOnPast180Degrees) { // (3.3.4)
  const Vec2 e{1, 0};
  EXPECT_DOUBLE_EQ(edge_angle(e, {0, 1}), pi / 2);
  EXPECT_DOUBLE_EQ(edge_angle(e, {0, -1}), 3 * pi / 2);
  EXPECT_EQ(edge_angle(e, e), 0); // two-sided bubbles (3.6)
}

TEST(JunctionSystem, EnergyOfStraightFilms) { // (3.5.2)
  EXPECT_DOUBLE_EQ(local_energy_of(triple(), Junction(0)), 2 * 0.25 * 3);
}

// ∇f_j (3.1).

TEST(JunctionSystem, JacobianIsTheMeshesDerivative) {
  Foam foam = honeycomb(6, 3);
  disturb(foam, 0.1, 2);
  for (Index i = 0; i < foam.junction_slots().size(); i += 5) {
    const Junction j(i);
    const Matrix5 jacobian = junction_jacobian(kAngles, foam, junction_star(foam, j), 1e-4);
    for (std::size_t c = 0; c < 5; ++c) {
      const auto expected = measured_derivative(foam, j, c);
      for (std::size_t r = 0; r < 5; ++r) {
        EXPECT_NEAR(jacobian[r][c], expected[r], 1e-5) << "row " << r << " column " << c;
      }
    }
  }
}

TEST(JunctionSystem, DifferencesAreOfSecondOrder) {
  Foam foam = honeycomb(6, 3);
  disturb(foam, 0.1, 3);
  const JunctionStar star = junction_star(foam, Junction(7));
  const auto error = [&](double h) {
    double largest = 0;
    const Matrix5 jacobian = junction_jacobian(kAngles, foam, star, h);
    for (std::size_t c = 0; c < 5; ++c) {
      const auto expected = measured_derivative(foam, Junction(7), c);
      for (std::size_t r = 0; r < 5; ++r) {
        largest = std::max(largest, std::abs(jacobian[r][c] - expected[r]));
      }
    }
    return largest;
  };
  EXPECT_NEAR(error(0.01) / error(0.005), 4, 0.1);
}

TEST(JunctionSystem, LeavesOutTheOutside) { // (3.4.1)
  Foam foam = triple();
  foam.pressure = {0.05, 0.06, 0.07};
  for (const Junction j : {Junction(1), Junction(2), Junction(3)}) {
    const JunctionStar star = junction_star(foam, j);
    const std::size_t outside =
        static_cast<std::size_t>(std::ranges::find(star.bubble, kWorld) - star.bubble.begin());
    const Matrix5 jacobian = junction_jacobian(kAngles, foam, star, 1e-4);
    const auto angles = AngleRootSearch::angles(star);
    EXPECT_TRUE(std::ranges::find(angles, outside) == angles.end());
    for (std::size_t c = 0; c < 5; ++c) {
      EXPECT_EQ(jacobian[outside][c], 0);
      EXPECT_TRUE(c == outside || jacobian[after(outside)][c] != 0);
      if (c == outside) {
        continue;
      }
      const auto expected = measured_derivative(foam, j, c);
      for (std::size_t k = 0; k < 2; ++k) {
        EXPECT_NEAR(jacobian[3 + k][c], expected[3 + angles[k]], 1e-5);
      }
    }
    for (std::size_t r = 0; r < 5; ++r) {
      EXPECT_EQ(jacobian[r][outside], 0);
    }
    const JunctionSystem system = junction_system(kAngles, foam, j, star, {0.01, 1, 1e-5});
    EXPECT_TRUE(system.ignored[outside]);
    const JunctionStep step = kAngles.solve(star, system);
    EXPECT_TRUE(step.finite());
    EXPECT_EQ(step.pressure[outside], 0);
  }
}

TEST(JunctionSystem, StepSizeAdaptsToTheTolerance) { // Figure 4.1
  Foam foam = honeycomb(6, 3);
  disturb(foam, 0.1, 4);
  const JunctionStar star = junction_star(foam, Junction(3));
  // A large tolerance is met by the first difference from zero, with the full step.
  EXPECT_EQ(adaptive_jacobian(kAngles, foam, star, {0.05, 1e3, 1e-5}),
            junction_jacobian(kAngles, foam, star, 0.05));
  // A smaller one by the second of two that agree.
  const Matrix5 full = junction_jacobian(kAngles, foam, star, 0.05);
  const Matrix5 half = junction_jacobian(kAngles, foam, star, 0.025);
  const double between = row_norm_of_difference(full, half);
  EXPECT_EQ(adaptive_jacobian(kAngles, foam, star, {0.05, 1.01 * between, 1e-5}), half);
  // One that cannot be met ends at the least scale, which is above 1/4 here.
  EXPECT_EQ(adaptive_jacobian(kAngles, foam, star, {0.05, 1e-300, 0.3}), half);
}

TEST(JunctionSystem, SolutionIsANewtonStep) {
  Foam foam = honeycomb(6, 3);
  disturb(foam, 0.02, 5);
  const auto deviation = [&](const Foam& f) {
    const JunctionStar star = junction_star(f, Junction(9));
    const JunctionSystem system =
        junction_system(kAngles, f, Junction(9), star, {1e-4, 1e-6, 1e-5});
    double largest = 0;
    for (const double d : system.deviation) {
      largest = std::max(largest, std::abs(d));
    }
    return std::pair{largest, kAngles.solve(star, system)};
  };
  const auto [before_step, step] = deviation(foam);
  for (std::size_t k = 0; k < 3; ++k) {
    vary(foam, Junction(9), k, step.pressure[k]);
  }
  foam.position[Junction(9)] += step.position;
  EXPECT_LT(deviation(foam).first, 0.1 * before_step);
}

// Gauss–Jordan (Appendix B.1).

TEST(GaussJordan, FindsTheSolutionThatTheRightHandSideWasMadeOf) {
  std::mt19937 generator(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (std::size_t ignored = 0; ignored < 4; ++ignored) { // 3: none, else the outside's place
    std::array<bool, 5> mask{};
    mask[ignored] = ignored < 3;
    Matrix5 a{};
    Vector5 expected{};
    for (std::size_t r = 0; r < 5; ++r) {
      expected[r] = mask[r] ? 0 : uniform(generator);
      for (std::size_t c = 0; c < 5; ++c) {
        a[r][c] = uniform(generator) + (r == c ? 4 : 0);
      }
    }
    Vector5 x{};
    for (std::size_t r = 0; r < 5; ++r) {
      for (std::size_t c = 0; c < 5; ++c) {
        x[r] += a[r][c] * expected[c];
      }
    }
    const Vector5 z = gauss_jordan(a, x, mask);
    for (std::size_t r = 0; r < 5; ++r) {
      EXPECT_NEAR(z[r], expected[r], 1e-14) << "row " << r << ", ignored " << ignored;
    }
  }
}

TEST(GaussJordan, ExchangesTheTwoAnglesInASymmetricJunction) {
  Matrix5 a{};
  a[0][0] = a[1][1] = a[2][2] = 1;
  a[3][4] = a[4][3] = 2;
  EXPECT_EQ(gauss_jordan(a, {1, 2, 3, 4, 6}, kNoneIgnored), (Vector5{1, 2, 3, 3, 2}));
}

TEST(GaussJordan, SingularIsNotFinite) {
  const Vector5 z = gauss_jordan({}, {1, 1, 1, 1, 1}, kNoneIgnored);
  EXPECT_FALSE((JunctionStep{{z[0], z[1], z[2]}, {z[3], z[4]}}).finite());
}

// One junction (3.1.3, 3.5, 4.2).

TEST(Junction, PressureChangesAreSharedAmongTheFilms) { // (3.1.3)
  Foam foam = honeycomb(6, 3);
  disturb(foam, 0.05, 6);
  const Foam old = foam;
  JunctionOptions options;
  options.energy_decay = false;
  const JunctionStep z = junction_step(foam, Junction(4), options);
  equilibrate_junction(foam, Junction(4), options);
  const JunctionStar star = junction_star(old, Junction(4));
  for (std::size_t k = 0; k < 3; ++k) {
    const Bubble b = star.bubble[k];
    EXPECT_DOUBLE_EQ(foam.pressure[b], old.pressure[b] + 0.1 * z.pressure[k] / old.sides[b]);
  }
  EXPECT_DOUBLE_EQ(foam.position[Junction(4)].x, old.position[Junction(4)].x + 0.1 * z.position.x);
  EXPECT_DOUBLE_EQ(foam.position[Junction(4)].y, old.position[Junction(4)].y + 0.1 * z.position.y);
}

TEST(Junction, EnergyDecays) { // (3.5.2)
  Foam foam = honeycomb(6, 3);
  disturb(foam, 0.15, 7);
  JunctionOptions options;
  options.damping = 1;
  int rejected = 0;
  for (const Junction j : foam.junction_slots()) {
    for (const JunctionStep& step :
         {movement({0.3, 0}), movement({0, -2}), junction_step(foam, j, options)}) {
      const double energy = local_energy_of(foam, j);
      rejected += move_junction(foam, j, step, options).position == step.position ? 0 : 1;
      EXPECT_LE(local_energy_of(foam, j), energy);
    }
  }
  EXPECT_GT(rejected, 0);
}

TEST(Junction, StaysWhereNoStepIsAllowed) {
  Foam foam = honeycomb(6, 3); // each junction is at its energy's minimum
  const Vec2 old = foam.position[Junction(5)];
  const JunctionChange change = move_junction(foam, Junction(5), {{1, 1, 1}, {0.5, 0}}, {});
  EXPECT_EQ(change.position, Vec2{});
  EXPECT_EQ(change.pressure, (std::array{0.0, 0.0, 0.0}));
  EXPECT_EQ(foam.position[Junction(5)], old);
}

TEST(Junction, StepIsHalvedUntilItIsAllowed) { // Figure 4.2
  Foam foam = triple();
  foam.position[Junction(0)] = {0.3, 0};
  JunctionOptions options;
  options.damping = 1;
  // From 0.3 past the minimum at 0: the full step and its half lead up the other side.
  const JunctionChange change = move_junction(foam, Junction(0), {{4, 8, 12}, {-2, 0}}, options);
  EXPECT_EQ(change.position, (Vec2{-0.5, 0}));
  EXPECT_EQ(change.pressure, (std::array{1.0, 2.0, 3.0}));
  EXPECT_NEAR(foam.position[Junction(0)].x, -0.2, 1e-15);
}

TEST(Junction, OrientationIsKept) { // (3.5.1)
  for (const bool invariant : {false, true}) {
    Foam foam = honeycomb(6, 3);
    ASSERT_TRUE(all_oriented(foam));
    JunctionOptions options;
    options.damping = 1;
    options.energy_decay = false;
    options.orientation_invariant = invariant;
    for (const Junction j : foam.junction_slots()) {
      const double angle = 0.7 * j.index();
      move_junction(foam, j, movement({1.5 * std::cos(angle), 1.5 * std::sin(angle)}), options);
    }
    EXPECT_EQ(all_oriented(foam), invariant);
  }
}

TEST(Junction, PinnedOnesStay) {
  BuildOptions build;
  build.boundary = Boundary::Fixed;
  Foam foam = build_from_points(jittered_grid(25, 1, 0.5, 1), build);
  const Foam old = foam;
  JunctionEquilibrator equilibrator(options_with(Sweep::GaussSeidel, true, true));
  equilibrator.equilibrate(foam, 0, {});
  int pinned = 0;
  for (const Junction j : foam.junction_slots()) {
    if (foam.has_junction(j) && !foam.freedom(j).any()) {
      ++pinned;
      EXPECT_EQ(foam.position[j], old.position[j]);
    }
  }
  EXPECT_GT(pinned, 0);
  for (const Film f : foam.film_slots()) {
    if (foam.has_film(f) && foam.wall(f.half())) {
      EXPECT_EQ(foam.film_angle[f], 0);
    }
  }
  EXPECT_LT(max_area_error(foam), max_area_error(old) + 0.2);
}

// Whole foams.

TEST(JunctionEquilibrator, LeavesAPerfectHoneycombAlone) {
  for (const Sweep sweep : {Sweep::Jacobi, Sweep::GaussSeidel}) {
    for (const bool constrained : {false, true}) {
      Foam foam = honeycomb(6, 3);
      const Foam old = foam;
      const EquilibriumReport report =
          JunctionEquilibrator(options_with(sweep, constrained, constrained))
              .equilibrate(foam, 0, {});
      EXPECT_TRUE(report.converged);
      EXPECT_LE(report.iterations, 2);
      EXPECT_LT(report.residual, 1e-12);
      for (const Junction j : foam.junction_slots()) {
        EXPECT_LT(norm(foam.position[j] - old.position[j]), 1e-12);
      }
    }
  }
}

TEST(JunctionEquilibrator, EquilibratesADisturbedHoneycomb) {
  for (const Sweep sweep : {Sweep::Jacobi, Sweep::GaussSeidel}) {
    EquilibratorOptions options = options_with(sweep, false, false);
    options.maximum_iterations = 5000;
    options.junction.damping = 0.5;
    options.junction.position_tolerance = options.junction.pressure_tolerance = 1e-13;
    Foam foam = honeycomb(6, 3);
    disturb(foam, 0.1, 8);
    const EquilibriumReport report = JunctionEquilibrator(options).equilibrate(foam, 0, {});
    EXPECT_TRUE(report.converged);
    EXPECT_LT(report.residual, 1e-9) << report.iterations;
    EXPECT_NEAR(foam.energy(), honeycomb(6, 3).energy(), 1e-9);
  }
}

TEST(JunctionEquilibrator, AgreesWithNewtonWhereArcsAreShallow) {
  BuildOptions build;
  build.boundary = Boundary::Periodic;
  Foam foam = build_from_points(jittered_grid(25, 1, 0.6, 2), build);
  Foam expected = foam;
  EquilibratorOptions options = options_with(Sweep::GaussSeidel, false, false);
  options.maximum_iterations = 5000;
  options.junction.damping = 0.5;
  options.junction.position_tolerance = options.junction.pressure_tolerance = 1e-13;
  EXPECT_LT(JunctionEquilibrator(options).equilibrate(foam, 0, {}).residual, 1e-9);
  EXPECT_TRUE(make_equilibrator({})->equilibrate(expected, 0, {}).converged);
  ASSERT_EQ(foam.half_junction, expected.half_junction);
  for (const Film f : foam.film_slots()) {
    EXPECT_NEAR(foam.length(f.half()) / expected.length(f.half()), 1, 1e-6);
  }
}

TEST(JunctionEquilibrator, ReducesTheResidualWithTheThesissConstants) {
  for (const Sweep sweep : {Sweep::Jacobi, Sweep::GaussSeidel}) {
    for (const bool energy : {false, true}) {
      Foam foam = honeycomb(6, 3);
      disturb(foam, 0.1, 9);
      set_half_angles(foam);
      const double angle = max_angle_error(foam);
      const EquilibriumReport report =
          JunctionEquilibrator(options_with(sweep, energy, false)).equilibrate(foam, 0, {});
      EXPECT_TRUE(report.converged);
      EXPECT_LT(report.max_angle_error, 0.7 * angle);
      EXPECT_EQ(foam.report.residual, report.residual);
      EXPECT_EQ(report.max_angle_error, max_angle_error(foam));
    }
  }
}

TEST(JunctionEquilibrator, ResultDoesNotDependOnTheNumberOfThreads) {
  const auto run = [](int threads) {
    BuildOptions build;
    build.boundary = Boundary::Periodic;
    Foam foam = build_from_points(jittered_grid(400, 1, 1, 1), build);
    EquilibratorOptions options = options_with(Sweep::Jacobi, true, true);
    options.maximum_iterations = 10;
    JunctionEquilibrator(options, threads).equilibrate(foam, 0, {});
    return foam;
  };
  const Foam one = run(1);
  for (const int threads : {2, 3, 8}) {
    const Foam many = run(threads);
    EXPECT_EQ(one.position, many.position);
    EXPECT_EQ(one.pressure, many.pressure);
    EXPECT_EQ(one.film_angle, many.film_angle);
  }
}

TEST(JunctionEquilibrator, DivergenceIsFlagged) {
  BuildOptions build;
  Foam foam = build_from_points(jittered_grid(100, 1, 1, 1), build);
  foam.pressure[Bubble(50)] = 1e6;
  EquilibratorOptions options = options_with(Sweep::GaussSeidel, false, false);
  options.junction.damping = 1;
  options.maximum_iterations = 40;
  const EquilibriumReport report = JunctionEquilibrator(options).equilibrate(foam, 0, {});
  EXPECT_FALSE(report.converged);
  EXPECT_FALSE(foam.report.converged);
  EXPECT_GT(report.iterations, 0);
  expect_valid(foam);
}

TEST(JunctionEquilibrator, SingularIsFlagged) {
  Foam foam = honeycomb(6, 3);
  foam.pressure[Bubble(0)] = 1e4; // all its films are half circles: its area answers to no pressure
  EXPECT_FALSE(JunctionEquilibrator(options_with(Sweep::Jacobi, true, true))
                   .equilibrate(foam, 0, {})
                   .converged);
}

TEST(JunctionEquilibrator, AbortLeavesTheFoamAsItWas) {
  Foam foam = honeycomb(6, 3);
  disturb(foam, 0.1, 10);
  const Foam old = foam;
  int asked = 0;
  EXPECT_THROW(JunctionEquilibrator(options_with(Sweep::Jacobi, false, false))
                   .equilibrate(foam, 0, [&] { return ++asked == 4; }),
               Aborted);
  EXPECT_EQ(foam.position, old.position);
  EXPECT_EQ(foam.pressure, old.pressure);
  EXPECT_EQ(foam.film_angle, old.film_angle);
}

TEST(JunctionEquilibrator, RefusesFilmsOfTheirOwnTension) {
  for (const Sweep sweep : {Sweep::Jacobi, Sweep::GaussSeidel}) {
    Foam foam = honeycomb(6, 3);
    foam.film_tension.assign(foam.film_angle.size(), 0.6);
    const Foam old = foam;
    try {
      JunctionEquilibrator(options_with(sweep, false, false)).equilibrate(foam, 0, {});
      ADD_FAILURE();
    } catch (const FoamError& error) {
      EXPECT_STREQ(error.what(),
                   "Equilibrator = Junction knows one tension for all films, but here films have "
                   "their own, which takes Equilibrator = Newton");
    }
    EXPECT_EQ(foam.position, old.position);
    EXPECT_EQ(foam.pressure, old.pressure);
  }
}

TEST(JunctionEquilibrator, RejectsOptionsOutOfRange) {
  const auto rejects = [](auto change) {
    EquilibratorOptions options;
    change(options);
    options.kind = EquilibratorKind::Junction;
    EXPECT_THROW(make_equilibrator(options), FoamError);
  };
  rejects([](auto& o) { o.junction.damping = 0; });
  rejects([](auto& o) { o.junction.damping = 1.5; });
  rejects([](auto& o) { o.junction.finite_difference_step = -1; });
  rejects([](auto& o) { o.junction.jacobian_tolerance = 0; });
  rejects([](auto& o) { o.junction.pressure_tolerance = 0; });
  rejects([](auto& o) { o.junction.position_tolerance = std::nan(""); });
  rejects([](auto& o) { o.junction.minimum_scale = 1; });
  rejects([](auto& o) { o.maximum_iterations = 0; });
  try {
    EquilibratorOptions options;
    options.junction.damping = 2;
    options.kind = EquilibratorKind::Junction;
    make_equilibrator(options);
    ADD_FAILURE();
  } catch (const FoamError& error) {
    EXPECT_EQ(std::string(error.what()), "Damping must be in (0, 1], but is 2");
  }
}

} // namespace
} // namespace foam
