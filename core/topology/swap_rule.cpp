// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/swap_rule.h"

#include <algorithm>

namespace foam {

namespace {

bool ends_on_wall(const Foam& foam, Index film) {
  return foam.pinned(foam.start(2 * film)) || foam.pinned(foam.end(2 * film));
}

} // namespace

bool spares_sides(const Foam& foam, Index film) {
  const Index needed = ends_on_wall(foam, film) ? 3 : 4;
  const auto spares = [&](Index b) { return b == kWorld || foam.sides[Foam::size(b)] >= needed; };
  return spares(foam.left(2 * film)) && spares(foam.right(2 * film));
}

bool pulled_shut(const Foam& foam, Index film) {
  const Index h = 2 * film;
  const Index t = h + 1;
  if (ends_on_wall(foam, film)) {
    return true;
  }
  const Vec2 t1 = foam.tangent(foam.next_around_junction(h));
  const Vec2 t2 = foam.tangent(foam.previous_around_junction(h));
  const Vec2 t3 = foam.tangent(foam.next_around_junction(t));
  const Vec2 t4 = foam.tangent(foam.previous_around_junction(t));
  const double across = std::min(norm(t1 + t4), norm(t2 + t3));
  const double along = std::max(norm(t1 + t2), norm(t3 + t4));
  return across > std::max(1.0, along);
}

} // namespace foam
