// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/film_set.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <unordered_map>

#include "base/error.h"
#include "mesh/element_measures.h"
#include "mesh/hosted_walls.h"
#include "mesh/validate.h"

namespace foam {
namespace {

using std::to_string;

/// The outgoing half-films of a junction in counter-clockwise order, beginning with the lowest.
///
/// The bubble on the left of a half-film is on the right of the next one; where three different
/// bubbles meet that alone decides the order. Where a bubble meets itself (small tori) the tangents
/// decide.
std::array<Half, 3> counter_clockwise(const Foam& foam, std::array<Half, 3> halves) {
  std::sort(halves.begin(), halves.end());
  const auto [a, b, c] = halves;
  const auto follows = [&](Half next, Half h) { return foam.right(next) == foam.left(h); };
  const bool abc = follows(b, a) && follows(c, b) && follows(a, c);
  const bool acb = follows(c, a) && follows(b, c) && follows(a, b);
  if (abc && acb) {
    const Vec2 first = foam.tangent(a);
    const auto turn = [&](Half h) {
      const double angle = angle_from_to(first, foam.tangent(h));
      return angle < 0 ? angle + 2 * std::numbers::pi : angle;
    };
    return turn(b) < turn(c) ? std::array{a, b, c} : std::array{a, c, b};
  }
  if (!abc && !acb) {
    throw FoamError("the bubbles around junction " + to_string(foam.start(a).index()) +
                    " do not fit together");
  }
  return abc ? std::array{a, b, c} : std::array{a, c, b};
}

void check_finite(double value, const std::string& what) {
  if (!std::isfinite(value)) {
    throw FoamError(what + " is " + number(value));
  }
}

void check_scalars(const FilmSet& set) {
  if (set.films.empty()) {
    throw FoamError("the foam has no films");
  }
  check_finite(set.time, "TimeValue");
  if (!(set.surface_tension > 0) || !std::isfinite(set.surface_tension)) {
    throw FoamError("SurfaceTension must be positive, but is " + number(set.surface_tension));
  }
  if (set.surroundings.periodic()) {
    const auto& [origin, first, second] = set.surroundings.lattice;
    const double area = set.surroundings.lattice.area();
    if (!(area > 0) || !std::isfinite(area + origin.x + origin.y)) {
      throw FoamError("the periods " + number(first) + " and " + number(second) + " at " +
                      number(origin) + " enclose no area");
    }
  }
}

/// \throws FoamError if a film has no tension, or a junction that may move cannot hold those of its
/// films.
void check_tensions(const Foam& foam) {
  if (foam.has_uniform_tension()) {
    return;
  }
  for (const Film f : foam.film_slots()) {
    if (!(foam.tension(f) > 0) || !std::isfinite(foam.tension(f))) {
      throw FoamError("the tension of film " + to_string(f.index()) + " must be positive, but is " +
                      number(foam.tension(f)));
    }
  }
  for (const Junction j : foam.junction_slots()) {
    const std::array<double, 3> tension = tensions_at(foam, j);
    if (!foam.on_wall(j) && !can_balance(tension)) {
      throw FoamError("junction " + to_string(j.index()) + " cannot hold films of tensions " +
                      number(tension[0]) + ", " + number(tension[1]) + " and " +
                      number(tension[2]) + " N/cm: one pulls harder than the other two together");
    }
  }
}

void take_pressures(Foam& foam, const std::vector<Exterior>& of) {
  for (std::size_t i = 0; i < std::min(of.size(), foam.exterior.size()); ++i) {
    foam.exterior[Outside(static_cast<Index>(i))].pressure = of[i].pressure;
  }
}

/// \pre films and junctions are there
void set_walls(Foam& foam, const FilmSet& set) {
  if (set.wall_pieces.empty() || set.exteriors.empty()) {
    if (set.surroundings.boundary != Boundary::Fixed) {
      throw FoamError("Boundary is 3, that of a container, but no walls are listed");
    }
    const std::vector<Exterior> listed = foam.exterior;
    foam.seal_outline();
    take_pressures(foam, listed);
    return;
  }
  std::vector<Wall> walls;
  std::size_t piece = 0;
  for (const Exterior& exterior : set.exteriors) {
    Wall& wall = walls.emplace_back();
    wall.contact = exterior.contact;
    for (Index i = 0; i < exterior.pieces && piece < set.wall_pieces.size(); ++i) {
      wall.pieces.push_back(set.wall_pieces[piece++]);
    }
  }
  foam.surroundings = set.surroundings;
  foam.set_walls(walls);
  take_pressures(foam, set.exteriors);
}

} // namespace

FilmSet film_set(const Foam& foam) {
  FilmSet set;
  static_cast<FoamRecord&>(set) = static_cast<const FoamRecord&>(foam);
  set.exteriors = foam.exterior;
  for (Exterior& exterior : set.exteriors) {
    exterior.host = kNone; // the films tell
  }
  set.wall_pieces = foam.wall_piece;

  Field<Junction, Index> junction_number(foam.position.size(), kNone);
  for (const Junction j : foam.junction_slots()) {
    if (foam.has_junction(j)) {
      junction_number[j] = static_cast<Index>(set.junctions.size());
      set.junctions.push_back(foam.position[j]);
    }
  }
  const auto id = [&](Bubble b) {
    return b.is_outside() ? std::int64_t{b.index()} : foam.bubble_id[b];
  };
  for (const Film f : foam.film_slots()) {
    if (foam.has_film(f)) {
      const Half h = f.half();
      set.films.push_back({junction_number[foam.start(h)], junction_number[foam.end(h)],
                           id(foam.left(h)), id(foam.right(h)), foam.half_angle(h), foam.wrap(h)});
      if (!foam.has_uniform_tension()) {
        set.tensions.push_back(foam.tension(f));
      }
    }
  }
  for (const Bubble b : foam.bubble_slots()) {
    if (foam.has_bubble(b)) {
      set.bubbles.push_back({foam.bubble_id[b], foam.pressure[b], foam.target_area[b]});
    }
  }
  std::ranges::sort(set.bubbles, {}, &FilmSet::Bubble::id);
  return set;
}

Foam foam_of(const FilmSet& set) {
  check_scalars(set);
  Foam foam;
  foam.clear(static_cast<Index>(set.bubbles.size()), static_cast<Index>(set.films.size()),
             static_cast<Index>(set.junctions.size()));
  static_cast<FoamRecord&>(foam) = static_cast<const FoamRecord&>(set);
  foam.surround(set.surroundings.has_walls() ? Surroundings{} : set.surroundings);
  if (!set.exteriors.empty()) {
    foam.exterior.assign(set.exteriors.begin(), set.exteriors.end());
  }

  std::unordered_map<std::int64_t, Bubble> bubble_number;
  for (Index k = 0; k < static_cast<Index>(foam.exterior.size()); ++k) {
    const Bubble outside{Outside(k)};
    bubble_number.emplace(outside.index(), outside);
  }
  for (const Bubble b : foam.bubble_slots()) {
    const auto& bubble = set.bubbles[b.place()];
    const std::string name = "bubble " + to_string(bubble.id);
    if (bubble.id < 0 || !bubble_number.emplace(bubble.id, b).second) {
      throw FoamError("BubbleId " + to_string(bubble.id) + " is negative or listed twice");
    }
    check_finite(bubble.pressure, "the pressure of " + name);
    if (!(bubble.target_area > 0) || !std::isfinite(bubble.target_area)) {
      throw FoamError("the target area of " + name + " must be positive, but is " +
                      number(bubble.target_area));
    }
    foam.bubble_id[b] = bubble.id;
    foam.pressure[b] = bubble.pressure;
    foam.target_area[b] = bubble.target_area;
  }

  for (const Junction j : foam.junction_slots()) {
    const Vec2 position = set.junctions[j.place()];
    foam.position[j] = position;
    check_finite(position.x + position.y, "the position of junction " + to_string(j.index()));
  }

  if (!set.tensions.empty() && set.tensions.size() != set.films.size()) {
    throw FoamError("there are " + to_string(set.tensions.size()) + " tensions for " +
                    to_string(set.films.size()) + " films");
  }
  foam.film_tension.assign(set.tensions.begin(), set.tensions.end());
  Field<Junction, int> degree(set.junctions.size(), 0);
  for (const Film f : foam.film_slots()) {
    const auto& film = set.films[f.place()];
    const std::string name = "film " + to_string(f.index());
    const auto lookup = [&](std::int64_t bubble) {
      const auto found = bubble_number.find(bubble);
      if (found == bubble_number.end()) {
        throw FoamError(name + " names bubble " + to_string(bubble) + ", which is not listed");
      }
      return found->second;
    };
    if (!(std::abs(film.half_angle) < std::numbers::pi)) {
      throw FoamError("the half-angle of " + name + " is " + number(film.half_angle) +
                      ", outside (-pi, pi)");
    }
    const auto set_half = [&](Half h, Index start, std::int64_t left) {
      const Junction j(start);
      if (start < 0 || j.place() >= set.junctions.size()) {
        throw FoamError(name + " ends in junction " + to_string(start) + ", which does not exist");
      }
      if (degree[j] == 3) {
        throw FoamError("more than three films meet in junction " + to_string(start));
      }
      foam.junction_half[j][static_cast<std::size_t>(degree[j]++)] = h;
      foam.half_junction[h] = j;
      foam.half_bubble[h] = lookup(left);
    };
    set_half(f.half(), film.start, film.left);
    set_half(f.half().twin(), film.end, film.right);
    foam.film_angle[f] = film.half_angle;
    foam.film_wrap[f] = film.wrap;
  }

  for (const Junction j : foam.junction_slots()) {
    if (degree[j] != 3) {
      throw FoamError(to_string(degree[j]) + " films meet in junction " + to_string(j.index()) +
                      ", not three");
    }
    foam.junction_half[j] = counter_clockwise(foam, foam.junction_half[j]);
  }
  for (const Half h : foam.half_slots()) {
    const Bubble b = foam.left(h);
    if (!b.is_outside()) {
      if (foam.bubble_half[b] == kNone) {
        foam.bubble_half[b] = h;
      }
      ++foam.sides[b];
    }
  }
  for (const Bubble b : foam.bubble_slots()) {
    if (!foam.has_bubble(b)) {
      throw FoamError("bubble " + to_string(foam.bubble_id[b]) + " has no films");
    }
  }
  if (set.surroundings.has_walls()) {
    set_walls(foam, set);
    house_walls(foam);
  }
  const auto problems = validate(foam);
  if (!problems.empty()) {
    throw FoamError(problems.front());
  }
  check_tensions(foam);
  return foam;
}

} // namespace foam
