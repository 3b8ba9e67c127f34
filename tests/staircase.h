// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>

#include "construct/containers.h"
#include "mesh/film_set.h"

namespace foam::test {

/// A double row of so many bubbles a row in a channel: a zig-zag of films at ±30° along it, from
/// whose corners films lead to the one wall and the other. In equilibrium where all areas are the
/// same. \param width of the channel, cm \param area of a bubble, cm²
inline Foam staircase(Index bubbles, double width, double area) {
  const Index corners = 2 * bubbles;
  const double step = area / width;
  const double high = 0.5 * step / std::sqrt(3.0); // of a corner over the middle
  const Container container = channel({0, corners * step, 0, width}, WallContact::Slip);
  FilmSet set;
  set.surface_tension = 0.5;
  set.surroundings.boundary = Boundary::Container;
  set.surroundings.lattice.first.x = container.period;
  for (const Wall& wall : container.walls) {
    Exterior exterior;
    exterior.kind = Exterior::Kind::Solid;
    exterior.contact = wall.contact;
    exterior.first_piece = static_cast<Index>(set.wall_pieces.size());
    exterior.pieces = static_cast<Index>(wall.pieces.size());
    set.exteriors.push_back(exterior);
    set.wall_pieces.insert(set.wall_pieces.end(), wall.pieces.begin(), wall.pieces.end());
  }
  const bool first_is_low = container.walls[0].pieces[0].chord.x > 0;
  const auto upper = [&](Index k) { return 2 * ((k + bubbles) % bubbles); };
  const auto lower = [&](Index k) { return upper(k) + 1; };
  for (Index i = 0; i < corners; ++i) {
    set.junctions.push_back({i * step, 0.5 * width + (i % 2 == 0 ? high : -high)});
    set.bubbles.push_back({i, 0, area});
  }
  for (Index i = 0; i < corners; ++i) {
    const bool up = i % 2 == 0;
    const Index k = i / 2;
    const Index contact = corners + i;
    set.junctions.push_back({i * step, up ? width : 0});
    const auto wrap_to = [&](Index to) { return Wrap{to / corners, 0}; };
    set.films.push_back(
        {i, (i + 1) % corners, upper(k), up ? lower(k - 1) : lower(k), 0, wrap_to(i + 1)});
    const Index next = corners + (i + 2) % corners;
    if (up) {
      set.films.push_back({i, contact, upper(k - 1), upper(k), 0, {}});
      set.films.push_back({next, contact, upper(k), first_is_low ? -2 : -1, 0, -wrap_to(i + 2)});
    } else {
      set.films.push_back({i, contact, lower(k), lower(k - 1), 0, {}});
      set.films.push_back({contact, next, lower(k), first_is_low ? -1 : -2, 0, wrap_to(i + 2)});
    }
  }
  return foam_of(set);
}

} // namespace foam::test
