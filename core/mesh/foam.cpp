// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/foam.h"

#include <algorithm>

#include "mesh/element_measures.h"

namespace foam {

Index Foam::bubble_count() const {
  return static_cast<Index>(
      std::count_if(bubble_half.begin(), bubble_half.end(), [](Index h) { return h != kNone; }));
}

Index Foam::film_count() const {
  return static_cast<Index>(std::count_if(half_junction.begin(), half_junction.end(),
                                          [](Index j) { return j != kNone; })) /
         2;
}

Index Foam::junction_count() const {
  return static_cast<Index>(std::count_if(junction_half.begin(), junction_half.end(),
                                          [](const auto& h) { return h[0] != kNone; }));
}

double Foam::energy() const {
  double total = 0;
  for (Index f = 0; f < film_capacity(); ++f) {
    total += tense_length(*this, f);
  }
  return 2 * surface_tension * total;
}

double Foam::mean_spacing() const {
  double total = 0;
  Index count = 0;
  for (Index b = 0; b < bubble_capacity(); ++b) {
    if (has_bubble(b)) {
      total += target_area[size(b)];
      ++count;
    }
  }
  return std::sqrt(total / std::max(count, Index{1}));
}

void Foam::resize(Index bubbles, Index films, Index junctions) {
  bubble_half.assign(size(bubbles), kNone);
  sides.assign(size(bubbles), 0);
  pressure.assign(size(bubbles), 0.0);
  target_area.assign(size(bubbles), 0.0);
  bubble_id.assign(size(bubbles), 0);
  half_junction.assign(size(2 * films), kNone);
  half_bubble.assign(size(2 * films), kWorld);
  film_angle.assign(size(films), 0.0);
  film_wrap.assign(size(films), Wrap{});
  position.assign(size(junctions), Vec2{});
  junction_half.assign(size(junctions), {kNone, kNone, kNone});
}

} // namespace foam
