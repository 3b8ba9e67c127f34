// SPDX-License-Identifier: GPL-3.0-or-later
//
// What surrounds a foam: outsides, be they gases or solid, and on a torus its own images.
#pragma once

#include <cstdint>

#include "geometry/lattice.h"
#include "geometry/vec2.h"

namespace foam {

/// What a user picks, and what is built from it.
enum class Boundary {
  Free,     ///< the foam floats in a gas
  Periodic, ///< the foam fills a torus
  Fixed     ///< a sealed container: the films beside the outside are its wall, straight and tight
};

/// An outside.
struct Exterior {
  enum class Kind : std::uint8_t {
    Gas,  ///< its films are films like others
    Solid ///< what lies beside it is a wall without tension, on which films end and are pinned
  };

  Kind kind = Kind::Gas;
  double pressure = 0; ///< of a gas, N/cm²

  friend bool operator==(const Exterior&, const Exterior&) = default;
};

/// How a junction may move.
class Freedom {
public:
  FOAM_HOST_DEVICE static Freedom free() { return Freedom(Kind::Free, {}); }
  /// \param tangent of the curve that it keeps to, of length 1
  FOAM_HOST_DEVICE static Freedom along(Vec2 tangent) { return Freedom(Kind::Along, tangent); }
  FOAM_HOST_DEVICE static Freedom none() { return Freedom(Kind::None, {}); }

  FOAM_HOST_DEVICE bool any() const { return kind_ != Kind::None; }
  /// What is left of a displacement, or of a force.
  FOAM_HOST_DEVICE Vec2 of(Vec2 v) const {
    switch (kind_) {
    case Kind::Free:
      return v;
    case Kind::Along:
      return dot(v, tangent_) * tangent_;
    default:
      return {};
    }
  }

private:
  enum class Kind : std::uint8_t { Free, Along, None };

  FOAM_HOST_DEVICE Freedom(Kind kind, Vec2 tangent) : kind_(kind), tangent_(tangent) {}

  Kind kind_;
  Vec2 tangent_;
};

/// Of a foam as a whole.
struct Surroundings {
  Boundary boundary = Boundary::Free;
  Lattice lattice; ///< of a torus; unused otherwise

  FOAM_HOST_DEVICE bool periodic() const { return boundary == Boundary::Periodic; }
  /// Whether some outside is solid.
  FOAM_HOST_DEVICE bool has_walls() const { return boundary == Boundary::Fixed; }
  /// Whether the sum of the bubbles' areas is given: a common pressure is felt by nobody then.
  FOAM_HOST_DEVICE bool closed() const { return boundary != Boundary::Free; }
  /// Whether the foam moves as a whole, or turns, at no cost.
  FOAM_HOST_DEVICE bool translates() const { return !has_walls(); }
  FOAM_HOST_DEVICE bool rotates() const { return boundary == Boundary::Free; }

  friend bool operator==(const Surroundings&, const Surroundings&) = default;
};

} // namespace foam
