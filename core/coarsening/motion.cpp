// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarsening/motion.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace foam {

template <class Element, class Value>
void Motion::Trajectory<Element, Value>::begin(std::size_t count, double now) {
  rate.resize(count);
  steady.resize(count, 0);
  bend.assign(count, {});
  time.assign(count, now);
}

template <class Element, class Value>
void Motion::Trajectory<Element, Value>::take_whole(Element e, const Value& new_rate,
                                                    double bends) {
  bend[e] = steady[e] ? bends * (new_rate - rate[e]) : Value{};
  rate[e] = new_rate;
  steady[e] = 1;
}

template <class Element, class Value>
void Motion::Trajectory<Element, Value>::take_patch(Element e, const Value& new_rate) {
  bend[e] = {};
  rate[e] = new_rate;
  steady[e] = 0;
}

template <class Element, class Value> void Motion::Trajectory<Element, Value>::rest() {
  rate.assign(rate.size(), {});
  bend.assign(bend.size(), {});
  steady.assign(steady.size(), 0);
}

template <class Element, class Value>
void Motion::Trajectory<Element, Value>::bring(Field<Element, Value>& values, Element e,
                                               double now) {
  values[e] += (now - time[e]) * rate[e];
  time[e] = now;
}

template <class Element, class Value>
std::span<const Value> Motion::Trajectory<Element, Value>::expected() {
  ahead.resize(rate.size());
  std::ranges::transform(rate, bend, ahead.begin(), std::plus<>());
  return ahead;
}

void Motion::begin(const Foam& foam, Field<Bubble, double> area_rates, double now) {
  junctions_.begin(foam.position.size(), now);
  angles_.begin(foam.film_angle.size(), now);
  pressures_.begin(foam.pressure.size(), now);
  area_bends_.assign(area_rates.size(), 0);
  area_rates_ = std::move(area_rates);
  begin_ = now;
  if (foam.surroundings.has_walls()) { // what has come to a wall since may have been moving
    for (const Bubble b : foam.bubble_slots()) {
      if (foam.has_bubble(b)) {
        hold_wall(foam, b);
      }
    }
  }
}

void Motion::take_whole(const Region& region, const newton::StepView& response, double bend) {
  for (const Junction j : region.junctions) {
    junctions_.take_whole(j, response.junction[j], bend);
  }
  for (const Film f : region.films) {
    angles_.take_whole(f, response.angle[f], bend);
  }
  for (const Bubble b : region.bubbles) {
    pressures_.take_whole(b, response.pressure[b], bend);
  }
}

void Motion::take_patch(const Region& region, const newton::StepView& response) {
  for (const Junction j : region.junctions) {
    junctions_.take_patch(j, response.junction[j]);
  }
  for (const Film f : region.films) {
    angles_.take_patch(f, response.angle[f]);
  }
  for (const Bubble b : region.bubbles) {
    pressures_.take_patch(b, response.pressure[b]);
  }
}

void Motion::rest() {
  junctions_.rest();
  angles_.rest();
  pressures_.rest();
}

void Motion::hold_wall(const Foam& foam, Bubble bubble) {
  for_each_half(foam, bubble, [&](Half h) {
    if (foam.wall(h)) {
      angles_.take_patch(h.film(), 0);
      for (const Junction end : {foam.start(h), foam.end(h)}) {
        if (!foam.freedom(end).any()) {
          junctions_.take_patch(end, {});
        }
      }
    }
  });
}

void Motion::bring(Foam& foam, std::span<const Bubble> bubbles, double now) {
  for (const Bubble b : bubbles) {
    bring_bubble(foam, b, now);
    for_each_half(foam, b, [&](Half h) {
      angles_.bring(foam.film_angle, h.film(), now);
      bring_junction(foam, foam.start(h), now);
    });
  }
}

void Motion::bring_all(Foam& foam, double now) {
  for (const Junction j : foam.junction_slots()) {
    bring_junction(foam, j, now);
  }
  for (const Film f : foam.film_slots()) {
    angles_.bring(foam.film_angle, f, now);
  }
  for (const Bubble b : foam.bubble_slots()) {
    bring_bubble(foam, b, now);
  }
}

/// x + ẋ·t + ½ẍ·t², ẍ·t being the bend.
void Motion::finish(Foam& foam, double now) {
  bring_all(foam, now);
  const double half = 0.5 * (now - begin_);
  for (const Junction j : foam.junction_slots()) {
    foam.displace(j, foam.position[j], half * junctions_.bend[j]);
  }
  for (const Film f : foam.film_slots()) {
    foam.film_angle[f] += half * angles_.bend[f];
  }
  for (const Bubble b : foam.bubble_slots()) {
    foam.pressure[b] += half * pressures_.bend[b];
  }
}

Rates Motion::expected() {
  return {junctions_.expected(), angles_.expected(), pressures_.expected()};
}

double Motion::relative_growth(const Foam& foam, Film film) const {
  const Half h = film.half();
  return foam.relative_growth(h, junctions_.rate[foam.start(h)], junctions_.rate[foam.end(h)]);
}

Vec2 Motion::chord_rate(const Foam& foam, Film film) const {
  return junctions_.rate[foam.end(film.half())] - junctions_.rate[foam.start(film.half())];
}

void Motion::bring_junction(Foam& foam, Junction junction, double now) {
  const double time = now - junctions_.time[junction];
  foam.displace(junction, foam.position[junction], time * junctions_.rate[junction]);
  junctions_.time[junction] = now;
}

void Motion::bring_bubble(Foam& foam, Bubble bubble, double now) {
  const double before = pressures_.time[bubble];
  const double middle = 0.5 * ((before - begin_) + (now - begin_));
  foam.target_area[bubble] += (now - before) * (area_rates_[bubble] + middle * area_bends_[bubble]);
  pressures_.bring(foam.pressure, bubble, now);
}

} // namespace foam
