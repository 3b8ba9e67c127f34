// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/unknowns.h"

#include <algorithm>

namespace foam {

void Unknowns::number(const Foam& foam, const Region& region, std::span<const char> keep_angle) {
  junctions_.clear(foam.position.size());
  bubbles_.clear(foam.pressure.size());
  angles_.clear(foam.film_angle.size());
  count_ = 0;
  for (const Junction j : region.junctions) {
    junctions_.put(j, count_);
    count_ += 2;
  }
  first_pressure_ = count_;
  for (const Bubble b : region.bubbles) {
    bubbles_.put(b, count_++);
  }
  first_angle_ = count_;
  for (std::size_t i = 0; i < region.films.size(); ++i) {
    if (keep_angle[i]) {
      angles_.put(region.films[i], count_++);
    }
  }
}

FilmLagrangian::Each<Index> Unknowns::of_film(const Foam& foam, Film film) const {
  const Half h = film.half();
  const Index a = junctions_.at(foam.start(h));
  const Index b = junctions_.at(foam.end(h));
  const auto pressure = [&](Bubble bubble) {
    return bubble.is_outside() ? Index{kNone} : bubbles_.at(bubble);
  };
  return {a,
          a == kNone ? kNone : a + 1,
          b,
          b == kNone ? kNone : b + 1,
          pressure(foam.left(h)),
          pressure(foam.right(h)),
          angles_.at(film)};
}

std::vector<FilmLagrangian::Each<Index>> Unknowns::of_films(const Foam& foam,
                                                            std::span<const Film> films) const {
  std::vector<FilmLagrangian::Each<Index>> numbers(films.size());
  std::ranges::transform(films, numbers.begin(), [&](Film f) { return of_film(foam, f); });
  return numbers;
}

} // namespace foam
