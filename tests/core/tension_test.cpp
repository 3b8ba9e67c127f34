// SPDX-License-Identifier: GPL-3.0-or-later
// Foams whose films have tensions of their own, against closed forms and what holds for any.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>
#include <utility>

#include "../newton_on_host.h"
#include "base/random.h"
#include "engines/engines.h"
#include "equilibrium/newton_equilibrator.h"
#include "foams.h"
#include "mesh/element_measures.h"
#include "physics/gas.h"

namespace foam::test {
namespace {

constexpr double kPi = std::numbers::pi;
constexpr double kDegree = kPi / 180;

/// How Newton's equations are solved: by a factorisation, or by MINRES.
enum class Solver { Factorising, Krylov };

void equilibrate_by(Solver solver, Foam& foam, double tolerance) {
  EquilibratorOptions options;
  options.tolerance = tolerance;
  const double t1_length = 0.05 * foam.mean_spacing();
  if (solver == Solver::Factorising) {
    NewtonEquilibrator(options).equilibrate(foam, t1_length, {});
  } else {
    KrylovEquilibrator(options).equilibrate(foam, t1_length, {});
  }
}

class AnySolver : public testing::TestWithParam<Solver> {};
INSTANTIATE_TEST_SUITE_P(Solvers, AnySolver, testing::Values(Solver::Factorising, Solver::Krylov));

/// A double bubble with a film of tension `inner` between its bubbles, not in equilibrium.
Foam double_bubble_of(double inner, double left = 1, double right = 1, double area_left = 1) {
  Foam foam = double_bubble(area_left, 1);
  foam.film_tension = {inner, left, right};
  return foam;
}

/// A disordered foam of films that pull unevenly, not in equilibrium.
Foam uneven_foam(Boundary boundary, Index bubbles, std::uint64_t seed, double part = 0.2) {
  Foam foam = jittered_foam(boundary, bubbles, seed);
  pull_unevenly(foam, part, seed + 10);
  return foam;
}

/// By which angle a half-film leaves its start, from where it bulges to: its chord, turned by α
/// against that.
double direction(const Foam& foam, Half h) {
  const Vec2 chord = foam.chord(h);
  return std::atan2(chord.y, chord.x) - foam.half_angle(h);
}

/// The largest deviation at a junction from cos θ₁₂ = (T₃² − T₁² − T₂²)/(2T₁T₂), rad.
double deviation(const Foam& foam, Junction junction) {
  double largest = 0;
  const std::array<Half, 3>& halves = foam.junction_half[junction];
  for (std::size_t k = 0; k < 3; ++k) {
    const Half one = halves[k];
    const Half two = halves[(k + 1) % 3];
    const double t1 = foam.tension(one.film());
    const double t2 = foam.tension(two.film());
    const double t3 = foam.tension(halves[(k + 2) % 3].film());
    const double asked = std::acos((t3 * t3 - t1 * t1 - t2 * t2) / (2 * t1 * t2));
    const double turn = direction(foam, two) - direction(foam, one);
    const double angle = turn - 2 * kPi * std::floor(turn / (2 * kPi));
    largest = std::max(largest, std::abs(angle - asked));
  }
  return largest;
}

// Double bubbles. With outer films of tension 1 and radius r the inner film's tension τ is balanced
// by −2cos α of theirs, with half-angles α = arccos(−τ/2); of unit areas they have r²(α − sin α cos
// α) = 1 and the energy 4rα + 2τr sin α = 4√(α − sin α cos α).

TEST_P(AnySolver, DoubleBubblesHaveTheirAnglesAndEnergies) {
  for (const auto& [inner, energy] : {std::pair{0.5, 5.748791930241},
                                      {std::numbers::sqrt2, 6.760111821788},
                                      {1.9, 7.066166858174}}) {
    SCOPED_TRACE(inner);
    Foam foam = double_bubble_of(inner);
    equilibrate_by(GetParam(), foam, 1e-13);
    expect_valid(foam);
    EXPECT_TRUE(foam.report.converged) << foam.report.residual;
    const double alpha = std::acos(-inner / 2);
    const double radius = 1 / std::sqrt(alpha - std::sin(alpha) * std::cos(alpha));
    EXPECT_NEAR(foam.film_angle[Film(0)], 0, 1e-12);
    EXPECT_NEAR(foam.film_angle[Film(1)], alpha, 1e-12);
    EXPECT_NEAR(foam.film_angle[Film(2)], alpha, 1e-12);
    EXPECT_NEAR(norm(foam.chord(Half(0))), 2 * radius * std::sin(alpha), 1e-12);
    EXPECT_NEAR(foam.pressure[Bubble(0)], 1 / radius, 1e-12);
    EXPECT_NEAR(foam.pressure[Bubble(1)], 1 / radius, 1e-12);
    EXPECT_NEAR(foam.energy(), energy, 1e-12);
  }
}

/// A film without tension halves a disc of two areas: dE/dτ is its length then, the diameter.
TEST_P(AnySolver, AnInnerFilmThatHardlyPullsHalvesADisc) {
  // MINRES's matrix has one film that yields 1/τ times as much as the others.
  for (const double inner : {1e-2, GetParam() == Solver::Factorising ? 1e-6 : 1e-3}) {
    Foam foam = double_bubble_of(inner);
    equilibrate_by(GetParam(), foam, 1e-9);
    EXPECT_TRUE(foam.report.converged) << inner << ": " << foam.report.residual;
    EXPECT_NEAR(foam.film_angle[Film(1)], kPi / 2 + std::asin(inner / 2), 1e-7);
    const double limit = 2 * std::sqrt(2 * kPi) + inner * std::sqrt(8 / kPi);
    EXPECT_NEAR(foam.energy(), limit, 0.3 * inner * inner + 1e-10);
  }
}

/// One that pulls as hard as the two others vanishes: two discs are left that touch. With τ = 2 − ε
/// and α = π − √ε the energy is 4√π(1 − ε^(3/2)/(3π)) in the lowest orders.
TEST_P(AnySolver, AnInnerFilmThatPullsTooHardLeavesTwoDiscs) {
  for (const double missing : {1e-2, 1e-3}) {
    Foam foam = double_bubble_of(2 - missing);
    equilibrate_by(GetParam(), foam, 1e-12);
    EXPECT_TRUE(foam.report.converged) << missing << ": " << foam.report.residual;
    const double less = std::pow(missing, 1.5) / (3 * kPi);
    EXPECT_NEAR(foam.energy(), 4 * std::sqrt(kPi) * (1 - less), 4 * missing * less);
    EXPECT_NEAR(kPi - foam.film_angle[Film(1)], std::sqrt(missing), missing);
  }
}

TEST(NeumannAngle, IsThatOfTheTriangleOfTensions) {
  // Between the first two films; the third lies opposite.
  EXPECT_EQ(neumann_angle(0.7, 0.7, 0.7), 2 * kPi / 3);
  EXPECT_NEAR(neumann_angle(1, 1, 0.5), 151.0450 * kDegree, 1e-6);
  EXPECT_NEAR(neumann_angle(1, 0.5, 1), 104.4775 * kDegree, 1e-6);
  EXPECT_NEAR(neumann_angle(0.5, 1, 1), 104.4775 * kDegree, 1e-6);
  EXPECT_NEAR(neumann_angle(1, 1, std::numbers::sqrt2), 90 * kDegree, 1e-12);
  EXPECT_NEAR(neumann_angle(1, std::numbers::sqrt2, 1), 135 * kDegree, 1e-12);
  EXPECT_NEAR(neumann_angle(1, 1.2, 0.8), 138.5904 * kDegree, 1e-6);
  EXPECT_NEAR(neumann_angle(1.2, 0.8, 1), 124.2289 * kDegree, 1e-6);
  EXPECT_NEAR(neumann_angle(0.8, 1, 1.2), 97.1808 * kDegree, 1e-6);
  EXPECT_NEAR(neumann_angle(1, 1, 1e-9), kPi, 1e-8) << "as if the third film were not there";
  EXPECT_NEAR(neumann_angle(1, 1, 2), 0, 1e-7);
}

/// Each film that its tension and the pressures beside it bend: q·r = T.
TEST_P(AnySolver, DoubleBubbleOfThreeTensions) {
  Foam foam = double_bubble_of(0.8, 1, 1.2, 0.7);
  equilibrate_by(GetParam(), foam, 1e-12);
  expect_valid(foam);
  EXPECT_TRUE(foam.report.converged) << foam.report.residual;
  const auto angle_between = [&](Film a, Film b) { // where they begin or end at junction 0
    const auto leaving = [&](Film f) {
      return foam.start(f.half()) == Junction(0) ? f.half() : f.half().twin();
    };
    return std::abs(angle_from_to(foam.tangent(leaving(a)), foam.tangent(leaving(b))));
  };
  EXPECT_NEAR(angle_between(Film(1), Film(2)), 138.5904 * kDegree, 1e-6);
  EXPECT_NEAR(angle_between(Film(2), Film(0)), 124.2289 * kDegree, 1e-6);
  EXPECT_NEAR(angle_between(Film(0), Film(1)), 97.1808 * kDegree, 1e-6);
  for (const Film f : foam.film_slots()) {
    const double curvature = 2 * std::sin(foam.film_angle[f]) / norm(foam.chord(f.half()));
    EXPECT_NEAR(foam.pressure_difference(f.half()), foam.tension(f) * curvature, 1e-11);
  }
  const auto [first, second] = std::pair(foam.pressure[Bubble(0)], foam.pressure[Bubble(1)]);
  EXPECT_NEAR(0.7 * first + second, foam.energy() / 2, 1e-11);
}

// Disordered foams.

class AnyFoam : public testing::TestWithParam<std::pair<Solver, Boundary>> {};
INSTANTIATE_TEST_SUITE_P(SolversAndBoundaries, AnyFoam,
                         testing::Values(std::pair(Solver::Factorising, Boundary::Free),
                                         std::pair(Solver::Factorising, Boundary::Periodic),
                                         std::pair(Solver::Factorising, Boundary::Fixed),
                                         std::pair(Solver::Krylov, Boundary::Free),
                                         std::pair(Solver::Krylov, Boundary::Periodic),
                                         std::pair(Solver::Krylov, Boundary::Fixed)));

TEST_P(AnyFoam, FilmsMeetAtNeumannsAngles) {
  const auto [solver, boundary] = GetParam();
  for (const Index bubbles : {40, 70, 100}) {
    for (const std::uint64_t seed : {1U, 2U}) {
      SCOPED_TRACE(std::to_string(bubbles) + " bubbles, seed " + std::to_string(seed));
      Foam foam = uneven_foam(boundary, bubbles, seed);
      equilibrate_by(solver, foam, 1e-11);
      expect_valid(foam);
      EXPECT_TRUE(foam.report.converged) << foam.report.residual;
      double worst = 0;
      for (const Junction j : foam.junction_slots()) {
        if (foam.moves(j)) {
          worst = std::max(worst, deviation(foam, j));
          EXPECT_LT(norm(force_imbalance(foam, j)), 1e-10 * foam.reference_tension());
        }
      }
      EXPECT_LT(worst, 1e-8);
      EXPECT_NEAR(max_angle_error(foam), worst, 1e-13);
      EXPECT_NEAR(foam.report.max_angle_error, worst, 1e-13);
      EXPECT_LT(max_area_error(foam), 1e-10);
    }
  }
}

/// The energy is Σ T·l, a wall's film has none.
TEST_P(AnyFoam, EnergyIsThatOfTheFilms) {
  const auto [solver, boundary] = GetParam();
  Foam foam = uneven_foam(boundary, 50, 3);
  equilibrate_by(solver, foam, 1e-10);
  double energy = 0;
  for (const Film f : foam.film_slots()) {
    const double alpha = foam.film_angle[f];
    const double chord = norm(foam.chord(f.half()));
    energy +=
        foam.bends(f) ? foam.tension(f) * chord * (alpha == 0 ? 1 : alpha / std::sin(alpha)) : 0;
  }
  EXPECT_NEAR(foam.energy(), energy, 1e-12 * energy);
}

/// A foam twice as large would have twice the energy and four times the areas: E = 2Σ(p − p₀)A.
TEST_P(AnySolver, PressuresOfAFreeFoamAreThoseOfTheVirialTheorem) {
  for (const double outside : {0.0, 0.3}) {
    for (const Index bubbles : {5, 60}) {
      Foam foam = uneven_foam(Boundary::Free, bubbles, 1);
      foam.exterior[kWorld.outside()].pressure = outside;
      equilibrate_by(GetParam(), foam, 1e-11);
      EXPECT_TRUE(foam.report.converged) << foam.report.residual;
      const double virial =
          sum(foam, [&](Bubble b) { return (foam.pressure[b] - outside) * foam.area(b); });
      EXPECT_NEAR(virial, foam.energy() / 2, 1e-10 * foam.energy());
    }
  }
}

/// Forces have no unit but 2γ.
TEST_P(AnySolver, TensionsScalePressuresAndNothingElse) {
  const auto with_all_times = [&](double scale) {
    Foam foam = uneven_foam(Boundary::Periodic, 60, 2);
    foam.surface_tension *= scale;
    for (double& tension : foam.film_tension) {
      tension *= scale;
    }
    equilibrate_by(GetParam(), foam, 1e-11);
    EXPECT_TRUE(foam.report.converged);
    return foam;
  };
  const Foam one = with_all_times(1);
  const Foam eight = with_all_times(8);
  EXPECT_EQ(eight.position, one.position) << "to the bit";
  EXPECT_EQ(eight.film_angle, one.film_angle);
  EXPECT_EQ(eight.energy(), 8 * one.energy());
  for (const Bubble b : one.bubble_slots()) {
    EXPECT_EQ(eight.pressure[b], 8 * one.pressure[b]);
  }
  const Foam three = with_all_times(3);
  EXPECT_NEAR(three.energy(), 3 * one.energy(), 1e-11 * three.energy());
  for (const Junction j : one.junction_slots()) {
    EXPECT_NEAR(norm(three.position[j] - one.position[j]), 0, 1e-8);
  }
  for (const Bubble b : one.bubble_slots()) {
    EXPECT_NEAR(three.pressure[b], 3 * one.pressure[b], 1e-8);
  }
}

TEST_P(AnySolver, AWallsTensionIsOfNoAccount) {
  const Foam start = uneven_foam(Boundary::Fixed, 40, 1);
  Foam expected = start;
  equilibrate_by(GetParam(), expected, 1e-11);
  Foam foam = start;
  for (const Film f : foam.film_slots()) {
    foam.film_tension[f] = foam.wall(f.half()) ? 17 : foam.film_tension[f];
  }
  equilibrate_by(GetParam(), foam, 1e-11);
  EXPECT_EQ(foam.position, expected.position);
  EXPECT_EQ(foam.pressure, expected.pressure);
  EXPECT_EQ(foam.energy(), expected.energy());
}

/// Four films cross at right angles, and one is to lie between two pairs of them. It is stronger
/// than a pair is together on either side, √2·0.69, though a junction could hold it: whichever
/// pairs it parts it shrinks to nothing, and there is no equilibrium of three films to a junction.
TEST_P(AnySolver, NoEquilibriumIsClaimedWhereFourFilmsWouldMeet) {
  Foam foam = unit_cluster({{0, 0}, {1, 0}, {0.5, 0.9}, {0.5, -0.9}});
  foam.film_tension.assign(foam.film_angle.size(), 0.69);
  Film middle = kNone;
  for (const Film f : foam.film_slots()) {
    const Half h = f.half();
    const auto inner = [&](Half end) {
      return !foam.left(foam.next_around_junction(end)).is_outside();
    };
    middle = !foam.on_outside(h) && inner(h) && inner(h.twin()) ? f : middle;
  }
  ASSERT_NE(middle, Film(kNone));
  foam.film_tension[middle] = 1;
  for (const Junction j : foam.junction_slots()) {
    ASSERT_TRUE(can_balance(tensions_at(foam, j)));
  }
  equilibrate_by(GetParam(), foam, 1e-9);
  expect_valid(foam);
  EXPECT_FALSE(foam.report.converged);
  EXPECT_LT(foam.length(middle.half()), 0.05);
}

// All films are given the tension that they have without.

Foam with_tensions_given(Foam foam) {
  foam.film_tension.assign(foam.film_angle.size(), foam.reference_tension());
  return foam;
}

TEST_P(AnyFoam, IsTheSameIfAllAreGivenWhatTheyHave) {
  const auto [solver, boundary] = GetParam();
  const Foam start = jittered_foam(boundary, 60, 1);
  Foam expected = start;
  equilibrate_by(solver, expected, 1e-11);
  Foam foam = with_tensions_given(start);
  equilibrate_by(solver, foam, 1e-11);
  EXPECT_TRUE(foam.report == expected.report);
  EXPECT_EQ(foam.t1_count, expected.t1_count);
  EXPECT_EQ(foam.position, expected.position);
  EXPECT_EQ(foam.film_angle, expected.film_angle);
  EXPECT_EQ(foam.pressure, expected.pressure);
}

CoarseningOptions stepping_by(Stepping stepping) {
  CoarseningOptions options = thesis_options();
  options.stepping = stepping;
  return options;
}

class AnyStepping : public testing::TestWithParam<Stepping> {};
INSTANTIATE_TEST_SUITE_P(Steppings, AnyStepping,
                         testing::Values(Stepping::Events, Stepping::FixedSteps));

TEST_P(AnyStepping, CoarsensTheSameIfAllAreGivenWhatTheyHave) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic}) {
    const Foam start = random_foam(60, boundary, 1);
    const auto expected = make_coarsening(stepping_by(GetParam()));
    const auto given = make_coarsening(stepping_by(GetParam()));
    expected->restart(start);
    given->restart(with_tensions_given(start));
    for (int frame = 0; frame < 30; ++frame) {
      ASSERT_TRUE(expected->advance({}));
      ASSERT_TRUE(given->advance({}));
    }
    const Foam& foam = given->foam();
    EXPECT_EQ(foam.t1_count, expected->foam().t1_count);
    EXPECT_EQ(foam.t2_count, expected->foam().t2_count);
    EXPECT_TRUE(foam.half_bubble == expected->foam().half_bubble);
    EXPECT_GT(foam.t1_count, 5);
    EXPECT_NEAR(foam.energy(), expected->foam().energy(), 1e-10);
    for (const Bubble b : foam.bubble_slots()) {
      if (foam.has_bubble(b)) {
        EXPECT_NEAR(foam.area(b), expected->foam().area(b), 1e-10);
      }
    }
  }
}

