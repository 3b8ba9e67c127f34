// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarsening/motion.h"

#include <algorithm>
#include <functional>
#include <utility>

namespace foam {

template <class Value> void Motion::Course<Value>::begin(std::size_t count, double now) {
  rate.resize(count);
  steady.resize(count, 0);
  bend.assign(count, {});
  time.assign(count, now);
}

template <class Value>
void Motion::Course<Value>::take_whole(Index i, const Value& new_rate, bool bends) {
  const auto k = Foam::size(i);
  bend[k] = bends && steady[k] ? new_rate - rate[k] : Value{};
  rate[k] = new_rate;
  steady[k] = 1;
}

template <class Value> void Motion::Course<Value>::take_patch(Index i, const Value& new_rate) {
  const auto k = Foam::size(i);
  bend[k] = {};
  rate[k] = new_rate;
  steady[k] = 0;
}

template <class Value> void Motion::Course<Value>::rest() {
  rate.assign(rate.size(), {});
  bend.assign(bend.size(), {});
  steady.assign(steady.size(), 0);
}

template <class Value> void Motion::Course<Value>::bring(Value& value, std::size_t i, double now) {
  value += (now - time[i]) * rate[i];
  time[i] = now;
}

template <class Value> std::span<const Value> Motion::Course<Value>::expected() {
  ahead.resize(rate.size());
  std::ranges::transform(rate, bend, ahead.begin(), std::plus<>());
  return ahead;
}

void Motion::begin(const Foam& foam, std::vector<double> area_rates, double now) {
  junctions_.begin(foam.position.size(), now);
  angles_.begin(foam.film_angle.size(), now);
  pressures_.begin(foam.pressure.size(), now);
  area_rates_ = std::move(area_rates);
  begin_ = now;
  if (foam.boundary == Boundary::Fixed) { // what has come to a wall since may have been moving
    for (Index b = 0; b < foam.bubble_capacity(); ++b) {
      if (foam.has_bubble(b)) {
        hold_wall(foam, b);
      }
    }
  }
}

void Motion::take_whole(const Region& region, const Step& response, bool bend) {
  for (std::size_t i = 0; i < region.junctions.size(); ++i) {
    junctions_.take_whole(region.junctions[i], response.junctions[i], bend);
  }
  for (std::size_t i = 0; i < region.films.size(); ++i) {
    angles_.take_whole(region.films[i], response.angles[i], bend);
  }
  for (std::size_t i = 0; i < region.bubbles.size(); ++i) {
    pressures_.take_whole(region.bubbles[i], response.pressures[i], bend);
  }
}

void Motion::take_patch(const Region& region, const Step& response) {
  for (std::size_t i = 0; i < region.junctions.size(); ++i) {
    junctions_.take_patch(region.junctions[i], response.junctions[i]);
  }
  for (std::size_t i = 0; i < region.films.size(); ++i) {
    angles_.take_patch(region.films[i], response.angles[i]);
  }
  for (std::size_t i = 0; i < region.bubbles.size(); ++i) {
    pressures_.take_patch(region.bubbles[i], response.pressures[i]);
  }
}

void Motion::rest() {
  junctions_.rest();
  angles_.rest();
  pressures_.rest();
}

void Motion::hold_wall(const Foam& foam, Index bubble) {
  for_each_half(foam, bubble, [&](Index h) {
    if (foam.wall(h)) {
      angles_.take_patch(Foam::film_of(h), 0);
      junctions_.take_patch(foam.start(h), {});
      junctions_.take_patch(foam.end(h), {});
    }
  });
}

void Motion::bring(Foam& foam, std::span<const Index> bubbles, double now) {
  for (const Index b : bubbles) {
    bring_bubble(foam, b, now);
    for_each_half(foam, b, [&](Index h) {
      const auto film = Foam::size(Foam::film_of(h));
      angles_.bring(foam.film_angle[film], film, now);
      const auto junction = Foam::size(foam.start(h));
      junctions_.bring(foam.position[junction], junction, now);
    });
  }
}

void Motion::bring_all(Foam& foam, double now) {
  for (std::size_t j = 0; j < foam.position.size(); ++j) {
    junctions_.bring(foam.position[j], j, now);
  }
  for (std::size_t f = 0; f < foam.film_angle.size(); ++f) {
    angles_.bring(foam.film_angle[f], f, now);
  }
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    bring_bubble(foam, b, now);
  }
}

/// x + ẋ·t + ½ẍ·t², ẍ·t being the bend.
void Motion::finish(Foam& foam, double now) {
  bring_all(foam, now);
  const double half = 0.5 * (now - begin_);
  for (std::size_t j = 0; j < foam.position.size(); ++j) {
    foam.position[j] += half * junctions_.bend[j];
  }
  for (std::size_t f = 0; f < foam.film_angle.size(); ++f) {
    foam.film_angle[f] += half * angles_.bend[f];
  }
  for (std::size_t b = 0; b < foam.pressure.size(); ++b) {
    foam.pressure[b] += half * pressures_.bend[b];
  }
}

Rates Motion::expected() {
  return {junctions_.expected(), angles_.expected(), pressures_.expected()};
}

Vec2 Motion::chord_rate(const Foam& foam, Index film) const {
  return junctions_.rate[Foam::size(foam.end(2 * film))] -
         junctions_.rate[Foam::size(foam.start(2 * film))];
}

void Motion::bring_bubble(Foam& foam, Index bubble, double now) {
  const auto i = Foam::size(bubble);
  foam.target_area[i] += (now - pressures_.time[i]) * area_rates_[i];
  pressures_.bring(foam.pressure[i], i, now);
}

} // namespace foam
