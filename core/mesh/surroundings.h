// SPDX-License-Identifier: GPL-3.0-or-later
//
// What surrounds a foam: outsides, be they gases or solid, and on a torus its own images.
#pragma once

#include <cstdint>

#include "geometry/lattice.h"
#include "geometry/vec2.h"
#include "mesh/ids.h"

namespace foam {

/// What a user picks, and what is built from it.
enum class Boundary {
  Free,     ///< the foam floats in a gas
  Periodic, ///< the foam fills a torus
  Fixed,    ///< the foam's own first outline is a container, on which films are pinned
  Container ///< the foam fills a container
};

/// How films end on a wall.
enum class WallContact : std::uint8_t {
  Slip,  ///< at 90°: they slide along it
  Pinned ///< where they are
};

/// An outside.
struct Exterior {
  enum class Kind : std::uint8_t {
    Gas,  ///< its films are films like others
    Solid ///< what lies beside it is a wall without tension, on which films end
  };

  Kind kind = Kind::Gas;
  double pressure = 0; ///< of a gas, N/cm²
  WallContact contact = WallContact::Pinned;
  Index first_piece = 0; ///< of the wall, walked with the foam on the left;
  Index pieces = 0;      ///< so many follow each other and close. A single one is a straight line
                         ///< from one image of a period to the next.
  Bubble host = kNone;   ///< that the wall lies in, if no film ends on it

  friend bool operator==(const Exterior&, const Exterior&) = default;
};

/// How a junction may move.
class Freedom {
public:
  FOAM_HOST_DEVICE static Freedom free() { return Freedom(Kind::Free, {}); }
  /// \param tangent of the curve that it keeps to, of length 1 \param curvature by which that turns
  /// to the left, 1/cm
  FOAM_HOST_DEVICE static Freedom along(Vec2 tangent, double curvature) {
    return Freedom(Kind::Along, tangent, curvature);
  }
  FOAM_HOST_DEVICE static Freedom none() { return Freedom(Kind::None, {}); }

  FOAM_HOST_DEVICE bool any() const { return kind_ != Kind::None; }
  /// Whether it keeps to a curve.
  FOAM_HOST_DEVICE bool is_along() const { return kind_ == Kind::Along; }
  FOAM_HOST_DEVICE Vec2 tangent() const { return tangent_; }
  FOAM_HOST_DEVICE double curvature() const { return curvature_; }
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

  FOAM_HOST_DEVICE Freedom(Kind kind, Vec2 tangent, double curvature = 0)
      : kind_(kind), tangent_(tangent), curvature_(curvature) {}

  Kind kind_;
  Vec2 tangent_;
  double curvature_;
};

/// The motions of a whole foam that take its walls to themselves, and along which films slip.
enum class WallSymmetry : std::uint8_t {
  None,
  Line,  ///< along x, in a channel
  Circle ///< round a centre, in a disc or an annulus
};

/// Of a foam as a whole.
struct Surroundings {
  Boundary boundary = Boundary::Free;
  Lattice lattice; ///< of a torus; of a channel its first period alone; unused otherwise
  WallSymmetry wall_symmetry = WallSymmetry::None;
  Vec2 centre{}; ///< of walls that are circles, cm

  FOAM_HOST_DEVICE bool periodic() const { return boundary == Boundary::Periodic; }
  /// Whether some outside is solid.
  FOAM_HOST_DEVICE bool has_walls() const {
    return boundary == Boundary::Fixed || boundary == Boundary::Container;
  }
  /// Whether films may end in images of junctions, as on a torus or in a channel.
  FOAM_HOST_DEVICE bool has_images() const {
    return periodic() || (boundary == Boundary::Container && lattice.first.x != 0);
  }
  /// Whether the sum of the bubbles' areas is given: a common pressure is felt by nobody then.
  FOAM_HOST_DEVICE bool closed() const { return boundary != Boundary::Free; }
  /// Whether the foam moves as a whole at no cost, along x or y, or turns.
  FOAM_HOST_DEVICE bool translates_along_x() const {
    return !has_walls() || wall_symmetry == WallSymmetry::Line;
  }
  FOAM_HOST_DEVICE bool translates_along_y() const { return !has_walls(); }
  FOAM_HOST_DEVICE bool rotates() const {
    return boundary == Boundary::Free || wall_symmetry == WallSymmetry::Circle;
  }

  friend bool operator==(const Surroundings&, const Surroundings&) = default;
};

} // namespace foam
