// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "equilibrium/film_lagrangian.h"
#include "equilibrium/sparse_solver.h"
#include "equilibrium/unknowns.h"

namespace foam {

/// The matrix of Newton's equations in a region: the second derivatives of the Lagrangian,
/// symmetric and indefinite, as the sum of its films' shares.
///
/// The half-angle of a film is eliminated where ∂²φ/∂α² is safely positive, and kept as an unknown
/// where it is not: arcs around and beyond 90°, as at the free boundary. Foams have directions in
/// which they move at no cost (translations, rotations, the common pressure of a torus, a two-sided
/// bubble along its film): a regularisation too small to be felt elsewhere holds them.
class NewtonMatrix {
public:
  /// Whether the film's half-angle should be an unknown.
  static bool angle_is_delicate(const Foam& foam, Index film);

  /// Numbers the unknowns. \param keep_angle by place in region.films
  void set_up(const Foam& foam, const Region& region, std::span<const char> keep_angle);

  /// \param shift of the second derivatives by positions and half-angles, in units of T/spacing and
  /// T·d. \returns the films, by place, whose eliminated angles must be kept; if there are any, the
  /// matrix is of no use.
  std::vector<std::size_t> assemble(const Foam& foam, const Region& region, double shift);
  /// Brings one film's share up to date. \returns false if its angle must be kept but is not.
  bool assemble_film(const Foam& foam, const Region& region, std::size_t place, double shift);

  const Unknowns& unknowns() const { return unknowns_; }
  std::array<Index, 7> film_unknowns(std::size_t place) const { return films_[place].unknown; }
  bool keeps_angle(std::size_t place) const {
    return films_[place].unknown[FilmLagrangian::kAngle] != kNone;
  }

  /// What the eliminated angles' residuals ∂φ/∂α (by place) do to the unknowns: rhs +=
  /// Bᵀ·g/∂²φ/∂α².
  void condense(std::span<const double> angle_gradient, std::span<double> rhs) const;
  /// An angle's change that belongs to the unknowns' change x.
  double angle_change(std::size_t place, double angle_gradient, std::span<const double> x) const;

  /// from −= K·x.
  void subtract_product(std::span<const double> x, std::span<double> from) const;
  /// The same where x is numbered otherwise: by `columns`, for each film in its place, and `rows`.
  void subtract_product(std::span<const double> x, std::span<const std::array<Index, 7>> columns,
                        std::span<const Index> rows, std::span<double> from) const;

  const SymmetricPattern& pattern();
  std::vector<double> values() const; ///< in the pattern's order \pre pattern() was called

private:
  struct Film {
    std::array<Index, 7> unknown{}; ///< kNone where held
    std::array<double, 28> share{}; ///< lower triangle; of an eliminated α the last row before
  };
  static void subtract_film(const Film& film, const std::array<Index, 7>& columns,
                            std::span<const double> x, std::span<double> from);
  void build_pattern();
  double regularisation(std::size_t unknown) const;

  Unknowns unknowns_;
  std::vector<Film> films_;
  double junction_diagonal_ = 0;
  double pressure_diagonal_ = 0;

  SymmetricPattern pattern_;
  std::vector<std::array<Index, 28>> slots_; ///< of the shares in the pattern; empty: not built
  std::vector<Index> diagonal_;              ///< slots
};

} // namespace foam
