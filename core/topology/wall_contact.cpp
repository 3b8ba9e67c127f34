// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/wall_contact.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cmath>
#include <numbers>

#include "mesh/hosted_walls.h"
#include "mesh/validate.h"
#include "topology/local_operations.h"
#include "topology/operations.h"

namespace foam {
namespace {

constexpr double kStraight = 1e-9; // half-angle, rad

/// Where a point lies beside an arc.
struct Beside {
  double distance = 0; ///< to the left of the arc's circle, cm
  double part = 0;     ///< of the arc before the point's foot; outside of 0 to 1 it has none
};

Beside beside(const WallPiece& arc, Vec2 point) {
  const Vec2 r = point - arc.start;
  if (std::abs(arc.half_angle) < kStraight) {
    const double d = norm(arc.chord);
    return {cross(arc.chord, r) / d, dot(arc.chord, r) / (d * d)};
  }
  const double k = arc.curvature();
  const double value = cross(arc.tangent(0), r) - 0.5 * k * dot(r, r);
  double turn = angle_from_to(arc.start - arc.centre(), point - arc.centre());
  if (turn * arc.half_angle < 0) {
    turn += std::copysign(2 * std::numbers::pi, arc.half_angle);
  }
  return {2 * value / (1 + std::sqrt(std::max(1 - 2 * k * value, 0.0))),
          turn / (2 * arc.half_angle)};
}

/// Calls visit(place) where a piece of a wall may be nearest to an arc: where it starts, and where
/// both have one normal.
template <class Visit>
void for_each_candidate(const WallPiece& piece, const WallPiece& arc, const Visit& visit) {
  visit(0.0);
  const bool straight = std::abs(arc.half_angle) < kStraight;
  const auto take = [&](Vec2 point) {
    const bool on_piece = dot(point - piece.start, piece.tangent(0)) > 0 &&
                          dot(piece.end() - point, piece.tangent(piece.length())) > 0;
    if (on_piece) {
      visit(piece.place_of(point));
    }
  };
  if (piece.half_angle != 0) {
    const Vec2 across = straight ? left_normal(arc.chord) : arc.centre() - piece.centre();
    const Vec2 to = (1 / (std::abs(piece.curvature()) * norm(across))) * across;
    take(piece.centre() + to);
    take(piece.centre() - to);
  } else if (!straight) {
    const Vec2 u = (1 / norm(piece.chord)) * piece.chord;
    take(piece.start + dot(arc.centre() - piece.start, u) * u);
  }
}

template <class Element, class IsThere> Element unused(Slots<Element> slots, const IsThere& there) {
  Index i = slots.size() - 1;
  while (there(slots[i])) {
    --i;
  }
  return slots[i];
}

} // namespace

std::optional<Approach> nearest_film(const Foam& foam, Outside wall) {
  const Exterior& exterior = foam.exterior[wall];
  std::optional<Approach> nearest;
  for_each_half(foam, exterior.host, [&](Half h) {
    if (foam.wall(h)) {
      return;
    }
    WallPiece arc{foam.position[foam.start(h)], foam.chord(h), foam.half_angle(h)};
    Wrap periods;
    if (foam.surroundings.has_images()) {
      const Vec2 middle = arc.start + 0.5 * arc.chord;
      const Vec2 there = foam.wall_piece[Piece(exterior.first_piece)].start;
      const double period = foam.surroundings.lattice.first.x;
      periods.x = static_cast<int>(std::lround((middle.x - there.x) / period));
      arc.start -= foam.surroundings.lattice.period(periods);
    }
    for (Index i = 0; i < exterior.pieces; ++i) {
      const Piece piece(exterior.first_piece + i);
      for_each_candidate(foam.wall_piece[piece], arc, [&](double place) {
        const Beside at = beside(arc, foam.wall_piece[piece].point(place));
        if (at.part > 0 && at.part < 1 && (!nearest || at.distance < nearest->gap)) {
          nearest = {h, {piece, place}, at.distance, periods};
        }
      });
    }
  });
  return nearest;
}

std::optional<Approach> nearest_film(const Foam& foam) {
  std::optional<Approach> nearest;
  for (const Outside wall : foam.outside_slots()) {
    if (foam.exterior[wall].host != kNone) {
      const auto approach = nearest_film(foam, wall);
      nearest = approach && (!nearest || approach->gap < nearest->gap) ? approach : nearest;
    }
  }
  return nearest;
}

void perform_touch(Foam& foam, const Approach& approach) {
  const Half h = approach.film;
  const Outside outside = foam.piece_outside[approach.place.piece];
  const Bubble wall(outside);
  const Bubble host = foam.left(h);
  const Bubble beyond = foam.right(h);
  const Junction last = foam.end(h);
  const double way = std::min(0.125 * length_of_wall(foam, outside), 0.25 * foam.length(h));

  const auto new_film = [&](Junction from, Junction to, Bubble left, Bubble right) {
    const Film film = unused(foam.film_slots(), [&](Film f) { return foam.has_film(f); });
    foam.half_junction[film.half()] = from;
    foam.half_junction[film.half().twin()] = to;
    foam.half_bubble[film.half()] = left;
    foam.half_bubble[film.half().twin()] = right;
    foam.film_angle[film] = 0;
    foam.film_wrap[film] = {};
    if (!foam.has_uniform_tension()) {
      foam.film_tension[film] = foam.tension(h.film());
    }
    return film.half();
  };
  const auto new_junction = [&](double distance) {
    const Junction j =
        unused(foam.junction_slots(), [&](Junction k) { return foam.has_junction(k); });
    foam.put_on_wall(j, moved_along_wall(foam, approach.place, distance, AtEdges::Pass));
    foam.junction_half[j][0] = h; // it is taken
    return j;
  };
  // With the foam on its left a wall runs against the film.
  const Junction a = new_junction(way);
  const Junction b = new_junction(-way);
  const Half ahead = new_film(b, last, host, beyond);
  const Half far = new_film(a, b, host, wall);
  const Half near = new_film(b, a, beyond, wall);
  foam.half_junction[h.twin()] = a;
  foam.set_wrap(ahead, foam.wrap(h) - approach.periods);
  foam.set_wrap(h, approach.periods);
  std::ranges::replace(foam.junction_half[last], h.twin(), ahead.twin());
  foam.junction_half[a] = {near.twin(), far, h.twin()};
  foam.junction_half[b] = {ahead, far.twin(), near};
  detail::add_sides(foam, host, 2);
  detail::add_sides(foam, beyond, 2);
  detail::bend_by_pressure(foam, h);
  detail::bend_by_pressure(foam, ahead);
  foam.exterior[outside].host = kNone;
  note_performed(foam, {.kind = TopologicalOperation::Kind::T1,
                        .place = foam.position[a],
                        .bubbles = {host, beyond, wall, wall}});
  assert(validate(foam).empty());
}

bool touch_walls(Foam& foam) {
  bool any = false;
  for (const Outside wall : foam.outside_slots()) {
    if (foam.exterior[wall].host != kNone) {
      const auto approach = nearest_film(foam, wall);
      if (approach && approach->gap < 0) {
        perform_touch(foam, *approach);
        any = true;
      }
    }
  }
  return any;
}

} // namespace foam
