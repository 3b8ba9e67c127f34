// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is left of a foam by work that is aborted, or that memory does not suffice for, and what is
// found when a report is held against its foam.
#include <gtest/gtest.h>

#include <cmath>
#include <new>
#include <random>
#include <utility>
#include <vector>

#include "engines/engines.h"
#include "foams.h"

namespace foam {
namespace {

using test::expect_valid;
using test::jittered_foam;
using test::random_foam;

std::vector<CoarseningOptions> engines() {
  CoarseningOptions events;
  CoarseningOptions fixed;
  fixed.stepping = Stepping::FixedSteps;
  CoarseningOptions thesis;
  thesis.equilibrator.kind = EquilibratorKind::Junction;
  thesis.equilibrator.maximum_iterations = 30;
  for (CoarseningOptions* options : {&events, &fixed, &thesis}) {
    options->equilibrator.device = Device::CPU;
    options->time_step = 0.2; // several events
  }
  return {events, fixed, thesis};
}

TEST(Interrupted, AFrameThatFailsAnywhereLeavesTheFoamAsItWas) {
  for (const CoarseningOptions& options : engines()) {
    const Foam start = random_foam(40, Boundary::Periodic);
    const auto whole = make_coarsening(options);
    whole->restart(start);
    int polls = 0;
    ASSERT_TRUE(whole->advance([&] { return ++polls < 0; }));
    ASSERT_GT(polls, 2);
    const FilmSet after = film_set(whole->foam());
    for (int last = 1; last <= polls; last += std::max(1, polls / 25)) {
      const auto coarsening = make_coarsening(options);
      coarsening->restart(start);
      const FilmSet before = film_set(coarsening->foam());
      int asked = 0;
      EXPECT_THROW(coarsening->advance([&] {
        if (++asked == last) {
          throw std::bad_alloc();
        }
        return false;
      }),
                   std::bad_alloc);
      EXPECT_EQ(film_set(coarsening->foam()), before) << last;
      coarsening->restart(coarsening->foam());
      ASSERT_TRUE(coarsening->advance({}));
      EXPECT_EQ(film_set(coarsening->foam()), after) << last;
    }
  }
}

/// Whether a report says what is measured.
void expect_measured(const Foam& foam, int call) {
  const EquilibriumReport measured = measured_report(foam);
  EXPECT_FALSE(foam.report.converged) << call;
  EXPECT_EQ(foam.report.max_angle_error, measured.max_angle_error) << call;
  EXPECT_EQ(foam.report.max_area_error, measured.max_area_error) << call;
  EXPECT_EQ(foam.report.residual, measured.residual) << call;
}

TEST(Interrupted, AnEquilibrationLeavesTheFoamAsItWasOrOnItsWayAndMeasured) {
  for (const CoarseningOptions& engine : engines()) {
    for (const auto boundary : {Boundary::Free, Boundary::Periodic}) {
      Foam start = jittered_foam(boundary, 40, 3);
      start.report = measured_report(start);
      Foam end = start;
      int polls = 0;
      make_equilibrator(engine.equilibrator)->equilibrate(end, 0.05, [&] { return ++polls < 0; });
      ASSERT_GT(polls, 2);
      for (int last = 1; last <= polls; last += std::max(1, polls / 15)) {
        Foam foam = start;
        const auto equilibrator = make_equilibrator(engine.equilibrator);
        int asked = 0;
        EXPECT_THROW(equilibrator->equilibrate(foam, 0.05, [&] { return ++asked == last; }),
                     Aborted);
        expect_valid(foam);
        expect_measured(foam, last);
        if (engine.equilibrator.kind == EquilibratorKind::Newton) {
          equilibrator->forget();
          EXPECT_TRUE(equilibrator->equilibrate(foam, 0.05, {}).converged) << last;
        } else {
          EXPECT_EQ(film_set(foam), film_set(start)) << last;
        }
      }
    }
  }
}

/// Every place moved by a map; pressures and arcs stay.
template <class Map> Foam mapped(Foam foam, const Map& map) {
  for (Vec2& p : foam.position) {
    p = map(p);
  }
  return foam;
}

/// How far coordinates may be off by rounding, cm.
double rounding(const Foam& foam) {
  double farthest = 0;
  for (const Vec2 p : foam.position) {
    farthest = std::max({farthest, std::abs(p.x), std::abs(p.y)});
  }
  return farthest * std::numeric_limits<double>::epsilon();
}

bool is_confirmed(const Foam& foam) {
  return confirmed(foam.report, foam, rounding(foam)) == foam.report;
}

TEST(Report, HoldsWhereverAFoamIsMovedAndTurned) {
  std::mt19937 random(1);
  std::uniform_real_distribution<double> uniform(-1, 1);
  for (std::uint64_t seed = 1; seed <= 30; ++seed) {
    const Foam foam = random_foam(50, Boundary::Free, seed);
    ASSERT_TRUE(foam.report.converged);
    EXPECT_TRUE(is_confirmed(foam));
    for (const double far : {1.0, 1e3, 1e6, 4e6, 1e9}) {
      const double angle = 3 * uniform(random);
      const Vec2 shift{far * uniform(random), far * uniform(random)};
      const Foam moved = mapped(foam, [&](Vec2 p) {
        return Vec2{std::cos(angle) * p.x - std::sin(angle) * p.y,
                    std::sin(angle) * p.x + std::cos(angle) * p.y} +
               shift;
      });
      EXPECT_TRUE(confirmed(moved.report, moved, rounding(moved)).converged) << seed << ' ' << far;
    }
  }
}

TEST(Report, OfEveryFrameHolds) {
  for (const CoarseningOptions& options : engines()) {
    for (const auto boundary : {Boundary::Free, Boundary::Periodic, Boundary::Fixed}) {
      const auto coarsening = make_coarsening(options);
      coarsening->restart(random_foam(60, boundary));
      for (int frame = 0; frame < 8 && coarsening->advance({}); ++frame) {
        const Foam read = foam_of(film_set(coarsening->foam()));
        EXPECT_TRUE(is_confirmed(read)) << frame;
      }
    }
  }
}

/// Scaled by s, areas are s²A for targets A, and Δp·d/T is s times 2 sin α.
TEST(Report, DoesNotHoldOfAFoamThatWasScaled) {
  const Foam foam = random_foam(50, Boundary::Free);
  for (const double scale : {0.5, 0.999, 1.000001, 2.0}) {
    const Foam scaled = mapped(foam, [&](Vec2 p) { return scale * p; });
    const EquilibriumReport found = confirmed(scaled.report, scaled, rounding(scaled));
    EXPECT_FALSE(found.converged);
    EXPECT_NEAR(found.max_area_error, std::abs(scale * scale - 1), 1e-8);
    EXPECT_LT(found.max_angle_error, 1e-8);
    double curvature = 0;
    for (const Film f : foam.film_slots()) {
      curvature = std::max(curvature, std::abs(2 * std::sin(foam.film_angle[f]) * (1 - scale)));
    }
    if (scale < 1) { // a larger pressure can ask for less than a half circle
      EXPECT_NEAR(max_curvature_error(scaled), curvature, 1e-8);
    }
    EXPECT_EQ(found.iterations, foam.report.iterations);
  }
}

TEST(Report, DoesNotHoldOfAFoamThatWasStretchedOrWhosePressuresChanged) {
  const Foam foam = random_foam(50, Boundary::Free);
  const Foam stretched = mapped(foam, [](Vec2 p) { return Vec2{1.01 * p.x, p.y / 1.01}; });
  const EquilibriumReport found = confirmed(stretched.report, stretched, rounding(stretched));
  EXPECT_FALSE(found.converged);
  EXPECT_EQ(found.max_angle_error, max_angle_error(stretched));
  EXPECT_GT(found.max_angle_error, 1e-3);
  Foam pressed = foam;
  for (double& p : pressed.pressure) {
    p *= 1.001;
  }
  EXPECT_FALSE(confirmed(pressed.report, pressed, rounding(pressed)).converged);
}

} // namespace
} // namespace foam