// Coarsening.

TEST_P(AnyStepping, EveryFrameIsAnEquilibriumThatKeepsTheGas) {
  Foam start = uneven_foam(Boundary::Periodic, 60, 1, 0.15);
  equilibrate(start);
  expect_equilibrium(start);
  const auto coarsening = make_coarsening(stepping_by(GetParam()));
  coarsening->restart(start);
  const double room = start.surroundings.lattice.area();
  const int frames = GetParam() == Stepping::Events ? 100 : 40;
  for (int frame = 0; frame < frames; ++frame) {
    const std::string where = "frame " + std::to_string(frame) + ": ";
    ASSERT_TRUE(coarsening->advance({})) << where;
    const Foam& foam = coarsening->foam();
    expect_equilibrium(foam, where);
    expect_valid(foam, where);
    EXPECT_NEAR(gas(foam) / room, 1, 1e-12) << where;
    for (const Junction j : foam.junction_slots()) {
      EXPECT_TRUE(!foam.has_junction(j) || can_balance(tensions_at(foam, j))) << where;
    }
  }
  EXPECT_GT(coarsening->foam().t1_count, 10);
  EXPECT_GT(coarsening->foam().t2_count, 5);
}

/// The rate by angles is that by lengths and pressures where there is equilibrium, and where all
/// films have one tension von Neumann's everywhere.
TEST(AreaRate, IsTheGasTransferInEquilibrium) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic, Boundary::Fixed}) {
    Foam foam = uneven_foam(boundary, 60, 2);
    const Foam rough = with_tensions_given(foam);
    equilibrate(foam, 1e-11);
    const AreaRate rate = area_rate(view_of(std::as_const(foam)), 0.7);
    const AreaRate rough_rate = area_rate(view_of(rough), 0.7);
    const double constant = von_neumann_constant(rough.surface_tension, 0.7);
    for (const Bubble b : foam.bubble_slots()) {
      EXPECT_NEAR(rate(b), gas_transfer(foam, b, 0.7), 1e-9);
      if (boundary != Boundary::Fixed || !rough.bubble_on_outside(b)) {
        EXPECT_NEAR(rough_rate(b), constant * (rough.sides[b] - 6), 1e-14);
      }
    }
  }
}

