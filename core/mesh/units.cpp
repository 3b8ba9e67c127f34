// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/units.h"

#include <algorithm>
#include <cmath>

#include "geometry/bounds.h"

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

UnitChange own_units(const Foam& foam, UnitSteps steps) {
  Bounds bounds;
  const auto include = [&](Vec2 place) { bounds = bounds + Bounds{place, place}; };
  for (const Junction j : foam.junction_slots()) {
    if (foam.has_junction(j)) {
      include(foam.position[j]);
    }
  }
  if (foam.surroundings.periodic()) {
    include(foam.surroundings.lattice.origin);
  }
  const double spacing = foam.mean_spacing();
  const auto [width, height] = bounds.extent();
  const double extent = power_of_two(std::ceil(std::log2(std::max({width, height, spacing}))));
  UnitChange change;
  change.length = 1 / nearest_power(spacing, steps);
  change.tension = 1 / nearest_power(foam.surface_tension / kThesisTension, steps);
  change.shift = -(change.length * Vec2{origin(bounds.low.x, bounds.high.x, extent),
                                        origin(bounds.low.y, bounds.high.y, extent)});
  return change;
}

Exterior in_units(const Exterior& exterior, const UnitChange& change) {
  Exterior result = exterior;
  result.pressure *= change.pressure();
  return result;
}

WallPiece in_units(const WallPiece& piece, const UnitChange& change) {
  return {change.place(piece.start), change.length * piece.chord, piece.half_angle};
}

Lattice in_units(const Lattice& lattice, const UnitChange& change) {
  return {change.place(lattice.origin), change.length * lattice.first,
          change.length * lattice.second};
}

Thresholds in_units(const Thresholds& thresholds, const UnitChange& change) {
  return {change.length * thresholds.t1_length, change.area() * thresholds.t2_area};
}

FoamRecord in_units(const FoamRecord& record, const UnitChange& change) {
  FoamRecord result = record;
  if (record.surroundings.has_images()) {
    result.surroundings.lattice = in_units(record.surroundings.lattice, change);
  }
  if (record.surroundings.wall_symmetry == WallSymmetry::Circle) {
    result.surroundings.centre = change.place(record.surroundings.centre);
  }
  result.surface_tension *= change.tension;
  if (result.ended) {
    result.ended->area *= change.area();
    result.ended->area_ahead *= change.area();
    result.ended->limit = in_units(result.ended->limit, change);
  }
  result.growth_constant *= change.area();
  result.thresholds = in_units(result.thresholds, change);
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
  for (TopologicalOperation& operation : foam.operations) {
    operation.place = change.place(operation.place);
  }
  for (Exterior& exterior : foam.exterior) {
    exterior = in_units(exterior, change);
  }
  for (WallPiece& piece : foam.wall_piece) {
    piece = in_units(piece, change);
  }
}

} // namespace foam
