// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <span>
#include <vector>

#include "equilibrium/region.h"
#include "mesh/foam.h"

namespace foam {

/// The unknowns of a region, numbered: x and y of every junction, then every bubble's pressure,
/// then the half-angles that are kept.
class Unknowns {
public:
  /// Costs no more than the region before and this one are large, but for the first time.
  /// \param keep_angle by place in region.films
  void number(const Foam& foam, const Region& region, std::span<const char> keep_angle);

  Index count() const { return count_; }
  Index first_pressure() const { return first_pressure_; }
  Index first_angle() const { return first_angle_; }

  // Numbers, or kNone for what is held, eliminated, or was not there when this was set up.
  /// Of x; that of y follows.
  Index junction(Index junction) const { return junctions_.at(junction); }
  Index bubble(Index bubble) const { return bubble == kWorld ? kNone : bubbles_.at(bubble); }
  Index angle(Index film) const { return angles_.at(film); }
  /// In the order of FilmLagrangian.
  std::array<Index, 7> of_film(const Foam& foam, Index film) const;

private:
  /// Of some elements among many.
  class Numbers {
  public:
    void clear(std::size_t capacity);
    void put(Index element, Index number);
    Index at(Index element) const {
      return Foam::size(element) < numbers_.size() ? numbers_[Foam::size(element)] : kNone;
    }

  private:
    std::vector<Index> numbers_;  ///< by element
    std::vector<Index> elements_; ///< that have one
  };

  Numbers junctions_, bubbles_, angles_;
  Index first_pressure_ = 0;
  Index first_angle_ = 0;
  Index count_ = 0;
};

/// By the numbers that a region's unknowns have in one numbering, those in another, or kNone.
std::vector<Index> translation(const Region& region, const Unknowns& from, const Unknowns& to);

} // namespace foam
