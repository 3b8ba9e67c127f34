// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/neighbourhood.h"

#include "base/sort_unique.h"

namespace foam {

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

} // namespace foam
