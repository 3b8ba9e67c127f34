// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/swap_rule.h"

#include <algorithm>

namespace foam {

bool pulled_shut(const Foam& foam, Index film) {
  const Index h = 2 * film;
  const Index t = h + 1;
  if (foam.pinned(foam.start(h)) || foam.pinned(foam.end(h))) {
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
