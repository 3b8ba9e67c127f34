// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/measured_targets.h"

#include <cmath>

namespace foam {

namespace {

double pressure_factor(const Foam& foam) {
  double product = 0;
  double square = 0;
  for (const Film f : foam.film_slots()) {
    if (foam.bends(f)) {
      const Half h = f.half();
      const double asked = foam.pressure_difference(h) * norm(foam.chord(h)) / foam.tension(f);
      product += 2 * std::sin(foam.half_angle(h)) * asked;
      square += asked * asked;
    }
  }
  return square > 0 ? product / square : 1;
}

/// Of the world; on a torus, where only differences are felt, 0.
double world_pressure(const Foam& foam) {
  return foam.exterior.empty() ? 0 : foam.exterior[kWorld.outside()].pressure;
}

} // namespace

double fit_bubble_pressures(Foam& foam) {
  const double factor = pressure_factor(foam);
  const double world = world_pressure(foam);
  for (double& pressure : foam.pressure) {
    pressure = world + factor * (pressure - world);
  }
  return factor;
}

void take_measured_targets(Foam& foam) {
  for (const Bubble b : foam.bubble_slots()) {
    if (foam.has_bubble(b)) {
      foam.target_area[b] = foam.area(b);
    }
  }
  const double factor = fit_bubble_pressures(foam);
  const double world = world_pressure(foam);
  for (Exterior& exterior : foam.exterior) {
    exterior.pressure = world + factor * (exterior.pressure - world);
  }
}

} // namespace foam
