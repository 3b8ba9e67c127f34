// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "geometry/vec2.h"
#include "mesh/elements.h"
#include "mesh/mesh_access.h"

namespace foam {

/// What is known about a foam's equilibrium.
struct EquilibriumReport {
  bool converged = false;
  int iterations = 0;
  double max_angle_error = 0; ///< rad, largest deviation from 120° at a junction that may move
  double max_area_error = 0;  ///< largest |A − A^τ|/A^τ
  double residual = 0;        ///< largest dimensionless residual of the equilibrium's equations

  friend bool operator==(const EquilibriumReport&, const EquilibriumReport&) = default;
};

/// What is known about a foam as a whole.
struct FoamRecord {
  Boundary boundary = Boundary::Free;
  Box box;                    ///< the torus; unused otherwise
  double surface_tension = 0; ///< γ, N/cm
  double time = 0;            ///< s
  std::int64_t t1_count = 0;  ///< T1s so far
  std::int64_t t2_count = 0;  ///< T2s so far
  std::int64_t t3_count = 0;  ///< T3s so far
  EquilibriumReport report;   ///< of the last equilibration

  friend bool operator==(const FoamRecord&, const FoamRecord&) = default;
};

/// A two-dimensional dry foam: the dual mesh of the thesis (3.2, 4.5.2), as a structure of arrays
/// that is allocated once; vanished elements are masked.
///
/// A film f is a pair of half-films 2f and 2f + 1, each other's twins. A half-film starts in a
/// junction and has a bubble on its left. A junction knows its three outgoing half-films in
/// counter-clockwise order, which makes "three films to a junction" a property of the type. A
/// bubble knows one half-film that has it on its left; its films are visited counter-clockwise by
/// next_in_bubble. The world is kWorld; it has no entry in the bubbles' arrays, and pressure 0.
struct Foam : MeshAccess<Foam>, FoamRecord {
  // Bubbles.
  std::vector<Index> bubble_half;      ///< one half-film with the bubble on its left; kNone if gone
  std::vector<Index> sides;            ///< number of films
  std::vector<double> pressure;        ///< N/cm²
  std::vector<double> target_area;     ///< A^τ, cm²
  std::vector<std::int64_t> bubble_id; ///< persistent name of a bubble

  // Half-films.
  std::vector<Index> half_junction; ///< where it starts; kNone if gone
  std::vector<Index> half_bubble;   ///< on its left

  // Films; values as seen from half-film 2f.
  std::vector<double> film_angle; ///< half-angle α, rad
  std::vector<Wrap> film_wrap;    ///< periods from start to end

  // Junctions.
  std::vector<Vec2> position;                      ///< cm
  std::vector<std::array<Index, 3>> junction_half; ///< outgoing, counter-clockwise; kNone if gone

  std::uint64_t topology = 0; ///< grows with every topological change

  Index bubble_capacity() const { return static_cast<Index>(bubble_half.size()); }
  Index film_capacity() const { return static_cast<Index>(film_angle.size()); }
  Index junction_capacity() const { return static_cast<Index>(position.size()); }

  Index bubble_count() const;
  Index film_count() const;
  Index junction_count() const;

  /// Film energy 2γ·Σl, N; the wall of a sealed container is no film.
  double energy() const;
  /// √(mean target area), the foam's own unit of length, cm.
  double mean_spacing() const;

  void resize(Index bubbles, Index films, Index junctions);
};

} // namespace foam
