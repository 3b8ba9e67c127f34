// SPDX-License-Identifier: GPL-3.0-or-later
#include "thesis/algorithms.h"

#include <algorithm>
#include <array>

#include "topology/collapse.h"

namespace foam {
namespace {

constexpr int kMostSwaps = 3;

/// Removes the first bubble around the junction that gives way, or else swaps the first film.
bool collapse_around(const Foam& foam, Collapse& collapse, Index junction) {
  const std::array<Index, 3> halves = foam.junction_half[Foam::size(junction)];
  return std::ranges::any_of(halves,
                             [&](Index h) {
                               const Index b = foam.left(h);
                               return b != kWorld && collapse.bubble(b).performed;
                             }) ||
         std::ranges::any_of(halves,
                             [&](Index h) { return collapse.film(Foam::film_of(h)).performed; });
}

} // namespace

CascadeResult original_algorithm(Foam& foam, const CollapseRules& rules,
                                 const std::function<void(Foam&, Index)>& equilibrate) {
  Collapse collapse(foam, rules);
  for (Index j = 0; j < foam.junction_capacity(); ++j) {
    if (foam.has_junction(j) && !collapse_around(foam, collapse, j)) {
      equilibrate(foam, j);
    }
  }
  return std::move(collapse).result();
}

CascadeResult improved_algorithm(Foam& foam, const CollapseRules& rules) {
  Collapse collapse(foam, rules);
  std::vector<int> swaps(foam.film_angle.size(), 0);
  bool again = true;
  while (again) {
    again = false;
    for (Index b = 0; b < foam.bubble_capacity(); ++b) {
      again = collapse.bubble(b).performed || again;
    }
    for (Index f = 0; f < foam.film_capacity(); ++f) {
      if (swaps[Foam::size(f)] < kMostSwaps && collapse.film(f).performed) {
        ++swaps[Foam::size(f)];
        again = true;
      }
    }
  }
  return std::move(collapse).result();
}

} // namespace foam
