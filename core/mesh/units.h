// SPDX-License-Identifier: GPL-3.0-or-later
//
// A foam is homogeneous: in other units of length and tension, and with another origin, it is the
// same foam.
#pragma once

#include "mesh/foam.h"

namespace foam {

/// A change of units.
struct UnitChange {
  double length = 1;  ///< that lengths are multiplied by
  double tension = 1; ///< that tensions are multiplied by
  Vec2 shift;         ///< of places, in the new unit of length

  double area() const { return length * length; }
  double pressure() const { return tension / length; }
  double energy() const { return tension * length; }
  Vec2 place(Vec2 p) const { return length * p + shift; }

  UnitChange inverse() const { return {1 / length, 1 / tension, -((1 / length) * shift)}; }
  bool changes_nothing() const { return length == 1 && tension == 1 && shift == Vec2{}; }

  friend bool operator==(const UnitChange&, const UnitChange&) = default;
};

/// How finely units are adapted to a foam: by powers of this power of two.
enum class UnitSteps {
  Fine = 1,  ///< of 2
  Coarse = 6 ///< of 64
};

/// Into units in which bubbles are about 1 across, the surface tension is about 1/4, and the foam
/// lies near the origin if it lies far away from it. All are powers of two, or multiples of a
/// power of two, so that going there and back changes no bit.
UnitChange own_units(const Foam& foam, UnitSteps steps);

Exterior in_units(const Exterior& exterior, const UnitChange& change);
WallPiece in_units(const WallPiece& piece, const UnitChange& change);
Lattice in_units(const Lattice& lattice, const UnitChange& change);
Thresholds in_units(const Thresholds& thresholds, const UnitChange& change);
FoamRecord in_units(const FoamRecord& record, const UnitChange& change);
void change_units(Foam& foam, const UnitChange& change);

} // namespace foam
