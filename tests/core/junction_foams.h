// SPDX-License-Identifier: GPL-3.0-or-later
//
// Foams and measures for tests of the thesis's method.
#pragma once

#include <cmath>
#include <random>

#include "hand_made.h"
#include "thesis/junction_system.h"

namespace foam {

/// Displaces junctions by up to `size` (cm) and pressures by up to a tenth of that.
inline void disturb(Foam& foam, double size, unsigned seed) {
  std::mt19937 generator(seed);
  std::uniform_real_distribution<double> uniform(-size, size);
  for (Vec2& x : foam.position) {
    x += {uniform(generator), uniform(generator)};
  }
  for (double& p : foam.pressure) {
    p += 0.1 * uniform(generator);
  }
}

/// The half-angles that go with the pressures, by the law of sines: the chord 2|r|·sin α.
inline void set_half_angles(Foam& foam) {
  for (const Film f : foam.film_slots()) {
    const Half h = f.half();
    const double q = foam.pressure_difference(h);
    foam.set_half_angle(h, std::asin(q * norm(foam.chord(h)) / (2 * foam.tension(f))));
  }
}

/// Three equal bubbles round a junction at the origin, straight films of length 1.
inline Foam triple() {
  const double s = std::sqrt(0.75);
  return foam_of_polygons({{0, 0}, {0, 1}, {-s, -0.5}, {s, -0.5}},
                          {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}});
}

/// Whether no junction is inverted (thesis 3.5.1).
inline bool all_oriented(const Foam& foam) {
  for (const Junction j : foam.junction_slots()) {
    if (foam.has_junction(j) && !thesis::oriented(thesis::junction_star(foam, j))) {
      return false;
    }
  }
  return true;
}

} // namespace foam
