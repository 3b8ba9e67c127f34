// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/obstacle.h"

#include <cmath>
#include <utility>

#include "base/number.h"
#include "mesh/element_measures.h"

namespace foam {
namespace {

using std::to_string;

constexpr double kNothing = 1e-2; // of the mean spacing: so short is a film that has shrunk to it

/// The element with the largest error(e), and that error; 0 of none.
template <class Element, class Error>
std::pair<Element, double> worst(Slots<Element> slots, const Error& error) {
  std::pair<Element, double> found{kNone, 0};
  for (const Element e : slots) {
    if (const double size = error(e); !(size <= found.second)) {
      found = {e, size};
    }
  }
  return found;
}

double imbalance(const Foam& foam, Junction junction) {
  return foam.moves(junction) ? norm(force_imbalance(foam, junction)) / foam.reference_tension()
                              : 0;
}

/// |2 sin α − q·d/T|
double misfit(const Foam& foam, Film film) {
  const Half h = film.half();
  return foam.bends(film)
             ? std::abs(2 * std::sin(foam.half_angle(h)) -
                        foam.pressure_difference(h) * norm(foam.chord(h)) / foam.tension(film))
             : 0;
}

std::string name_of(const Foam& foam, Bubble bubble) {
  return bubble.is_outside() ? "the outside" : "bubble " + to_string(foam.bubble_id[bubble]);
}

std::string between(const Foam& foam, Film film) {
  return "between " + name_of(foam, foam.left(film.half())) + " and " +
         name_of(foam, foam.right(film.half()));
}

std::string of_junction(const Foam& foam, Junction junction, double force) {
  std::string text = "junction " + to_string(junction.index()) + " at " +
                     number(foam.position[junction]) + " is pulled by its films with " +
                     number(force) + " tensions";
  for (const Half h : foam.junction_half[junction]) {
    if (foam.bends(h.film()) && foam.length(h) < kNothing * foam.mean_spacing()) {
      text += ", and the film " + between(foam, h.film()) + " has shrunk to " +
              number(foam.length(h)) + " cm";
      text += foam.moves(foam.end(h)) ? "" : " at the wall, which holds its end";
    }
  }
  return text;
}

std::string of_bubble(const Foam& foam, Bubble bubble) {
  int held = 0;
  for_each_half(foam, bubble, [&](Half h) { held += foam.moves(foam.start(h)) ? 0 : 1; });
  return name_of(foam, bubble) + " of " + to_string(foam.sides[bubble]) + " sides" +
         (held > 0 ? ", " + to_string(held) + " of its corners held by the wall," : "") +
         " has the area " + number(foam.area(bubble)) + " in place of " +
         number(foam.target_area[bubble]) + " cm²";
}

std::string of_film(const Foam& foam, Film film) {
  const Half h = film.half();
  return "the film " + between(foam, film) + " has the half-angle " + number(foam.half_angle(h)) +
         " rad, which their pressures do not hold";
}

} // namespace

std::string obstacle(const Foam& foam) {
  const auto [junction, force] =
      worst(foam.junction_slots(), [&](Junction j) { return imbalance(foam, j); });
  const auto [film, bend] = worst(foam.film_slots(), [&](Film f) { return misfit(foam, f); });
  const auto [bubble, area] = worst(
      foam.bubble_slots(), [&](Bubble b) { return foam.has_bubble(b) ? area_error(foam, b) : 0; });
  if (area > force && area > bend) {
    return of_bubble(foam, bubble);
  }
  if (bend > force) {
    return of_film(foam, film);
  }
  return junction == kNone ? "nothing stands in the way" : of_junction(foam, junction, force);
}

} // namespace foam
