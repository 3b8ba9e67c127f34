// SPDX-License-Identifier: GPL-3.0-or-later
#include "construct/dual_mesh.h"

#include <algorithm>
#include <cstddef>
#include <numeric>
#include <tuple>
#include <vector>

namespace foam {
namespace {

/// A triangle's edge from one of its corners to the next, and the half-film that leaves through it.
struct Crossing {
  Bubble from, to; ///< points, in the order that both triangles at the edge agree on
  Wrap wrap;       ///< between them
  bool backward;   ///< whether the triangle walks from `to` to `from`
  Junction triangle;
  std::size_t opposite; ///< corner

  auto edge() const { return std::tuple(from, to, wrap.x, wrap.y); }
  bool operator<(const Crossing& c) const {
    return std::tuple_cat(edge(), std::tuple(backward)) <
           std::tuple_cat(c.edge(), std::tuple(c.backward));
  }
};

Crossing crossing(std::span<const Triangle> triangles, Junction triangle, std::size_t opposite) {
  const Triangle& t = triangles[triangle.place()];
  const Corner& from = t[(opposite + 1) % 3];
  const Corner& to = t[(opposite + 2) % 3];
  const Wrap wrap = to.copy - from.copy;
  const bool backward = std::tuple(to.point, from.point, -wrap.x, -wrap.y) <
                        std::tuple(from.point, to.point, wrap.x, wrap.y);
  return backward ? Crossing{to.point, from.point, -wrap, true, triangle, opposite}
                  : Crossing{from.point, to.point, wrap, false, triangle, opposite};
}

/// Every edge twice in succession, as its two triangles see it.
std::vector<Crossing> crossings(std::span<const Triangle> triangles) {
  std::vector<Crossing> result;
  result.reserve(3 * triangles.size());
  for (const Junction t : Slots<Junction>(static_cast<Index>(triangles.size()))) {
    for (std::size_t k = 0; k < 3; ++k) {
      result.push_back(crossing(triangles, t, k));
    }
  }
  std::sort(result.begin(), result.end());
  return result;
}

Vec2 barycentre(const Face& face) {
  return (1.0 / 3) * (face[0] + face[1] + face[2]);
}

/// The film between two incentres crosses its triangles' common edge, so that the films of a bubble
/// surround its point, however unequal the triangles.
Vec2 incentre(const Face& face) {
  const double a = norm(face[2] - face[1]);
  const double b = norm(face[0] - face[2]);
  const double c = norm(face[1] - face[0]);
  return (1 / (a + b + c)) * (a * face[0] + b * face[1] + c * face[2]);
}

} // namespace

Foam dual_mesh(std::span<const Triangle> triangles, std::size_t points) {
  const auto edges = crossings(triangles);
  Foam foam;
  foam.clear(static_cast<Index>(points), static_cast<Index>(edges.size() / 2),
             static_cast<Index>(triangles.size()));
  std::iota(foam.bubble_id.begin(), foam.bubble_id.end(), std::int64_t{0});
  for (const Half h : foam.half_slots()) {
    const Crossing& edge = edges[h.place()];
    // Whoever leaves a counter-clockwise triangle through an edge has its far end on the left.
    const Bubble left = edge.backward ? edge.from : edge.to;
    foam.half_junction[h] = edge.triangle;
    foam.half_bubble[h] = left;
    foam.junction_half[edge.triangle][edge.opposite] = h;
    if (!left.is_outside()) {
      if (!foam.has_bubble(left)) {
        foam.bubble_half[left] = h;
      }
      ++foam.sides[left];
    }
    if (!edge.backward) {
      const Crossing& across = edges[h.twin().place()];
      foam.film_wrap[h.film()] = triangles[edge.triangle.place()][(edge.opposite + 1) % 3].copy -
                                 triangles[across.triangle.place()][(across.opposite + 2) % 3].copy;
    }
  }
  for (auto& halves : foam.junction_half) {
    std::rotate(halves.begin(), std::min_element(halves.begin(), halves.end()), halves.end());
  }
  return foam;
}

void place_junctions(Foam& foam, std::span<const Face> faces) {
  std::transform(faces.begin(), faces.end(), foam.position.begin(), barycentre);
  std::vector<bool> moved(faces.size(), false);
  std::vector<Bubble> pending;
  for (const Bubble b : foam.bubble_slots()) {
    pending.push_back(b);
  }
  while (!pending.empty()) {
    std::vector<Bubble> affected;
    const auto move = [&](Junction j) {
      if (moved[j.place()]) {
        return;
      }
      moved[j.place()] = true;
      foam.position[j] = incentre(faces[j.place()]);
      for (const Half h : foam.junction_half[j]) {
        if (!foam.left(h).is_outside()) {
          affected.push_back(foam.left(h));
        }
      }
    };
    for (const Bubble b : pending) {
      if (!(foam.area(b) > 0)) {
        for_each_half(foam, b, [&](Half h) { move(foam.start(h)); });
      }
    }
    pending = std::move(affected);
  }
}

} // namespace foam
