// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "mesh/fields.h"
#include "mesh/mesh_access.h"
#include "mesh/topological_event.h"

namespace foam {

/// What is known about a foam's equilibrium.
struct EquilibriumReport {
  bool converged = false;
  int iterations = 0;
  /// rad, largest deviation at a junction that may move from the angles that its films' tensions
  /// ask for
  double max_angle_error = 0;
  double max_area_error = 0; ///< largest |A − A^τ|/A^τ
  double residual = 0;       ///< largest dimensionless residual of the equilibrium's equations

  friend bool operator==(const EquilibriumReport&, const EquilibriumReport&) = default;
};

/// How small a film or a bubble is when it gives way.
struct Thresholds {
  double t1_length = 0; ///< δ_T1, cm
  double t2_area = 0;   ///< δ_T2, cm²

  friend bool operator==(const Thresholds&, const Thresholds&) = default;
};

/// Where thresholds come from.
enum class ThresholdKind : std::uint8_t {
  Absolute, ///< the two values (thesis 3.2.2)
  Relative, ///< Weygand's, from alpha
  Automatic ///< a small part of the bubbles' own size
};

/// Why a foam cannot go on, in figures of the last one that there is.
struct End {
  enum class Cause : std::uint8_t {
    LastTwo,       ///< a bubble is to vanish that is one of the last two
    AllVanish,     ///< the largest bubble is to vanish, and with it all others
    CannotVanish,  ///< a bubble is to vanish, and no operation takes it away
    NoEquilibrium, ///< none was found for what comes next
    NotStrained    ///< none was found at a strain that it was to go through
  };

  Cause cause = Cause::NoEquilibrium;
  std::int64_t bubble = 0; ///< the one that is to vanish; the smallest if there is no equilibrium
  Index sides = 0;         ///< its films
  double area = 0;         ///< its A^τ, cm²
  double area_ahead = 0; ///< that it would have in the next frame if that turns it inside out, cm²
  Thresholds limit;      ///< in force
  ThresholdKind thresholds = ThresholdKind::Automatic; ///< where those come from
  bool least_t2_area = false;                          ///< no smaller one would be in force
  Index bubbles = 0;                                   ///< that are left
  double strain = 0;                                   ///< at which there was no equilibrium

  friend bool operator==(const End&, const End&) = default;
};

/// What is known about a foam as a whole.
struct FoamRecord {
  Surroundings surroundings;
  double surface_tension = 0; ///< γ, N/cm; 2γ is what forces are measured in
  double time = 0;            ///< s
  std::int64_t t1_count = 0;  ///< T1s so far
  std::int64_t t2_count = 0;  ///< T2s so far
  std::int64_t t3_count = 0;  ///< T3s so far
  EquilibriumReport report;   ///< of the last equilibration
  std::optional<End> ended;   ///< of a run that ended with this foam
  double time_step = 0;       ///< with which it coarsens, s; 0 if it has not begun to
  double growth_constant = 0; ///< von Neumann's K with which it does, cm²/s
  Thresholds thresholds;      ///< in force in the time step that is to come
  double strain = 0;          ///< by which a torus has been deformed
  int strain_direction = 0;   ///< ±1, in which its strain goes; 0 if it has not been

  friend bool operator==(const FoamRecord&, const FoamRecord&) = default;
};

/// A wall, as it is built from.
struct Wall {
  std::vector<WallPiece> pieces; ///< that follow each other; see Exterior
  WallContact contact = WallContact::Slip;
};

/// A two-dimensional dry foam: the dual mesh of the thesis (3.2, 4.5.2), as a structure of arrays
/// that is allocated once; vanished elements are masked.
///
/// A film has two half-films, each other's twins. A half-film starts in a junction and has a bubble
/// on its left. A junction knows its three outgoing half-films in counter-clockwise order, which
/// makes "three films to a junction" a property of the type. A bubble knows one half-film that has
/// it on its left; its films are visited counter-clockwise by next_in_bubble. Where a bubble may
/// stand, an outside may as well.
struct Foam : FoamArrays<Field>, MeshAccess<Foam>, FoamRecord {
  std::uint64_t topology = 0;                   ///< grows with every topological change
  std::vector<TopologicalOperation> operations; ///< performed, since these were read last

  Slots<Bubble> bubble_slots() const { return Slots<Bubble>(count(bubble_half)); }
  Slots<Film> film_slots() const { return Slots<Film>(count(film_angle)); }
  Slots<Half> half_slots() const { return Slots<Half>(count(half_junction)); }
  Slots<Junction> junction_slots() const { return Slots<Junction>(count(position)); }
  FOAM_HOST_DEVICE Slots<Outside> outside_slots() const { return Slots<Outside>(count(exterior)); }
  Slots<Piece> piece_slots() const { return Slots<Piece>(count(wall_piece)); }

  Index bubble_count() const;
  Index film_count() const;
  Index junction_count() const;

  /// Energy of the films Σ T·l, N; a wall has none.
  double energy() const;
  /// Of the bubbles' targets, cm².
  double mean_area() const;
  /// √(mean target area), the foam's own unit of length, cm.
  double mean_spacing() const;

  /// So many elements of each kind, all of them gone. Outsides stay.
  void clear(Index bubbles, Index films, Index junctions);
  /// So many films and junctions more, all of them gone.
  void make_room(Index films, Index junctions);
  /// Takes surroundings without walls, with outsides of pressure 0.
  void surround(const Surroundings& with);
  /// Takes walls, each closed and with the foam on its left, as solid outsides, and finds their
  /// symmetry.
  void set_walls(const std::vector<Wall>& walls);
  /// Makes the first outside a container of the shape that the films beside it have, on which films
  /// are pinned. \pre these are straight
  void seal_outline();

private:
  void find_pieces();

  template <class Array> FOAM_HOST_DEVICE static Index count(const Array& array) {
    return static_cast<Index>(array.size());
  }
};

/// A foam's operations, by its bubbles' ids.
std::vector<TopologicalEvent> events_of(const Foam& foam);

} // namespace foam
