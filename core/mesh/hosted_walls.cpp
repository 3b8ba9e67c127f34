// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/hosted_walls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "base/error.h"
#include "geometry/winding.h"

namespace foam {
namespace {

/// A bubble's outline, counter-clockwise, in one piece.
std::vector<WallPiece> outline_of(const Foam& foam, Bubble bubble) {
  std::vector<WallPiece> outline;
  Vec2 at = foam.position[foam.start(foam.bubble_half[bubble])];
  for_each_half(foam, bubble, [&](Half h) {
    if (foam.wall(h)) {
      foam.for_each_wall_part(h, [&](const WallPiece& part, double /*corner*/) {
        outline.push_back({at, part.chord, part.half_angle});
        at += part.chord;
      });
    } else {
      outline.push_back({at, foam.chord(h), foam.half_angle(h)});
      at += foam.chord(h);
    }
  });
  return outline;
}

/// Whether a bubble, or an image of it, lies round a point.
bool encloses(const Foam& foam, Bubble bubble, Vec2 point) {
  const std::vector<WallPiece> outline = outline_of(foam, bubble);
  if (!foam.surroundings.has_images()) {
    return winding(outline, point) == 1;
  }
  double low = std::numeric_limits<double>::infinity();
  double high = -low;
  for (const WallPiece& arc : outline) {
    low = std::min(low, arc.start.x - arc.length());
    high = std::max(high, arc.start.x + arc.length());
  }
  const double period = foam.surroundings.lattice.first.x;
  bool found = false;
  for (double k = std::ceil((low - point.x) / period); k <= (high - point.x) / period; ++k) {
    found = found || winding(outline, point + Vec2{k * period, 0}) == 1;
  }
  return found;
}

Bubble host_of(const Foam& foam, Outside wall) {
  const Vec2 point = foam.wall_piece[Piece(foam.exterior[wall].first_piece)].start;
  for (const Bubble b : foam.bubble_slots()) {
    if (foam.has_bubble(b) && encloses(foam, b, point)) {
      return b;
    }
  }
  throw FoamError("wall " + std::to_string(wall.index()) + " at " + number(point) +
                  ", on which no film ends, lies in no bubble");
}

} // namespace

double length_of_wall(const Foam& foam, Outside wall) {
  const Exterior& exterior = foam.exterior[wall];
  double sum = 0;
  for (Index i = 0; i < exterior.pieces; ++i) {
    sum += foam.wall_piece[Piece(exterior.first_piece + i)].length();
  }
  return sum;
}

bool has_obstacles(const Foam& foam) {
  bool found = false;
  for (const Outside wall : foam.outside_slots()) {
    found = found || (foam.exterior[wall].pieces > 1 && foam.area_of_wall(wall) < 0);
  }
  return found;
}

void house_walls(Foam& foam) {
  Field<Outside, char> touched(foam.exterior.size(), 0);
  Index unused_films = foam.film_slots().size() - foam.film_count();
  Index unused_junctions = foam.junction_slots().size() - foam.junction_count();
  for (const Half h : foam.half_slots()) {
    if (foam.start(h) != kNone && foam.left(h).is_outside()) {
      touched[foam.left(h).outside()] = 1;
    }
  }
  for (const Outside wall : foam.outside_slots()) {
    Exterior& exterior = foam.exterior[wall];
    exterior.host = kNone;
    if (exterior.kind == Exterior::Kind::Solid && !touched[wall]) {
      exterior.host = host_of(foam, wall);
      unused_films -= kFilmsOfContact;
      unused_junctions -= kJunctionsOfContact;
    }
  }
  foam.make_room(std::max(-unused_films, Index{0}), std::max(-unused_junctions, Index{0}));
}

} // namespace foam
