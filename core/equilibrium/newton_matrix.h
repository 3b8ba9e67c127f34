// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "algebra/element_matrix.h"
#include "equilibrium/unknowns.h"
#include "physics/film_lagrangian.h"

namespace foam {

/// What a film adds to the matrix of Newton's equations, in the order of FilmLagrangian.
using FilmMatrix = ElementMatrix<FilmLagrangian::kVariables>;

/// The matrix of Newton's equations in a region: the second derivatives of the Lagrangian,
/// symmetric and indefinite, as the sum of its films' shares.
///
/// The half-angle of a film is eliminated where ∂²φ/∂α² is safely positive, and kept as an unknown
/// where it is not: arcs around and beyond 90°, as at the free boundary. Foams have directions in
/// which they move at no cost (translations, rotations, the common pressure of a torus, a two-sided
/// bubble along its film): a regularisation too small to be felt elsewhere holds them. Where they
/// are such exactly, a whole foam's translations and common pressure, one junction and one pressure
/// are pinned for its factorisation. For a load that has no part in them this decides how much of
/// them there is in a solution and nothing else; the rounding of factors would decide it otherwise.
class NewtonMatrix {
public:
  /// Whether the film's half-angle should be an unknown.
  static bool angle_is_delicate(const Foam& foam, Film film);

  /// Numbers the unknowns. \param keep_angle by place in region.films
  void set_up(const Foam& foam, const Region& region, std::vector<char> keep_angle);

  /// \param shift of the second derivatives by positions and half-angles, in units of T/spacing and
  /// T·d. \returns false, and no matrix, if half-angles have had to be made unknowns: the unknowns
  /// are numbered anew then.
  bool assemble(const Foam& foam, const Region& region, double shift);

  const Unknowns& unknowns() const { return unknowns_; }
  /// Changes whenever they are numbered.
  int numbering() const { return numbering_; }

  /// What the half-angles' residuals ∂φ/∂α (by place) do to a right-hand side: rhs −= ∂φ/∂α where
  /// they are kept, rhs += Bᵀ·∂φ/∂α/∂²φ/∂α² where they are eliminated.
  void add_angles(std::span<const double> angle_gradient, std::span<double> rhs) const;
  /// An angle's change that belongs to the unknowns' change x. \param held by how much the film's
  /// variables that are held change
  double angle_change(std::size_t place, double angle_gradient, std::span<const double> x,
                      const FilmLagrangian::Each<double>& held) const;

  /// from −= K·x.
  void subtract_product(std::span<const double> x, std::span<double> from) const;

  /// By place in region.films; of an eliminated α the last row is what it was before.
  std::span<const FilmMatrix> shares() const { return films_; }
  /// What is added to the shares where they are factorised, by unknown.
  const std::vector<double>& diagonal() const { return diagonal_; }

private:
  Unknowns unknowns_;
  int numbering_ = 0;
  std::vector<char> keep_angle_; ///< by place
  std::vector<FilmMatrix> films_;
  std::vector<double> regularisation_; ///< by unknown
  std::vector<double> diagonal_;       ///< the same and the pins
};

} // namespace foam
