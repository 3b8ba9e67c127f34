// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "mesh/mesh_access.h"

namespace foam {
namespace detail {

template <class Mesh> FOAM_HOST_DEVICE bool ends_on_wall(const Mesh& mesh, Film film) {
  return mesh.on_wall(mesh.start(film.half())) || mesh.on_wall(mesh.end(film.half()));
}

} // namespace detail

/// What a film is short beside: √A^τ of the smaller bubble along it, cm.
template <class Mesh> FOAM_HOST_DEVICE double size_beside(const Mesh& mesh, Film film) {
  const auto target_area = [&](Bubble b) {
    return b.is_outside() ? std::numeric_limits<double>::infinity() : mesh.target_area[b];
  };
  return std::sqrt(
      std::min(target_area(mesh.left(film.half())), target_area(mesh.right(film.half()))));
}

/// Whether the bubbles along a film have more than three sides, so that a swap leaves each three or
/// more: three-sided bubbles vanish by T2. Where a film ends on a wall two are enough, the wall and
/// a film. On a torus a bubble may lie on both sides, and loses two.
template <class Mesh> FOAM_HOST_DEVICE bool spares_sides(const Mesh& mesh, Film film) {
  const Bubble left = mesh.left(film.half());
  const Bubble right = mesh.right(film.half());
  const bool reaches_wall = detail::ends_on_wall(mesh, film) && !mesh.wall(film.half());
  const Index needed = (reaches_wall ? 3 : 4) + (left == right ? 1 : 0);
  const auto spares = [&](Bubble b) { return b.is_outside() || mesh.sides[b] >= needed; };
  return spares(left) && spares(right);
}

/// Whether the films at the ends of a short film pull it shut, and would pull the swapped film
/// open: the physics of a T1, which a rule of length alone misses.
///
/// With forces f₁, f₂ of the other films at one end (tension times unit tangent) and f₃, f₄ at the
/// other, f₁ and f₄ on the same side, the film's own tension T is overcome by the pairs across it
/// if |f₁ + f₄| > T, and they pull harder than those along it if |f₁ + f₄| > |f₁ + f₂|. The same
/// must hold on the other side and at the other end. A film that ends on a wall is pulled shut by
/// whatever shortens it, and so is a stretch of the wall between two films: one takes their place.
///
/// One that pulls more than √2 times as hard as the other four can shrink to nothing without being
/// pulled shut: the four hold each other in a point, which is no mesh of threes.
template <class Mesh> FOAM_HOST_DEVICE bool unstable_to_t1(const Mesh& mesh, Film film) {
  if (detail::ends_on_wall(mesh, film)) {
    return true;
  }
  const Half h = film.half();
  const Half t = h.twin();
  const auto force = [&](Half other) { // in units of 2γ
    return mesh.relative_tension(other.film()) * mesh.tangent(other);
  };
  const Vec2 f1 = force(mesh.next_around_junction(h));
  const Vec2 f2 = force(mesh.previous_around_junction(h));
  const Vec2 f3 = force(mesh.next_around_junction(t));
  const Vec2 f4 = force(mesh.previous_around_junction(t));
  const double across = std::min(norm(f1 + f4), norm(f2 + f3));
  const double along = std::max(norm(f1 + f2), norm(f3 + f4));
  return across > std::max(mesh.relative_tension(film), along);
}

} // namespace foam
