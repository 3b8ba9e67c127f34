// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far single elements of a mesh are from equilibrium, and from being possible.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "mesh/mesh_access.h"

namespace foam {

/// The largest deviation from 120° between the films of a junction (rad).
template <class Mesh> FOAM_HOST_DEVICE double angle_error(const Mesh& mesh, Index junction) {
  const std::array<Index, 3>& halves = mesh.junction_half[Mesh::size(junction)];
  const std::array<Vec2, 3> tangents{mesh.tangent(halves[0]), mesh.tangent(halves[1]),
                                     mesh.tangent(halves[2])};
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double angle = angle_from_to(tangents[k], tangents[(k + 1) % 3]);
    const double positive = angle < 0 ? angle + 2 * std::numbers::pi : angle;
    largest = std::max(largest, std::abs(positive - 2 * std::numbers::pi / 3));
  }
  return largest;
}

/// The length by which a film adds to the foam's energy (cm): none if it is gone, or a piece of the
/// wall of a sealed container.
template <class Mesh> FOAM_HOST_DEVICE double tense_length(const Mesh& mesh, Index film) {
  return mesh.has_film(film) && !mesh.wall(2 * film) ? mesh.length(2 * film) : 0;
}

/// |A − A^τ|/A^τ of a bubble.
template <class Mesh> FOAM_HOST_DEVICE double area_error(const Mesh& mesh, Index bubble) {
  const double target = mesh.target_area[Mesh::size(bubble)];
  return std::abs(mesh.area(bubble) - target) / target;
}

/// Whether the films leave a junction in counter-clockwise order.
template <class Mesh> FOAM_HOST_DEVICE bool counter_clockwise(const Mesh& mesh, Index junction) {
  const std::array<Index, 3>& halves = mesh.junction_half[Mesh::size(junction)];
  const Vec2 first = mesh.tangent(halves[0]);
  const double second = angle_from_to(first, mesh.tangent(halves[1]));
  const double third = angle_from_to(first, mesh.tangent(halves[2]));
  const auto positive = [](double x) { return x < 0 ? x + 2 * std::numbers::pi : x; };
  return positive(second) < positive(third);
}

} // namespace foam
