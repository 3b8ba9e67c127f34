// SPDX-License-Identifier: GPL-3.0-or-later
//
// Tori that are strained from T1 to T1.
#include "deformation/torus_deformation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/error.h"
#include "construct/honeycomb.h"
#include "foams.h"
#include "reference.h"
#include "statistics/stress.h"

namespace foam::test {
namespace {

constexpr auto kSimple = DeformationKind::SimpleShear;
constexpr auto kPure = DeformationKind::PureShear;
constexpr double kHexagonalModulus = 0.465302429551; // T/√A
const double kYieldStrain = 2 / std::sqrt(3.0);      // of hexagons along a row

DeformationOptions options(DeformationKind kind, double step, double tolerance = 1e-9) {
  DeformationOptions result;
  result.kind = kind;
  result.strain_step = step;
  result.equilibrator.tolerance = tolerance;
  return result;
}

/// The foam after so many frames, each of which is an equilibrium.
Foam after(const Foam& start, const DeformationOptions& options, int frames) {
  TorusDeformation deformation(options);
  deformation.restart(start);
  for (int frame = 0; frame < frames; ++frame) {
    EXPECT_TRUE(deformation.advance({}));
    EXPECT_LE(deformation.foam().report.residual, options.equilibrator.tolerance);
  }
  return deformation.foam();
}

Foam evolver_in_equilibrium(double tolerance) {
  Foam foam = foam_of(evolver_foam());
  equilibrate(foam, tolerance);
  return foam;
}

std::vector<double> lengths(const Foam& foam) {
  std::vector<double> result;
  for (const Film f : foam.film_slots()) {
    result.push_back(foam.has_film(f) ? foam.length(f.half()) : 0);
  }
  return result;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = a.size() == b.size() ? 0 : std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i < std::min(a.size(), b.size()); ++i) {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

/// Rows of hexagons slide over each other: a saw-tooth (A. M. Kraynik, Annu. Rev. Fluid Mech. 20
/// (1988) 325), through ten lattice constants. Stresses are taken in the middle of frames.
TEST(TorusDeformation, OfHexagonsIsASawTooth) {
  constexpr int kFramesPerTooth = 32;
  constexpr int kTeeth = 10;
  const double step = kYieldStrain / kFramesPerTooth;
  const Foam rest = honeycomb({.columns = 6, .rows = 4, .surface_tension = 0.5});
  TorusDeformation deformation(options(kSimple, step));
  deformation.restart(after(rest, options(kSimple, 0.5 * step), 1));
  double total = 0;
  int found = 0;
  for (int frame = 0; frame < kTeeth * kFramesPerTooth; ++frame) {
    const Foam& foam = deformation.foam();
    const double strain = (frame % kFramesPerTooth + 0.5) * step;
    const SymmetricTensor sigma = stress(foam);
    const double exact = kHexagonalModulus * strain / std::sqrt(1 + strain * strain / 4);
    EXPECT_NEAR(sigma.xy, exact, 2e-9);
    EXPECT_NEAR(normal_stress_difference(sigma), strain * exact, 2e-9);
    total += sigma.xy;
    ASSERT_TRUE(deformation.advance({}));
    EXPECT_LE(foam.report.residual, 1e-9);
    for (const TopologicalEvent& t1 : deformation.events()) {
      const int tooth = found / foam.bubble_count() + 1;
      EXPECT_NEAR(t1.strain, tooth * kYieldStrain, 1e-9);
      ++found;
    }
  }
  const Foam& foam = deformation.foam();
  expect_valid(foam);
  EXPECT_NEAR(total / (kTeeth * kFramesPerTooth), (4 - 2 * std::sqrt(3.0)) * kHexagonalModulus,
              2e-5); // h²/24·τ′ of the sum's own
  EXPECT_EQ(found, kTeeth * foam.bubble_count());
  EXPECT_EQ(foam.t1_count, found); // √3/2 per bubble and unit of strain
  EXPECT_LT(norm(foam.surroundings.lattice.first), 10);
  EXPECT_LT(norm(foam.surroundings.lattice.second), 10);
  std::cout << "mean stress " << total / (kTeeth * kFramesPerTooth) << '\n';
}

/// The curve that another program found.
TEST(TorusDeformation, OfTheEvolversFoam) {
  const Foam rest = evolver_in_equilibrium(1e-12);
  for (const auto& row : read_csv("evolver-100/simple_shear.csv")) {
    const double gamma = number(row, "gamma");
    if (gamma == 0) {
      continue;
    }
    for (const int frames : {1, 5}) {
      const Foam foam = after(rest, options(kSimple, gamma / frames, 1e-12), frames);
      EXPECT_EQ(foam.t1_count, rest.t1_count);
      EXPECT_NEAR(foam.energy(), number(row, "total_length"), 1e-10);
      const SymmetricTensor sigma = stress(foam);
      EXPECT_NEAR(sigma.xy, number(row, "sigma_xy"), 1e-11);
      EXPECT_NEAR(normal_stress_difference(sigma), number(row, "N1"), 1e-11);
      double shortest = 10;
      for (const Film f : foam.film_slots()) {
        shortest = std::min(shortest, norm(foam.chord(f.half())));
      }
      EXPECT_NEAR(shortest, number(row, "min_film_length"), 1e-11); // which is a chord there
    }
  }
}

/// The first T1 is at its strain, be the frames long or short, and so is what follows.
TEST(TorusDeformation, FindsTheFirstT1) {
  const Foam rest = evolver_in_equilibrium(1e-9);
  std::vector<double> energies;
  for (const double step : {0.001, 0.1}) {
    TorusDeformation deformation(options(kSimple, step));
    deformation.restart(rest);
    std::vector<TopologicalEvent> found;
    for (int frame = 0; frame < std::lround(0.6 / step); ++frame) {
      ASSERT_TRUE(deformation.advance({}));
      EXPECT_LE(deformation.foam().report.residual, 1e-9);
      std::ranges::copy(deformation.events(), std::back_inserter(found));
    }
    ASSERT_GE(found.size(), 1U);
    EXPECT_NEAR(found[0].strain, 0.393983979975, 1e-9);
    EXPECT_EQ(std::minmax(found[0].bubbles[0], found[0].bubbles[1]),
              std::minmax(std::int64_t{11}, std::int64_t{41}));
    energies.push_back(deformation.foam().energy());
    std::cout << "first T1 at " << foam::number(found[0].strain) << '\n';
  }
  EXPECT_NEAR(energies[0], energies[1], 1e-6);
}

/// F after F⁻¹ gives back lengths and topology, and the way back until the first T1 is the way.
TEST(TorusDeformation, IsReversibleBeforeT1s) {
  for (const auto kind : {kSimple, kPure}) {
    for (const double way : {kind == kSimple ? 0.38 : 0.1, -0.05}) {
      const Foam rest = evolver_in_equilibrium(1e-13);
      constexpr int kFrames = 4;
      std::vector<std::vector<double>> passed;
      TorusDeformation there(options(kind, way / kFrames, 1e-13));
      there.restart(rest);
      for (int frame = 0; frame < kFrames; ++frame) {
        passed.push_back(lengths(there.foam()));
        ASSERT_TRUE(there.advance({}));
      }
      ASSERT_EQ(there.foam().t1_count, rest.t1_count);
      TorusDeformation back(options(kind, -way / kFrames, 1e-13));
      back.restart(there.foam());
      for (int frame = kFrames; frame-- > 0;) {
        ASSERT_TRUE(back.advance({}));
        EXPECT_LT(largest_difference(lengths(back.foam()), passed[place_of(frame)]), 1e-12);
      }
      EXPECT_EQ(back.foam().half_junction, rest.half_junction);
      EXPECT_EQ(back.foam().half_bubble, rest.half_bubble);
      EXPECT_NEAR(back.foam().strain, 0, 1e-15);
    }
  }
}

TEST(TorusDeformation, Oscillates) {
  DeformationOptions asked = options(kSimple, 0.03, 1e-13);
  asked.amplitude = 0.1;
  const Foam rest = evolver_in_equilibrium(1e-13);
  TorusDeformation deformation(asked);
  deformation.restart(rest);
  for (int frame = 1; frame <= 40; ++frame) { // three periods of 0.4
    ASSERT_TRUE(deformation.advance({}));
    const double from_peak = std::abs(std::remainder(0.03 * frame - 0.1, 0.4));
    EXPECT_NEAR(deformation.foam().strain, 0.1 - from_peak, 1e-12);
    EXPECT_NEAR(deformation.foam().time, 0.03 * frame, 1e-12);
  }
  EXPECT_EQ(deformation.foam().t1_count, rest.t1_count);
  EXPECT_NEAR(deformation.foam().strain, 0, 1e-12);
  EXPECT_LT(largest_difference(lengths(deformation.foam()), lengths(rest)), 1e-12);
}

/// Every frame of random foams is a valid mesh in equilibrium, on compact periods, with all gas.
TEST(TorusDeformation, OfRandomFoamsStaysAnEquilibrium) {
  std::int64_t t1s = 0;
  for (const std::uint64_t seed : {1U, 2U, 3U, 4U}) {
    for (const auto kind : {kSimple, kPure}) {
      Foam rest = random_foam(40, Boundary::Periodic, seed);
      exchange_gas(rest);
      equilibrate(rest);
      TorusDeformation deformation(options(kind, seed % 2 == 0 ? 0.07 : -0.07));
      deformation.restart(rest);
      const double area = rest.surroundings.lattice.area();
      for (int frame = 0; frame < (kind == kSimple ? 40 : 12); ++frame) {
        ASSERT_TRUE(deformation.advance({})) << seed << ' ' << frame;
        const Foam& foam = deformation.foam();
        expect_valid(foam);
        expect_equilibrium(foam);
        EXPECT_LE(foam.report.residual, 1e-9);
        EXPECT_EQ(foam.target_area, rest.target_area);
        EXPECT_NEAR(foam.surroundings.lattice.area(), area, 1e-12 * area);
        EXPECT_EQ(reduced(foam.surroundings.lattice).lattice, foam.surroundings.lattice);
      }
      t1s += deformation.foam().t1_count - rest.t1_count;
    }
  }
  EXPECT_GT(t1s, 100);
  std::cout << t1s << " T1s\n";
}

/// A foam from its list of films goes on with the same bits as one that began anew there.
TEST(TorusDeformation, IsAFunctionOfItsFilms) {
  DeformationOptions asked = options(kSimple, 0.05);
  asked.amplitude = 0.6;
  TorusDeformation first(asked);
  first.restart(random_foam(40, Boundary::Periodic, 2));
  for (int frame = 0; frame < 20; ++frame) {
    ASSERT_TRUE(first.advance({}));
  }
  const FilmSet films = film_set(first.foam());
  TorusDeformation second(asked);
  first.restart(foam_of(films));
  second.restart(foam_of(films));
  for (int frame = 0; frame < 10; ++frame) {
    ASSERT_TRUE(first.advance({}));
    ASSERT_TRUE(second.advance({}));
  }
  EXPECT_EQ(film_set(first.foam()), film_set(second.foam()));
}

TEST(TorusDeformation, LeavesTheFoamWhenAborted) {
  TorusDeformation deformation(options(kSimple, 0.5));
  deformation.restart(random_foam(40, Boundary::Periodic, 2));
  const FilmSet before = film_set(deformation.foam());
  int polls = 0;
  EXPECT_THROW(deformation.advance([&] { return ++polls > 10; }), Aborted);
  EXPECT_EQ(film_set(deformation.foam()), before);
}

TEST(TorusDeformation, RejectsWhatItCannotDo) {
  EXPECT_THROW(TorusDeformation(options(kSimple, 0)), FoamError);
  EXPECT_THROW(TorusDeformation(options(kSimple, std::nan(""))), FoamError);
  DeformationOptions asked = options(kSimple, 0.1);
  asked.amplitude = 0.05;
  EXPECT_THROW(TorusDeformation{asked}, FoamError);
  asked = options(kSimple, 0.1);
  asked.equilibrator.kind = EquilibratorKind::Junction;
  EXPECT_THROW(TorusDeformation{asked}, FoamError);
  TorusDeformation deformation(options(kSimple, 0.1));
  EXPECT_THROW(deformation.restart(random_foam(20, Boundary::Free)), FoamError);
}

} // namespace
} // namespace foam::test
