// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/foam.h"
#include "topology/operations.h"

namespace foam::test {

/// Swaps films of a foam until many of its bubbles have two sides, so that two films are between
/// the neighbours of each.
inline Foam with_two_sided_bubbles(Foam foam) {
  for (int pass = 0; pass < 3; ++pass) {
    for (const Film f : foam.film_slots()) {
      const auto few = [&](Bubble b) { return !b.is_outside() && foam.sides[b] <= 5; };
      if (can_perform_t1(foam, f) && few(foam.left(f.half())) != few(foam.right(f.half()))) {
        perform_t1(foam, f);
      }
    }
  }
  return foam;
}

} // namespace foam::test
