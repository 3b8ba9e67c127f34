// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/reduce.h"

#include <gtest/gtest.h>

#include <cmath>

#include "foams.h"

namespace foam {
namespace {

Foam foam_on(const Lattice& torus) {
  BuildOptions options;
  options.boundary = Boundary::Periodic;
  options.torus = torus;
  Foam foam = build_from_points(jittered_grid(49, 1, 1, 1), options);
  for (const Film f : foam.film_slots()) {
    foam.film_angle[f] = 0.02 * (f.index() % 5);
  }
  return foam;
}

TEST(Reduce, KeepsTheFoamOnASkewedTorus) {
  for (const Lattice& torus :
       {Lattice{{0, 0}, {7, 0}, {25.9, 7}}, Lattice{{1, -2}, {7, 3}, {-60, -18}}}) {
    const Foam foam = foam_on(torus);
    const Foam compact = reduced(foam);
    test::expect_valid(compact);
    const auto& [origin, first, second] = compact.surroundings.lattice;
    EXPECT_EQ(origin, torus.origin);
    EXPECT_LE(2 * std::abs(dot(first, second)),
              std::min(dot(first, first), dot(second, second)) * (1 + 1e-9));
    EXPECT_NEAR(compact.surroundings.lattice.area(), torus.area(), 1e-11);
    EXPECT_EQ(compact.position, foam.position);
    EXPECT_EQ(compact.junction_half, foam.junction_half);
    for (const Half h : foam.half_slots()) {
      EXPECT_NEAR(norm(compact.chord(h) - foam.chord(h)), 0, 1e-12);
    }
    for (const Bubble b : foam.bubble_slots()) {
      EXPECT_NEAR(compact.area(b), foam.area(b), 1e-12);
    }
    EXPECT_NEAR(compact.energy(), foam.energy(), 1e-12 * foam.energy());
  }
}

TEST(Reduce, LeavesWhatIsCompactAsItIs) {
  for (const Lattice& torus : {Lattice::rectangle(0, 7, 0, 7), Lattice{{0, 0}, {7, 0}, {3.5, 7}},
                               Lattice{{0, 0}, {0, 7}, {-7, 0}}}) {
    const Foam foam = foam_on(torus);
    EXPECT_TRUE(film_set(reduced(foam)) == film_set(foam));
  }
  const Foam free = test::jittered_foam(Boundary::Free, 20, 1);
  EXPECT_TRUE(film_set(reduced(free)) == film_set(free));
}

} // namespace
} // namespace foam
