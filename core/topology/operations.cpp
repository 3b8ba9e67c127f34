// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/operations.h"

#include <cassert>

#include "mesh/validate.h"

namespace foam {
namespace {

/// Counts an operation that has just been performed.
void note(Foam& foam, std::int64_t& count) {
  ++count;
  ++foam.topology;
  assert(validate(foam).empty());
}

} // namespace

std::array<Bubble, 2> perform_t1(Foam& foam, Film film) {
  const auto losers = swap_film(foam, film);
  note(foam, foam.t1_count);
  return losers;
}

T2Result perform_t2(Foam& foam, Bubble bubble) {
  const T2Result result = remove_three_sided_bubble(foam, bubble);
  note(foam, foam.t2_count);
  return result;
}

std::array<Bubble, 2> perform_t3(Foam& foam, Bubble bubble) {
  const auto neighbours = remove_two_sided_bubble(foam, bubble);
  note(foam, foam.t3_count);
  return neighbours;
}

} // namespace foam
