// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/foam.h"

#include <algorithm>

#include "mesh/element_measures.h"

namespace foam {

Index Foam::bubble_count() const {
  return static_cast<Index>(std::ranges::count_if(bubble_half, [](Half h) { return h != kNone; }));
}

Index Foam::film_count() const {
  return static_cast<Index>(
             std::ranges::count_if(half_junction, [](Junction j) { return j != kNone; })) /
         2;
}

Index Foam::junction_count() const {
  return static_cast<Index>(
      std::ranges::count_if(junction_half, [](const auto& h) { return h[0] != kNone; }));
}

double Foam::energy() const {
  double total = 0;
  for (const Film f : film_slots()) {
    total += tense_length(*this, f);
  }
  return reference_tension() * total;
}

double Foam::mean_area() const {
  double total = 0;
  Index count = 0;
  for (const Bubble b : bubble_slots()) {
    if (has_bubble(b)) {
      total += target_area[b];
      ++count;
    }
  }
  return total / std::max(count, Index{1});
}

double Foam::mean_spacing() const {
  return std::sqrt(mean_area());
}

void Foam::clear(Index bubbles, Index films, Index junctions) {
  for_each_array(
      [&]<class Element, class T>(Field<Element, T>& field) {
        if constexpr (std::is_same_v<Element, Bubble>) {
          field.assign(static_cast<std::size_t>(bubbles), T{});
        } else if constexpr (std::is_same_v<Element, Film>) {
          field.assign(static_cast<std::size_t>(films), T{});
        } else if constexpr (std::is_same_v<Element, Half>) {
          field.assign(2 * static_cast<std::size_t>(films), T{});
        } else if constexpr (std::is_same_v<Element, Junction>) {
          field.assign(static_cast<std::size_t>(junctions), T{});
        }
      },
      *this);
  film_tension.clear();
}

void Foam::surround(const Surroundings& with) {
  surroundings = with;
  exterior.assign(with.periodic() ? 0 : 1, Exterior{});
  if (with.has_walls()) {
    exterior[kWorld.outside()].kind = Exterior::Kind::Solid;
  }
}

} // namespace foam
