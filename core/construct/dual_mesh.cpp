// SPDX-License-Identifier: GPL-3.0-or-later
#include "construct/dual_mesh.h"

#include <algorithm>
#include <numeric>
#include <tuple>
#include <vector>

namespace foam {
namespace {

/// A triangle's edge from one of its corners to the next, and the half-film that leaves through it.
struct Crossing {
  Index from, to; ///< points, in the order that both triangles at the edge agree on
  Wrap wrap;      ///< between them
  bool backward;  ///< whether the triangle walks from `to` to `from`
  Index triangle;
  std::size_t opposite; ///< corner

  auto edge() const { return std::tuple(from, to, wrap.x, wrap.y); }
  bool operator<(const Crossing& c) const {
    return std::tuple_cat(edge(), std::tuple(backward)) <
           std::tuple_cat(c.edge(), std::tuple(c.backward));
  }
};

Crossing crossing(std::span<const Triangle> triangles, Index triangle, std::size_t opposite) {
  const Triangle& t = triangles[Foam::size(triangle)];
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
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    for (std::size_t k = 0; k < 3; ++k) {
      result.push_back(crossing(triangles, static_cast<Index>(t), k));
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
  foam.resize(static_cast<Index>(points), static_cast<Index>(edges.size() / 2),
              static_cast<Index>(triangles.size()));
  std::iota(foam.bubble_id.begin(), foam.bubble_id.end(), std::int64_t{0});
  for (std::size_t i = edges.size(); i-- > 0;) {
    const auto h = static_cast<Index>(i);
    const Crossing& edge = edges[i];
    // Whoever leaves a counter-clockwise triangle through an edge has its far end on the left.
    const Index left = edge.backward ? edge.from : edge.to;
    foam.half_junction[i] = edge.triangle;
    foam.half_bubble[i] = left;
    foam.junction_half[Foam::size(edge.triangle)][edge.opposite] = h;
    if (left != kWorld) {
      foam.bubble_half[Foam::size(left)] = h;
      ++foam.sides[Foam::size(left)];
    }
    if (!edge.backward) {
      const Crossing& across = edges[i + 1];
      foam.film_wrap[i / 2] =
          triangles[Foam::size(edge.triangle)][(edge.opposite + 1) % 3].copy -
          triangles[Foam::size(across.triangle)][(across.opposite + 2) % 3].copy;
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
  std::vector<Index> pending(foam.bubble_half.size());
  std::iota(pending.begin(), pending.end(), Index{0});
  while (!pending.empty()) {
    std::vector<Index> affected;
    const auto move = [&](Index j) {
      if (moved[Foam::size(j)]) {
        return;
      }
      moved[Foam::size(j)] = true;
      foam.position[Foam::size(j)] = incentre(faces[Foam::size(j)]);
      for (const Index h : foam.junction_half[Foam::size(j)]) {
        if (foam.left(h) != kWorld) {
          affected.push_back(foam.left(h));
        }
      }
    };
    for (const Index b : pending) {
      if (!(foam.area(b) > 0)) {
        for_each_half(foam, b, [&](Index h) { move(foam.start(h)); });
      }
    }
    pending = std::move(affected);
  }
}

} // namespace foam
