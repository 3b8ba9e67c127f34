// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/domain.h"

#include <algorithm>
#include <cmath>

namespace foam {
namespace {

template <class Element> void sort_unique(std::vector<Element>& v) {
  std::ranges::sort(v);
  const auto tail = std::ranges::unique(v);
  v.erase(tail.begin(), tail.end());
}

double mean_spacing(const Foam& foam, std::span<const Bubble> bubbles) {
  double total = 0;
  for (const Bubble b : bubbles) {
    total += foam.target_area[b];
  }
  return bubbles.empty() ? 0 : std::sqrt(total / static_cast<double>(bubbles.size()));
}

} // namespace

Domain domain_of(const Region& region) {
  const auto elements = [](const auto& list) {
    return Elements(list.data(), static_cast<Index>(list.size()));
  };
  return {elements(region.junctions), elements(region.films), elements(region.bubbles),
          elements(region.rim),       region.whole,           region.spacing};
}

Region whole_foam(const Foam& foam) {
  Region region;
  region.whole = true;
  for (const Junction j : foam.junction_slots()) {
    if (foam.moves(j)) {
      region.junctions.push_back(j);
    }
  }
  for (const Film f : foam.film_slots()) {
    if (foam.bends(f)) {
      region.films.push_back(f);
    }
  }
  for (const Bubble b : foam.bubble_slots()) {
    if (foam.has_bubble(b)) {
      region.bubbles.push_back(b);
    }
  }
  region.spacing = mean_spacing(foam, region.bubbles);
  return region;
}

std::vector<Bubble> rings_around(const Foam& foam, std::span<const Bubble> bubbles, int rings) {
  std::vector<Bubble> inside(bubbles.begin(), bubbles.end());
  std::erase_if(inside, [&](Bubble b) { return b.is_outside() || !foam.has_bubble(b); });
  sort_unique(inside);
  for (int ring = 0; ring < rings; ++ring) {
    for (std::size_t i = 0, n = inside.size(); i < n; ++i) {
      for_each_half(foam, inside[i], [&](Half h) {
        if (!foam.right(h).is_outside()) {
          inside.push_back(foam.right(h));
        }
      });
    }
    sort_unique(inside);
  }
  return inside;
}

Region patch(const Foam& foam, std::span<const Bubble> bubbles, int rings) {
  const std::vector<Bubble> inside = rings_around(foam, bubbles, rings);
  Region region;
  for (const Bubble b : inside) {
    for_each_half(foam, b, [&](Half h) {
      const Junction j = foam.start(h);
      if (foam.freedom(j).any()) {
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
  region.spacing = mean_spacing(foam, region.bubbles);
  return region;
}

} // namespace foam
