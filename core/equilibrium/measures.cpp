// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include "equilibrium/equilibrator.h"
#include "mesh/element_measures.h"
#include "parallel/host.h"

namespace foam {
namespace {

/// The largest of error(e) for all elements e, and 0.
template <class Element, class Error> double largest(Slots<Element> slots, const Error& error) {
  std::vector<double> errors(place_of(slots.size()) + 1);
  Host().for_each(slots, [&](Element e) { errors[e.place()] = error(e); });
  return std::ranges::max(errors);
}

} // namespace

double max_angle_error(const Foam& foam) {
  return largest(foam.junction_slots(),
                 [&](Junction j) { return foam.moves(j) ? angle_error(foam, j) : 0; });
}

double max_area_error(const Foam& foam) {
  return largest(foam.bubble_slots(),
                 [&](Bubble b) { return foam.has_bubble(b) ? area_error(foam, b) : 0; });
}

} // namespace foam
