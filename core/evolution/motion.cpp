// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolution/motion.h"

#include <utility>

namespace foam {

void Motion::begin(const Foam& foam, std::vector<double> area_rates, double now) {
  junction_rates_.assign(foam.position.size(), {});
  angle_rates_.assign(foam.film_angle.size(), 0.0);
  pressure_rates_.assign(foam.pressure.size(), 0.0);
  area_rates_ = std::move(area_rates);
  junction_time_.assign(foam.position.size(), now);
  film_time_.assign(foam.film_angle.size(), now);
  bubble_time_.assign(foam.pressure.size(), now);
}

void Motion::take(const Region& region, const Step& response) {
  for (std::size_t i = 0; i < region.junctions.size(); ++i) {
    junction_rates_[Foam::size(region.junctions[i])] = response.junctions[i];
  }
  for (std::size_t i = 0; i < region.films.size(); ++i) {
    angle_rates_[Foam::size(region.films[i])] = response.angles[i];
  }
  for (std::size_t i = 0; i < region.bubbles.size(); ++i) {
    pressure_rates_[Foam::size(region.bubbles[i])] = response.pressures[i];
  }
}

void Motion::hold_wall(const Foam& foam, Index bubble) {
  for_each_half(foam, bubble, [&](Index h) {
    if (foam.wall(h)) {
      angle_rates_[Foam::size(Foam::film_of(h))] = 0;
      junction_rates_[Foam::size(foam.start(h))] = {};
      junction_rates_[Foam::size(foam.end(h))] = {};
    }
  });
}

void Motion::bring(Foam& foam, std::span<const Index> bubbles, double now) {
  for (const Index b : bubbles) {
    bring_bubble(foam, b, now);
    for_each_half(foam, b, [&](Index h) {
      bring_film(foam, Foam::film_of(h), now);
      bring_junction(foam, foam.start(h), now);
    });
  }
}

void Motion::bring_all(Foam& foam, double now) {
  for (Index j = 0; j < foam.junction_capacity(); ++j) {
    bring_junction(foam, j, now);
  }
  for (Index f = 0; f < foam.film_capacity(); ++f) {
    bring_film(foam, f, now);
  }
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    bring_bubble(foam, b, now);
  }
}

Vec2 Motion::chord_rate(const Foam& foam, Index film) const {
  return junction_rates_[Foam::size(foam.end(2 * film))] -
         junction_rates_[Foam::size(foam.start(2 * film))];
}

void Motion::bring_junction(Foam& foam, Index junction, double now) {
  const auto i = Foam::size(junction);
  foam.position[i] += (now - junction_time_[i]) * junction_rates_[i];
  junction_time_[i] = now;
}

void Motion::bring_film(Foam& foam, Index film, double now) {
  const auto i = Foam::size(film);
  foam.film_angle[i] += (now - film_time_[i]) * angle_rates_[i];
  film_time_[i] = now;
}

void Motion::bring_bubble(Foam& foam, Index bubble, double now) {
  const auto i = Foam::size(bubble);
  const double elapsed = now - bubble_time_[i];
  foam.pressure[i] += elapsed * pressure_rates_[i];
  foam.target_area[i] += elapsed * area_rates_[i];
  bubble_time_[i] = now;
}

} // namespace foam
