// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "equilibrium/domain.h"
#include "mesh/foam.h"
#include "mesh/sparse_numbers.h"
#include "physics/film_lagrangian.h"

namespace foam {

/// The unknowns of a region, numbered: x and y of every junction, then every bubble's pressure,
/// then the half-angles that are kept, each in the region's order.
class Unknowns {
public:
  /// Costs no more than the region before and this one are large, but for the first time.
  /// \param keep_angle by place in region.films
  void number(const Foam& foam, const Region& region, std::span<const char> keep_angle);

  Index count() const { return count_; }
  Index first_pressure() const { return first_pressure_; }
  Index first_angle() const { return first_angle_; }

  /// A film's, in the order of FilmLagrangian; kNone for what is held, eliminated, or was not there
  /// when they were numbered.
  FilmLagrangian::Each<Index> of_film(const Foam& foam, Film film) const;
  /// By place in the list.
  std::vector<FilmLagrangian::Each<Index>> of_films(const Foam& foam,
                                                    std::span<const Film> films) const;
  bool keeps_angle(Film film) const { return angles_.at(film) != kNone; }

private:
  SparseNumbers<Junction> junctions_; ///< of x; that of y follows
  SparseNumbers<Bubble> bubbles_;
  SparseNumbers<Film> angles_;
  Index first_pressure_ = 0;
  Index first_angle_ = 0;
  Index count_ = 0;
};

} // namespace foam