/// A film keeps its tension through T1s, and no film has one that was not there.
TEST_P(AnyStepping, FilmsKeepTheirTensions) {
  Foam start = uneven_foam(Boundary::Periodic, 60, 3, 0.15);
  equilibrate(start);
  const auto coarsening = make_coarsening(stepping_by(GetParam()));
  coarsening->restart(start);
  for (int frame = 0; frame < 40; ++frame) {
    ASSERT_TRUE(coarsening->advance({}));
  }
  EXPECT_GT(coarsening->foam().t1_count, 5);
  EXPECT_EQ(coarsening->foam().film_tension, start.film_tension);
}

/// dA/dt = −κΣl·Δp. It is not von Neumann's law, by which six-sided bubbles keep their areas.
TEST_P(AnyStepping, BubblesGrowByTheGasThatTheirFilmsLetThrough) {
  constexpr double kPermeability = 0.7;
  CoarseningOptions options = stepping_by(GetParam());
  options.permeability = kPermeability;
  options.time_step = 1e-5;
  options.equilibrator.tolerance = 1e-11;
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic}) {
    Foam before = uneven_foam(boundary, 60, 5, 0.15);
    equilibrate(before, 1e-11);
    const auto coarsening = make_coarsening(options);
    coarsening->restart(before);
    ASSERT_TRUE(coarsening->advance({}));
    const Foam foam = coarsening->foam();
    ASSERT_TRUE(coarsening->advance({}));
    const Foam& after = coarsening->foam();
    ASSERT_TRUE(after.half_bubble == before.half_bubble) << "no event";
    double fastest_of_six = 0;
    for (const Bubble b : foam.bubble_slots()) {
      double expected = 0;
      for_each_half(foam, b, [&](Half h) {
        const double chord = norm(foam.chord(h));
        const double alpha = foam.half_angle(h);
        const double length = std::abs(alpha) < 1e-6 ? chord : chord * alpha / std::sin(alpha);
        expected -= kPermeability * length * foam.pressure_difference(h);
      });
      const double rate = (after.area(b) - before.area(b)) / (2 * options.time_step);
      EXPECT_NEAR(rate, expected, 1e-5 * std::max(std::abs(expected), 0.1));
      if (foam.sides[b] == 6) {
        fastest_of_six = std::max(fastest_of_six, std::abs(rate));
      }
    }
    EXPECT_GT(fastest_of_six, 0.01);
  }
}

} // namespace
} // namespace foam::test
