// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/film_set.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>
#include <unordered_map>

#include "base/error.h"
#include "mesh/validate.h"

namespace foam {
namespace {

using std::to_string;

/// The outgoing half-films of a junction in counter-clockwise order, beginning with the lowest.
///
/// The bubble on the left of a half-film is on the right of the next one; where three different
/// bubbles meet that alone decides the order. Where a bubble meets itself (small tori) the tangents
/// decide.
std::array<Index, 3> counter_clockwise(const Foam& foam, std::array<Index, 3> halves) {
  std::sort(halves.begin(), halves.end());
  const auto [a, b, c] = halves;
  const auto follows = [&](Index next, Index h) { return foam.right(next) == foam.left(h); };
  const bool abc = follows(b, a) && follows(c, b) && follows(a, c);
  const bool acb = follows(c, a) && follows(b, c) && follows(a, b);
  if (abc && acb) {
    const auto turn = [&](Index h) {
      const double angle = angle_from_to(foam.tangent(a), foam.tangent(h));
      return angle < 0 ? angle + 2 * std::numbers::pi : angle;
    };
    return turn(b) < turn(c) ? std::array{a, b, c} : std::array{a, c, b};
  }
  if (!abc && !acb) {
    throw FoamError("the bubbles around junction " + to_string(foam.start(a)) +
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
  if (set.boundary == Boundary::Periodic &&
      !(std::isfinite(set.box.width()) && std::isfinite(set.box.height()) && set.box.width() > 0 &&
        set.box.height() > 0)) {
    throw FoamError("PeriodicBounds enclose no area: " + number(set.box.xmin) + " " +
                    number(set.box.xmax) + " " + number(set.box.ymin) + " " + number(set.box.ymax));
  }
}

} // namespace

FilmSet film_set(const Foam& foam) {
  FilmSet set;
  static_cast<FoamRecord&>(set) = static_cast<const FoamRecord&>(foam);

  std::vector<Index> junction_number(foam.position.size(), kNone);
  for (Index j = 0; j < foam.junction_capacity(); ++j) {
    if (foam.has_junction(j)) {
      junction_number[Foam::size(j)] = static_cast<Index>(set.junctions.size());
      set.junctions.push_back(foam.position[Foam::size(j)]);
    }
  }
  const auto id = [&](Index b) { return b == kWorld ? -1 : foam.bubble_id[Foam::size(b)]; };
  for (Index f = 0; f < foam.film_capacity(); ++f) {
    if (foam.has_film(f)) {
      const Index h = 2 * f;
      set.films.push_back({junction_number[Foam::size(foam.start(h))],
                           junction_number[Foam::size(foam.end(h))], id(foam.left(h)),
                           id(foam.right(h)), foam.half_angle(h), foam.wrap(h)});
    }
  }
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    if (foam.has_bubble(b)) {
      const auto i = Foam::size(b);
      set.bubbles.push_back({foam.bubble_id[i], foam.pressure[i], foam.target_area[i]});
    }
  }
  std::sort(set.bubbles.begin(), set.bubbles.end(),
            [](const auto& a, const auto& b) { return a.id < b.id; });
  return set;
}

Foam foam_of(const FilmSet& set) {
  check_scalars(set);
  Foam foam;
  foam.resize(static_cast<Index>(set.bubbles.size()), static_cast<Index>(set.films.size()),
              static_cast<Index>(set.junctions.size()));
  static_cast<FoamRecord&>(foam) = static_cast<const FoamRecord&>(set);

  std::unordered_map<std::int64_t, Index> bubble_number{{-1, kWorld}};
  for (std::size_t i = 0; i < set.bubbles.size(); ++i) {
    const auto& bubble = set.bubbles[i];
    const std::string name = "bubble " + to_string(bubble.id);
    if (bubble.id < 0 || !bubble_number.emplace(bubble.id, static_cast<Index>(i)).second) {
      throw FoamError("BubbleId " + to_string(bubble.id) + " is negative or listed twice");
    }
    check_finite(bubble.pressure, "the pressure of " + name);
    if (!(bubble.target_area > 0) || !std::isfinite(bubble.target_area)) {
      throw FoamError("the target area of " + name + " must be positive, but is " +
                      number(bubble.target_area));
    }
    foam.bubble_id[i] = bubble.id;
    foam.pressure[i] = bubble.pressure;
    foam.target_area[i] = bubble.target_area;
  }

  for (std::size_t j = 0; j < set.junctions.size(); ++j) {
    foam.position[j] = set.junctions[j];
    check_finite(set.junctions[j].x + set.junctions[j].y,
                 "the position of junction " + to_string(j));
  }

  std::vector<int> degree(set.junctions.size(), 0);
  for (std::size_t f = 0; f < set.films.size(); ++f) {
    const auto& film = set.films[f];
    const std::string name = "film " + to_string(f);
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
    const Index h = 2 * static_cast<Index>(f);
    const std::array ends{film.start, film.end};
    for (int side = 0; side < 2; ++side) {
      const Index j = ends[static_cast<std::size_t>(side)];
      if (j < 0 || Foam::size(j) >= set.junctions.size()) {
        throw FoamError(name + " ends in junction " + to_string(j) + ", which does not exist");
      }
      if (degree[Foam::size(j)] == 3) {
        throw FoamError("more than three films meet in junction " + to_string(j));
      }
      foam.junction_half[Foam::size(j)][static_cast<std::size_t>(degree[Foam::size(j)]++)] =
          h + side;
      foam.half_junction[Foam::size(h + side)] = j;
    }
    foam.half_bubble[Foam::size(h)] = lookup(film.left);
    foam.half_bubble[Foam::size(h + 1)] = lookup(film.right);
    foam.film_angle[f] = film.half_angle;
    foam.film_wrap[f] = film.wrap;
  }

  for (std::size_t j = 0; j < set.junctions.size(); ++j) {
    if (degree[j] != 3) {
      throw FoamError(to_string(degree[j]) + " films meet in junction " + to_string(j) +
                      ", not three");
    }
    foam.junction_half[j] = counter_clockwise(foam, foam.junction_half[j]);
  }
  for (Index h = 2 * foam.film_capacity(); h-- > 0;) {
    const Index b = foam.left(h);
    if (b != kWorld) {
      foam.bubble_half[Foam::size(b)] = h;
      ++foam.sides[Foam::size(b)];
    }
  }
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    if (!foam.has_bubble(b)) {
      throw FoamError("bubble " + to_string(foam.bubble_id[Foam::size(b)]) + " has no films");
    }
  }
  const auto problems = validate(foam);
  if (!problems.empty()) {
    throw FoamError(problems.front());
  }
  return foam;
}

} // namespace foam
