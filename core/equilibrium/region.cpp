// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/region.h"

#include <algorithm>
#include <cmath>

namespace foam {
namespace {

void sort_unique(std::vector<Index>& v) {
  std::ranges::sort(v);
  const auto tail = std::ranges::unique(v);
  v.erase(tail.begin(), tail.end());
}

double mean_spacing(const Foam& foam, std::span<const Index> bubbles) {
  double total = 0;
  for (const Index b : bubbles) {
    total += foam.target_area[Foam::size(b)];
  }
  return bubbles.empty() ? 0 : std::sqrt(total / static_cast<double>(bubbles.size()));
}

} // namespace

Region whole_foam(const Foam& foam) {
  Region region;
  region.whole = true;
  for (Index j = 0; j < foam.junction_capacity(); ++j) {
    if (foam.has_junction(j) && !foam.pinned(j)) {
      region.junctions.push_back(j);
    }
  }
  for (Index f = 0; f < foam.film_capacity(); ++f) {
    if (foam.has_film(f) && !foam.wall(2 * f)) {
      region.films.push_back(f);
    }
  }
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    if (foam.has_bubble(b)) {
      region.bubbles.push_back(b);
    }
  }
  region.spacing = mean_spacing(foam, region.bubbles);
  return region;
}

std::vector<Index> rings_around(const Foam& foam, std::span<const Index> bubbles, int rings) {
  std::vector<Index> inside(bubbles.begin(), bubbles.end());
  std::erase_if(inside, [&](Index b) { return b == kWorld || !foam.has_bubble(b); });
  sort_unique(inside);
  for (int ring = 0; ring < rings; ++ring) {
    for (std::size_t i = 0, n = inside.size(); i < n; ++i) {
      for_each_half(foam, inside[i], [&](Index h) {
        if (foam.right(h) != kWorld) {
          inside.push_back(foam.right(h));
        }
      });
    }
    sort_unique(inside);
  }
  return inside;
}

Region patch(const Foam& foam, std::span<const Index> bubbles, int rings) {
  const std::vector<Index> inside = rings_around(foam, bubbles, rings);
  Region region;
  for (const Index b : inside) {
    for_each_half(foam, b, [&](Index h) {
      const Index j = foam.start(h);
      if (!foam.pinned(j)) {
        region.junctions.push_back(j);
      }
    });
  }
  sort_unique(region.junctions);
  for (const Index j : region.junctions) {
    for (const Index h : foam.junction_half[Foam::size(j)]) {
      if (foam.left(h) != kWorld) {
        region.bubbles.push_back(foam.left(h));
      }
    }
  }
  sort_unique(region.bubbles);
  for (const Index b : region.bubbles) {
    for_each_half(foam, b, [&](Index h) {
      if (!foam.wall(h)) {
        region.films.push_back(Foam::film_of(h));
      }
      const Index across = foam.right(h);
      if (across != kWorld && !std::ranges::binary_search(region.bubbles, across)) {
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
