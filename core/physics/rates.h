// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "mesh/foam.h"
#include "physics/film_lagrangian.h"

namespace foam {

/// How fast everything in a foam moves, by element; empty where nothing does.
struct Rates {
  std::span<const Vec2> junctions;   ///< cm/s
  std::span<const double> angles;    ///< of films, rad/s
  std::span<const double> pressures; ///< of bubbles, N/(cm² s)

  /// Of the variables of a film, in the order of FilmLagrangian.
  FilmLagrangian::Each<double> of_film(const Foam& foam, Film film) const {
    if (junctions.empty()) {
      return {};
    }
    // A wall holds what has come to it since.
    const auto of_junction = [&](Junction j) { return foam.freedom(j).of(junctions[j.place()]); };
    const auto of_bubble = [&](Bubble b) { return b.is_outside() ? 0 : pressures[b.place()]; };
    return film_variables(foam, film, of_junction, of_bubble, angles[film.place()]);
  }
};

} // namespace foam
