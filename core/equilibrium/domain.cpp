// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/domain.h"

#include <algorithm>

#include "base/sort_unique.h"
#include "mesh/neighbourhood.h"
#include "parallel/host.h"

namespace foam {

Domain domain_of(const Region& region) {
  return {region.junctions, region.films, region.bubbles, region.rim, region.whole, region.spacing};
}

Region whole_foam(const Foam& foam) {
  Region region;
  region.whole = true;
  const auto list = [](auto slots, const auto& counts, auto& to) {
    for (const auto element : slots) {
      if (counts(element)) {
        to.push_back(element);
      }
    }
  };
  list(
      foam.junction_slots(), [&](Junction j) { return foam.moves(j); }, region.junctions);
  list(
      foam.film_slots(), [&](Film f) { return foam.bends(f); }, region.films);
  list(
      foam.bubble_slots(), [&](Bubble b) { return foam.has_bubble(b); }, region.bubbles);
  Host host;
  region.spacing = mean_spacing(host, view_of(foam), Elements(region.bubbles));
  return region;
}

Region patch(const Foam& foam, std::span<const Bubble> bubbles, int rings) {
  const std::vector<Bubble> inside = rings_around(foam, bubbles, rings);
  Region region;
  for (const Bubble b : inside) {
    for_each_half(foam, b, [&](Half h) {
      const Junction j = foam.start(h);
      if (foam.moves(j)) {
        region.junctions.push_back(j);
      }
    });
  }
  sort_unique(region.junctions);
  for (const Junction j : region.junctions) {
    for (const Half h : foam.junction_half[j]) {
      if (!foam.left(h).is_outside()) {
        region.bubbles.push_back(foam.left(h));
      }
    }
  }
  sort_unique(region.bubbles);
  for (const Bubble b : region.bubbles) {
    for_each_half(foam, b, [&](Half h) {
      if (!foam.wall(h)) {
        region.films.push_back(h.film());
      }
      const Bubble across = foam.right(h);
      if (!across.is_outside() && !std::ranges::binary_search(region.bubbles, across)) {
        region.rim.push_back(across);
      }
    });
  }
  sort_unique(region.films);
  sort_unique(region.rim);
  Host host;
  region.spacing = mean_spacing(host, view_of(foam), Elements(region.bubbles));
  return region;
}

} // namespace foam
