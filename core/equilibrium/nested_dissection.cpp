// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/nested_dissection.h"

#include <span>

#include "algebra/dissection.h"

namespace foam {
namespace {

/// Where each unknown is eliminated.
std::vector<TreePlace> places_of(const Foam& foam, const Region& region, const Unknowns& unknowns,
                                 int levels) {
  std::vector<Vec2> positions;
  positions.reserve(region.junctions.size());
  for (const Junction j : region.junctions) {
    positions.push_back(foam.position[j]);
  }
  const std::vector<TreePlace> leaf = bisect(positions, levels); // of each two coordinates
  std::vector<TreePlace> places(place_of(unknowns.count()), kNowhere);
  for (std::size_t i = 0; i < leaf.size(); ++i) {
    places[2 * i] = leaf[i];
  }
  const auto leaf_of = [&](Index x) { return x == kNone ? kNowhere : leaf[place_of(x) / 2]; };
  const auto at = [&](Index unknown) {
    return unknown == kNone ? kNowhere : places[place_of(unknown)];
  };
  const auto raise = [&](Index unknown, TreePlace place) {
    if (unknown != kNone) {
      places[place_of(unknown)] = place;
    }
  };
  const std::vector<FilmLagrangian::Each<Index>> films = unknowns.of_films(foam, region.films);
  for (const auto& [a, a_y, b, b_y, left, right, angle] : films) {
    const TreePlace cut = common(leaf_of(a), leaf_of(b));
    raise(left, common(at(left), cut));
    raise(right, common(at(right), cut));
    if (at(a) > cut && at(b) > cut) {
      raise(a, cut);
    }
  }
  for (Index pressure = unknowns.first_pressure(); pressure < unknowns.first_angle(); ++pressure) {
    raise(pressure, std::max(at(pressure), kRoot)); // no junction of it moves
  }
  for (const auto& [a, a_y, b, b_y, left, right, angle] : films) {
    raise(a_y, at(a));
    raise(b_y, at(b));
    const TreePlace both = common(at(left), at(right));
    if (at(left) > both && at(right) > both) { // they share no junction that moves
      raise(left, both);
    }
  }
  for (const FilmLagrangian::Each<Index>& film : films) {
    TreePlace place = kNowhere;
    for (const Index u : std::span(film).first(6)) {
      place = upper(place, at(u));
    }
    raise(film.back(), place);
  }
  return places;
}

} // namespace

EliminationTree nested_dissection(const Foam& foam, const Region& region,
                                  const Unknowns& unknowns) {
  const int levels = levels_for(region.junctions.size());
  return elimination_tree(places_of(foam, region, unknowns, levels), levels);
}

} // namespace foam
