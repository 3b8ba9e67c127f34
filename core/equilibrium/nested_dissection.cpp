// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/nested_dissection.h"

#include <algorithm>
#include <bit>
#include <span>

namespace foam {
namespace {

// Places are nodes of a binary tree, numbered from the root, 1; those below p are 2p and 2p + 1.
using Place = std::uint32_t;
constexpr Place kNowhere = 0;

constexpr std::size_t kLeafJunctions = 3; // so many or fewer are not halved any more
constexpr int kLevelsInOneNode = 2;       // at the bottom: smaller nodes are not worth it

int level(Place place) {
  return std::bit_width(place) - 1;
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
  Index junction;
};

/// Gives every point a leaf.
void halve(std::span<Point> points, Place place, int levels, std::vector<Place>& leaf) {
  if (levels == 0) {
    for (const Point& p : points) {
      leaf[Foam::size(p.junction)] = place;
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
                            (p.position.*along == q.position.*along && p.junction < q.junction);
                   });
  halve(points.first(half), 2 * place, levels - 1, leaf);
  halve(points.subspan(half), 2 * place + 1, levels - 1, leaf);
}

/// Where each unknown is eliminated.
std::vector<Place> places_of(const Foam& foam, const Region& region, const Unknowns& unknowns,
                             int levels) {
  std::vector<Point> points;
  points.reserve(region.junctions.size());
  for (const Index j : region.junctions) {
    points.push_back({foam.position[Foam::size(j)], j});
  }
  std::vector<Place> leaf(foam.position.size(), kNowhere);
  halve(points, 1, levels, leaf);

  std::vector<Place> junctions = leaf;
  std::vector<Place> bubbles(foam.pressure.size(), kNowhere);
  for (const Index f : region.films) {
    const auto a = Foam::size(foam.start(2 * f));
    const auto b = Foam::size(foam.end(2 * f));
    const Place cut = common(leaf[a], leaf[b]);
    for (const Index bubble : {foam.left(2 * f), foam.right(2 * f)}) {
      if (unknowns.bubble(bubble) != kNone) {
        Place& place = bubbles[Foam::size(bubble)];
        place = common(place, cut);
      }
    }
    if (junctions[a] > cut && junctions[b] > cut) {
      junctions[a] = cut;
    }
  }
  for (const Index b : region.bubbles) {
    Place& place = bubbles[Foam::size(b)];
    place = place == kNowhere ? 1 : place;
  }
  for (const Index f : region.films) { // between bubbles that share no junction that moves
    const Place left = unknowns.bubble(foam.left(2 * f)) == kNone
                           ? kNowhere
                           : bubbles[Foam::size(foam.left(2 * f))];
    const Place right = unknowns.bubble(foam.right(2 * f)) == kNone
                            ? kNowhere
                            : bubbles[Foam::size(foam.right(2 * f))];
    const Place both = common(left, right);
    if (left > both && right > both) {
      bubbles[Foam::size(foam.left(2 * f))] = both;
    }
  }

  std::vector<Place> places(Foam::size(unknowns.count()));
  for (const Index j : region.junctions) {
    const auto u = Foam::size(unknowns.junction(j));
    places[u] = places[u + 1] = junctions[Foam::size(j)];
  }
  for (const Index b : region.bubbles) {
    places[Foam::size(unknowns.bubble(b))] = bubbles[Foam::size(b)];
  }
  for (const Index f : region.films) {
    const std::array<Index, 7> film = unknowns.of_film(foam, f);
    if (film.back() != kNone) {
      Place place = kNowhere;
      for (const Index u : std::span(film).first(6)) {
        place = upper(place, u == kNone ? kNowhere : places[Foam::size(u)]);
      }
      places[Foam::size(film.back())] = place;
    }
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
    const Place place = places[Foam::size(u)];
    ++count[place >> std::max(level(place) - node_levels, 0)];
  }
  std::vector<Place> nodes;
  for (Place place = 1; place < count.size(); ++place) {
    nodes.push_back(place);
  }
  std::ranges::sort(nodes, {}, [&](Place place) { return rank(place, node_levels); });
  std::vector<Index> number(count.size(), kNone);
  Index begin = 0;
  for (const Place place : nodes) {
    number[place] = static_cast<Index>(tree.nodes.size());
    EliminationTree::Node node{begin, begin + count[place], {kNone, kNone}};
    if (2 * place + 1 < number.size()) {
      node.children = {number[2 * place], number[2 * place + 1]};
    }
    begin = node.end;
    tree.nodes.push_back(node);
  }
  return tree;
}

} // namespace foam
