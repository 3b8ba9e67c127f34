// SPDX-License-Identifier: GPL-3.0-or-later
#include "thesis/algorithms.h"

#include <algorithm>
#include <array>

#include "topology/collapse.h"

namespace foam {
namespace {

constexpr int kMostSwaps = 3;

/// Removes the first bubble around the junction that gives way, or else swaps the first film.
bool collapse_around(const Foam& foam, Collapse& collapse, Junction junction) {
  const std::array<Half, 3> halves = foam.junction_half[junction];
  return std::ranges::any_of(halves,
                             [&](Half h) {
                               const Bubble b = foam.left(h);
                               return !b.is_outside() && collapse.bubble(b).performed;
                             }) ||
         std::ranges::any_of(halves, [&](Half h) { return collapse.film(h.film()).performed; });
}

} // namespace

CascadeResult original_algorithm(Foam& foam, const CollapseRules& rules,
                                 const std::function<void(Foam&, Junction)>& equilibrate) {
  Collapse collapse(foam, rules);
  for (const Junction j : foam.junction_slots()) {
    if (foam.has_junction(j) && !collapse_around(foam, collapse, j)) {
      equilibrate(foam, j);
    }
  }
  return std::move(collapse).result();
}

CascadeResult improved_algorithm(Foam& foam, const CollapseRules& rules) {
  Collapse collapse(foam, rules);
  Field<Film, int> swaps(foam.film_angle.size(), 0);
  bool again = true;
  while (again) {
    again = false;
    for (const Bubble b : foam.bubble_slots()) {
      again = collapse.bubble(b).performed || again;
    }
    for (const Film f : foam.film_slots()) {
      if (swaps[f] < kMostSwaps && collapse.film(f).performed) {
        ++swaps[f];
        again = true;
      }
    }
  }
  return std::move(collapse).result();
}

} // namespace foam
