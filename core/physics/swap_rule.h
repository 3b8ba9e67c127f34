// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "mesh/mesh_access.h"

namespace foam {
namespace detail {

template <class Mesh> FOAM_HOST_DEVICE bool ends_on_wall(const Mesh& mesh, Index film) {
  return mesh.pinned(mesh.start(2 * film)) || mesh.pinned(mesh.end(2 * film));
}

} // namespace detail

/// Whether the bubbles along a film have more than three sides, so that a swap leaves each three or
/// more: three-sided bubbles vanish by T2. Beside a container's wall two are enough, the wall and a
/// film.
template <class Mesh> FOAM_HOST_DEVICE bool spares_sides(const Mesh& mesh, Index film) {
  const Index needed = detail::ends_on_wall(mesh, film) ? 3 : 4;
  const auto spares = [&](Index b) { return b == kWorld || mesh.sides[Mesh::size(b)] >= needed; };
  return spares(mesh.left(2 * film)) && spares(mesh.right(2 * film));
}

/// Whether the films at the ends of a short film pull it shut, and would pull the swapped film
/// open: the physics of a T1, which a rule of length alone misses.
///
/// With unit tangents t₁, t₂ at one end and t₃, t₄ at the other, t₁ and t₄ on the same side, the
/// film's own tension 1 is overcome by the pairs across it if |t₁ + t₄| > 1, and they pull harder
/// than those along it if |t₁ + t₄| > |t₁ + t₂|. The same must hold on the other side and at the
/// other end. A film that ends on the wall of a container is pulled shut by whatever shortens it.
template <class Mesh> FOAM_HOST_DEVICE bool pulled_shut(const Mesh& mesh, Index film) {
  const Index h = 2 * film;
  const Index t = h + 1;
  if (detail::ends_on_wall(mesh, film)) {
    return true;
  }
  const Vec2 t1 = mesh.tangent(mesh.next_around_junction(h));
  const Vec2 t2 = mesh.tangent(mesh.previous_around_junction(h));
  const Vec2 t3 = mesh.tangent(mesh.next_around_junction(t));
  const Vec2 t4 = mesh.tangent(mesh.previous_around_junction(t));
  const double across = std::min(norm(t1 + t4), norm(t2 + t3));
  const double along = std::max(norm(t1 + t2), norm(t3 + t4));
  return across > std::max(1.0, along);
}

} // namespace foam
