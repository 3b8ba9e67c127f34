// SPDX-License-Identifier: GPL-3.0-or-later
#include "algebra/dissection.h"

#include <bit>

#include "geometry/bounds.h"

namespace foam {
namespace {

constexpr std::size_t kLeafPoints = 3; // so many or fewer are not halved any more
constexpr int kLevelsInOneNode = 2;    // at the bottom: smaller nodes are not worth it

int level(TreePlace place) {
  return static_cast<int>(std::bit_width(place)) - 1;
}

struct Point {
  Vec2 position;
  std::size_t number;
};

/// Gives every point a leaf.
void halve(std::span<Point> points, TreePlace place, int levels, std::vector<TreePlace>& leaf) {
  if (levels == 0) {
    for (const Point& p : points) {
      leaf[p.number] = place;
    }
    return;
  }
  Bounds bounds;
  for (const Point& p : points) {
    bounds = bounds + Bounds{p.position, p.position};
  }
  const Vec2 extent = bounds.high - bounds.low;
  const auto along = extent.x > extent.y ? &Vec2::x : &Vec2::y;
  const std::size_t half = points.size() / 2;
  std::nth_element(points.begin(), points.begin() + static_cast<std::ptrdiff_t>(half), points.end(),
                   [along](const Point& p, const Point& q) {
                     return p.position.*along < q.position.*along ||
                            (p.position.*along == q.position.*along && p.number < q.number);
                   });
  halve(points.first(half), 2 * place, levels - 1, leaf);
  halve(points.subspan(half), 2 * place + 1, levels - 1, leaf);
}

} // namespace

int levels_for(std::size_t points) {
  return static_cast<int>(std::bit_width(points / (kLeafPoints + 1)));
}

std::vector<TreePlace> bisect(std::span<const Vec2> points, int levels) {
  std::vector<Point> sorted;
  sorted.reserve(points.size());
  for (const Vec2 position : points) {
    sorted.push_back({position, sorted.size()});
  }
  std::vector<TreePlace> leaf(points.size());
  halve(sorted, kRoot, levels, leaf);
  return leaf;
}

EliminationTree elimination_tree(std::span<const TreePlace> places, int levels) {
  const int node_levels = std::max(levels - kLevelsInOneNode, 0);
  // Children before their parent: by the last leaf below, and from there upwards.
  const auto rank = [](TreePlace place, int depth) {
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
  std::vector<Index> count(std::size_t{2} << node_levels, 0); // of unknowns, by node
  for (const auto& [key, u] : keys) {
    tree.order.push_back(u);
    const TreePlace place = places[place_of(u)];
    ++count[place >> std::max(level(place) - node_levels, 0)];
  }
  std::vector<TreePlace> nodes;
  for (TreePlace place = kRoot; place < count.size(); ++place) {
    nodes.push_back(place);
  }
  std::ranges::sort(nodes, {}, [&](TreePlace place) { return rank(place, node_levels); });
  std::vector<Index> number(count.size(), kNone);
  Index begin = 0;
  for (const TreePlace place : nodes) {
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
