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
    const Half h = film.half();
    const Vec2 start = of_junction(foam, foam.start(h));
    const Vec2 end = of_junction(foam, foam.end(h));
    const auto pressure = [&](Bubble bubble) {
      return bubble.is_outside() ? 0 : pressures[bubble.place()];
    };
    return {start.x,
            start.y,
            end.x,
            end.y,
            pressure(foam.left(h)),
            pressure(foam.right(h)),
            angles[film.place()]};
  }

private:
  /// A wall holds what has come to it since.
  Vec2 of_junction(const Foam& foam, Junction junction) const {
    return foam.freedom(junction).of(junctions[junction.place()]);
  }
};

} // namespace foam
