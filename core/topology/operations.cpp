// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/operations.h"

#include <cassert>

#include "mesh/validate.h"

namespace foam {
namespace {

void note(Foam& foam, const TopologicalOperation& performed) {
  note_performed(foam, performed);
  assert(validate(foam).empty());
}

} // namespace

std::int64_t& count_of(FoamRecord& record, TopologicalOperation::Kind kind) {
  using Kind = TopologicalOperation::Kind;
  return kind == Kind::T1 ? record.t1_count : kind == Kind::T2 ? record.t2_count : record.t3_count;
}

void note_performed(Foam& foam, TopologicalOperation performed) {
  performed.time = foam.time;
  performed.strain = foam.strain;
  ++count_of(foam, performed.kind);
  ++foam.topology;
  foam.operations.push_back(performed);
}

void note_performed(Foam& foam, std::span<const TopologicalOperation> performed) {
  for (const TopologicalOperation& operation : performed) {
    note_performed(foam, operation);
  }
}

std::array<Bubble, 2> perform_t1(Foam& foam, Film film) {
  const TopologicalOperation swap = swap_of(foam, film);
  const auto losers = swap_film(foam, film);
  note(foam, swap);
  return losers;
}

T2Result perform_t2(Foam& foam, Bubble bubble) {
  const TopologicalOperation removal = removal_of(foam, bubble);
  const T2Result result = remove_three_sided_bubble(foam, bubble);
  note(foam, removal);
  return result;
}

std::array<Bubble, 2> perform_t3(Foam& foam, Bubble bubble) {
  const TopologicalOperation removal = removal_of(foam, bubble);
  const auto neighbours = remove_two_sided_bubble(foam, bubble);
  note(foam, removal);
  return neighbours;
}

} // namespace foam
