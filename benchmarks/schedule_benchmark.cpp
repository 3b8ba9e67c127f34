// SPDX-License-Identifier: GPL-3.0-or-later
//
// How many steps in a row the parallel schedules take, which does not depend on the machine: waves
// of junctions that move at once, and rounds of topological operations. Writes tables in Markdown.
#include <iostream>
#include <vector>

#include "construct/honeycomb.h"
#include "parallel/host.h"
#include "thesis/rules.h"
#include "thesis/update_order.h"
#include "topology/collapse_operations.h"
#include "topology/operations.h"

namespace foam {
namespace {

/// Rounds of reservations until nothing gives way.
int rounds(Host& host, Foam& foam, const ThesisRules& rules) {
  Field<Film, std::uint8_t> swappable(foam.film_angle.size(), 1);
  Reservations<Host> reservations(host);
  int rounds = 0;
  const CollapseOperations operations{rules, FieldView<Film, std::uint8_t>(swappable.data())};
  do {
    ++rounds;
  } while (reservations.round(view_of(foam), operations) > 0);
  note_performed(foam, reservations.take_performed());
  return rounds;
}

void measure(Index columns) {
  Foam foam = honeycomb({.columns = columns, .rows = columns, .displacement = 0.15, .swaps = 0.2});
  Host host;
  thesis::UpdateOrder<Host> order(host);
  std::cout << "| " << columns * columns;
  for (const int reach : {1, 2}) {
    order.find(const_view(view_of(foam)), reach);
    std::cout << " | " << order.waves();
  }
  const int needed = rounds(host, foam, {.limit = {.t1_length = 0.35, .t2_area = 0.05}});
  std::cout << " | " << foam.t1_count << " | " << needed << " |" << std::endl;
}

} // namespace
} // namespace foam

int main() {
  std::cout
      << "| bubbles | waves with EnergyDecay | waves with OrientationInvariant | T1s | rounds "
         "|\n|--|--|--|--|--|\n";
  for (const foam::Index columns : {32, 100, 316, 1000}) {
    foam::measure(columns);
  }
}
