// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/units.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace foam {
namespace {

constexpr double kThesisTension = 0.25; // N/cm
constexpr double kFar = 4;              // extents from the origin

double power_of_two(double exponent) {
  return std::ldexp(1.0, static_cast<int>(exponent));
}

/// The power that is nearest to a value.
double nearest_power(double value, UnitSteps steps) {
  const int step = static_cast<int>(steps);
  return power_of_two(step * std::round(std::log2(value) / step));
}

/// Of a coordinate: of places that lie further from 0 than they lie apart, a multiple of a power
/// of two that is larger than they lie apart. No place has a digit below it that it loses.
double origin(double low, double high, double extent) {
  const double middle = low + 0.5 * (high - low);
  return std::abs(middle) < kFar * extent ? 0 : extent * std::round(middle / extent);
}

} // namespace

UnitChange own_units(double spacing, double surface_tension, std::span<const Vec2> places,
                     UnitSteps steps) {
  constexpr double kInfinity = std::numeric_limits<double>::infinity();
  Vec2 low{kInfinity, kInfinity};
  Vec2 high = -low;
  for (const Vec2 p : places) {
    low = {std::min(low.x, p.x), std::min(low.y, p.y)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y)};
  }
  const double extent =
      power_of_two(std::ceil(std::log2(std::max({high.x - low.x, high.y - low.y, spacing}))));
  UnitChange change;
  change.length = 1 / nearest_power(spacing, steps);
  change.tension = 1 / nearest_power(surface_tension / kThesisTension, steps);
  change.shift =
      -(change.length * Vec2{origin(low.x, high.x, extent), origin(low.y, high.y, extent)});
  return change;
}

UnitChange own_units(const Foam& foam, UnitSteps steps) {
  std::vector<Vec2> places;
  for (const Junction j : foam.junction_slots()) {
    if (foam.has_junction(j)) {
      places.push_back(foam.position[j]);
    }
  }
  if (foam.surroundings.periodic()) {
    places.push_back(foam.surroundings.lattice.origin);
  }
  return own_units(foam.mean_spacing(), foam.surface_tension, places, steps);
}

Exterior in_units(const Exterior& exterior, const UnitChange& change) {
  return {exterior.kind, change.pressure() * exterior.pressure};
}

Lattice in_units(const Lattice& lattice, const UnitChange& change) {
  return {change.place(lattice.origin), change.length * lattice.first,
          change.length * lattice.second};
}

FoamRecord in_units(const FoamRecord& record, const UnitChange& change) {
  FoamRecord result = record;
  if (record.surroundings.periodic()) {
    result.surroundings.lattice = in_units(record.surroundings.lattice, change);
  }
  result.surface_tension *= change.tension;
  if (result.ended) {
    result.ended->area *= change.area();
    result.ended->t2_area *= change.area();
    result.ended->t1_length *= change.length;
  }
  result.thresholds.t1_length *= change.length;
  result.thresholds.t2_area *= change.area();
  return result;
}

void change_units(Foam& foam, const UnitChange& change) {
  if (change.changes_nothing()) {
    return;
  }
  static_cast<FoamRecord&>(foam) = in_units(static_cast<const FoamRecord&>(foam), change);
  for (double& pressure : foam.pressure) {
    pressure *= change.pressure();
  }
  for (double& area : foam.target_area) {
    area *= change.area();
  }
  for (double& tension : foam.film_tension) {
    tension *= change.tension;
  }
  for (Vec2& position : foam.position) {
    position = change.place(position);
  }
  for (Exterior& exterior : foam.exterior) {
    exterior = in_units(exterior, change);
  }
}

} // namespace foam
