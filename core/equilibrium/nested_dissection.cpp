// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/nested_dissection.h"
#include "base/number.h"

#include <algorithm>
#include <bit>
#include <span>

namespace foam {
namespace {

// Places are nodes of a binary tree, numbered from the root, 1; those below p are 2p and 2p + 1.
using Place = std::uint32_t;
constexpr Place kNowhere = 0;
constexpr Place kRoot = 1;

constexpr std::size_t kLeafJunctions = 3; // so many or fewer are not halved any more
constexpr int kLevelsInOneNode = 2;       // at the bottom: smaller nodes are not worth it

int level(Place place) {
  return static_cast<int>(std::bit_width(place)) - 1;
}

/// The lowest that is above both, or one of them.
Place common(Place a, Place b) {
  if (a == kNowhere || b == kNowhere) {
    return std::max(a, b);
  }
  while (a != b) {
    (a > b ? a : b) >>= 1;
  }
  return a;
}

/// Of two, one of them above the other, the upper one.
Place upper(Place a, Place b) {
  return a == kNowhere || b == kNowhere ? std::max(a, b) : std::min(a, b);
}

struct Point {
  Vec2 position;
  std::size_t unknown; ///< the first of the junction's two
};

/// Gives every point a leaf.
void halve(std::span<Point> points, Place place, int levels, std::vector<Place>& leaf) {
  if (levels == 0) {
    for (const Point& p : points) {
      leaf[p.unknown] = place;
    }
    return;
  }
  Vec2 low = points.empty() ? Vec2{} : points.front().position;
  Vec2 high = low;
  for (const Point& p : points) {
    low = {std::min(low.x, p.position.x), std::min(low.y, p.position.y)};
    high = {std::max(high.x, p.position.x), std::max(high.y, p.position.y)};
  }
  const auto along = high.x - low.x > high.y - low.y ? &Vec2::x : &Vec2::y;
  const std::size_t half = points.size() / 2;
  std::nth_element(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(half), points.end(),
                   [along](const Point& p, const Point& q) {
                     return p.position.*along < q.position.*along ||
                            (p.position.*along == q.position.*along && p.unknown < q.unknown);
                   });
  halve(points.first(half), 2 * place, levels - 1, leaf);
  halve(points.subspan(half), 2 * place + 1, levels - 1, leaf);
}

/// Where each unknown is eliminated.
std::vector<Place> places_of(const Foam& foam, const Region& region, const Unknowns& unknowns,
                             int levels) {
  std::vector<Point> points;
  points.reserve(region.junctions.size());
  for (const Junction j : region.junctions) {
    points.push_back({foam.position[j], place_of(unknowns.junction(j))});
  }
  std::vector<Place> leaf(place_of(unknowns.count()), kNowhere);
  halve(points, kRoot, levels, leaf);

  std::vector<Place> places = leaf;
  const auto at = [](std::vector<Place>& where, Index unknown) {
    return unknown == kNone ? kNowhere : where[place_of(unknown)];
  };
  const auto raise = [&](Index unknown, Place place) {
    if (unknown != kNone) {
      places[place_of(unknown)] = place;
    }
  };
  std::vector<FilmLagrangian::Each<Index>> films;
  for (const Film f : region.films) {
    const auto& [a, a_y, b, b_y, left, right, angle] =
        films.emplace_back(unknowns.of_film(foam, f));
    const Place cut = common(at(leaf, a), at(leaf, b));
    raise(left, common(at(places, left), cut));
    raise(right, common(at(places, right), cut));
    if (at(places, a) > cut && at(places, b) > cut) {
      raise(a, cut);
    }
  }
  for (Index pressure = unknowns.first_pressure(); pressure < unknowns.first_angle(); ++pressure) {
    raise(pressure, std::max(at(places, pressure), kRoot)); // no junction of it moves
  }
  for (const auto& [a, a_y, b, b_y, left, right, angle] : films) {
    raise(a_y, at(places, a));
    raise(b_y, at(places, b));
    const Place both = common(at(places, left), at(places, right));
    if (at(places, left) > both && at(places, right) > both) { // they share no junction that moves
      raise(left, both);
    }
  }
  for (const FilmLagrangian::Each<Index>& film : films) {
    Place place = kNowhere;
    for (const Index u : std::span(film).first(6)) {
      place = upper(place, at(places, u));
    }
    raise(film.back(), place);
  }
  return places;
}

} // namespace

EliminationTree nested_dissection(const Foam& foam, const Region& region,
                                  const Unknowns& unknowns) {
  const auto levels =
      static_cast<int>(std::bit_width(region.junctions.size() / (kLeafJunctions + 1)));
  const int node_levels = std::max(levels - kLevelsInOneNode, 0);
  const std::vector<Place> places = places_of(foam, region, unknowns, levels);

  // Children before their parent: by the last leaf below, and from there upwards.
  const auto rank = [](Place place, int depth) {
    const int below = depth - level(place);
    const std::uint64_t last_leaf = ((std::uint64_t{place} + 1) << below) - 1;
    return last_leaf * 64 + static_cast<std::uint64_t>(below);
  };
  EliminationTree tree;
  std::vector<std::pair<std::uint64_t, Index>> keys;
  keys.reserve(places.size());
  for (std::size_t u = 0; u < places.size(); ++u) {
    keys.emplace_back(rank(places[u], levels), static_cast<Index>(u));
  }
  std::ranges::sort(keys);
  std::vector<Index> count(std::size_t{2} << node_levels, 0); // of unknowns, by node's place
  for (const auto& [key, u] : keys) {
    tree.order.push_back(u);
    const Place place = places[place_of(u)];
    ++count[place >> std::max(level(place) - node_levels, 0)];
  }
  std::vector<Place> nodes;
  for (Place place = kRoot; place < count.size(); ++place) {
    nodes.push_back(place);
  }
  std::ranges::sort(nodes, {}, [&](Place place) { return rank(place, node_levels); });
  std::vector<Index> number(count.size(), kNone);
  Index begin = 0;
  for (const Place place : nodes) {
    number[place] = static_cast<Index>(tree.nodes.size());
    EliminationTree::Node node{begin, begin + count[place], {kNone, kNone}};
    const std::size_t below = 2 * std::size_t{place};
    if (below < number.size()) {
      node.children = {number[below], number[below + 1]};
    }
    begin = node.end;
    tree.nodes.push_back(node);
  }
  return tree;
}

} // namespace foam
