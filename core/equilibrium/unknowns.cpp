// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/unknowns.h"

namespace foam {

template <class Element> void Unknowns::Numbers<Element>::clear(std::size_t capacity) {
  for (const Element element : elements_) {
    numbers_[element] = kNone;
  }
  elements_.clear();
  numbers_.resize(capacity, kNone);
}

template <class Element> void Unknowns::Numbers<Element>::put(Element element, Index number) {
  elements_.push_back(element);
  numbers_[element] = number;
}

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
  const Index a = junction(foam.start(h));
  const Index b = junction(foam.end(h));
  return {a,
          a == kNone ? kNone : a + 1,
          b,
          b == kNone ? kNone : b + 1,
          bubble(foam.left(h)),
          bubble(foam.right(h)),
          angle(film)};
}

std::vector<Index> renumbering(const Region& region, const Unknowns& from, const Unknowns& to) {
  std::vector<Index> numbers(place_of(from.count()), kNone);
  const auto put = [&](Index number, Index other) {
    if (number != kNone) {
      numbers[place_of(number)] = other;
    }
  };
  for (const Junction j : region.junctions) {
    const Index x = from.junction(j);
    const Index other = to.junction(j);
    put(x, other);
    put(x == kNone ? kNone : x + 1, other == kNone ? kNone : other + 1);
  }
  for (const Bubble b : region.bubbles) {
    put(from.bubble(b), to.bubble(b));
  }
  for (const Film f : region.films) {
    put(from.angle(f), to.angle(f));
  }
  return numbers;
}

} // namespace foam
