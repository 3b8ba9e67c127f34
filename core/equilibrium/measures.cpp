// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <vector>

#include "equilibrium/equilibrator.h"
#include "mesh/element_measures.h"
#include "parallel/host.h"

namespace foam {
namespace {

/// The largest of error(i) for all i in [0, count), and 0.
template <class Error> double largest(Index count, const Error& error) {
  std::vector<double> errors(Foam::size(count) + 1);
  Host().for_each(count, [&](Index i) { errors[Foam::size(i)] = error(i); });
  return std::ranges::max(errors);
}

} // namespace

double max_angle_error(const Foam& foam) {
  return largest(foam.junction_capacity(), [&](Index j) {
    return foam.has_junction(j) && !foam.pinned(j) ? angle_error(foam, j) : 0;
  });
}

double max_area_error(const Foam& foam) {
  return largest(foam.bubble_capacity(),
                 [&](Index b) { return foam.has_bubble(b) ? area_error(foam, b) : 0; });
}

} // namespace foam
