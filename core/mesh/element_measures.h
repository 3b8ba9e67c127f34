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

/// The tensions of a junction's films, N/cm.
template <class Mesh>
FOAM_HOST_DEVICE std::array<double, 3> tensions_at(const Mesh& mesh, Junction junction) {
  const std::array<Half, 3>& halves = mesh.junction_half[junction];
  return {mesh.tension(halves[0].film()), mesh.tension(halves[1].film()),
          mesh.tension(halves[2].film())};
}

/// Whether a junction can hold three tensions: each is less than the other two together.
FOAM_HOST_DEVICE inline bool can_balance(const std::array<double, 3>& tension) {
  const auto [a, b, c] = tension;
  return a < b + c && b < c + a && c < a + b;
}

/// The angle between two films in equilibrium with a third, in Neumann's triangle of their tensions
/// (rad): cos θ₁₂ = (T₃² − T₁² − T₂²)/(2·T₁·T₂), 120° for equal ones.
FOAM_HOST_DEVICE inline double neumann_angle(double first, double second, double third) {
  if (first == second && second == third) {
    return 2 * std::numbers::pi / 3;
  }
  const double cosine = (third * third - first * first - second * second) / (2 * first * second);
  return std::acos(std::clamp(cosine, -1.0, 1.0));
}

/// What a junction's films pull with in all, Σ T·t, as far as it may move, N/cm: zero in
/// equilibrium.
template <class Mesh> FOAM_APART Vec2 force_imbalance(const Mesh& mesh, Junction junction) {
  if (mesh.on_wall(junction)) {
    const Half h = mesh.off_wall(junction);
    return mesh.freedom(junction).of(mesh.tension(h.film()) * mesh.tangent(h));
  }
  Vec2 sum;
  for (const Half h : mesh.junction_half[junction]) {
    sum += mesh.tension(h.film()) * mesh.tangent(h);
  }
  return sum;
}

/// The angle between a wall and the film that ends there, rad: 90° in equilibrium where it slips.
template <class Mesh> FOAM_HOST_DEVICE double contact_angle(const Mesh& mesh, Junction junction) {
  return angle_from_to(tangent_of(mesh, mesh.place_on_wall(junction)),
                       mesh.tangent(mesh.off_wall(junction)));
}

/// The largest deviation between the films of a junction from the angles that their tensions ask
/// for (rad).
template <class Mesh> FOAM_APART double angle_error(const Mesh& mesh, Junction junction) {
  if (mesh.on_wall(junction)) { // along which it pulls with its cosine
    const Vec2 pull = mesh.freedom(junction).of(mesh.tangent(mesh.off_wall(junction)));
    return std::asin(std::min(norm(pull), 1.0));
  }
  const std::array<Half, 3>& halves = mesh.junction_half[junction];
  const std::array<Vec2, 3> tangents{mesh.tangent(halves[0]), mesh.tangent(halves[1]),
                                     mesh.tangent(halves[2])};
  const std::array<double, 3> tension = tensions_at(mesh, junction);
  double largest = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const std::size_t next = (k + 1) % 3;
    const double angle = angle_from_to(tangents[k], tangents[next]);
    const double positive = angle < 0 ? angle + 2 * std::numbers::pi : angle;
    const double asked = neumann_angle(tension[k], tension[next], tension[(k + 2) % 3]);
    largest = std::max(largest, std::abs(positive - asked));
  }
  return largest;
}

/// The length of a film of tension 2γ that has the energy of this one (cm): 0 if it is gone, or a
/// piece of a wall.
template <class Mesh> FOAM_HOST_DEVICE double tense_length(const Mesh& mesh, Film film) {
  return mesh.bends(film) ? mesh.relative_tension(film) * mesh.length(film.half()) : 0;
}

/// |A − A^τ|/A^τ of a bubble.
template <class Mesh> FOAM_HOST_DEVICE double area_error(const Mesh& mesh, Bubble bubble) {
  const double target = mesh.target_area[bubble];
  return std::abs(mesh.area(bubble) - target) / target;
}

/// |2 sin α − q·d/T| of a film that bends, of a radius that is at least half its chord.
template <class Mesh> FOAM_HOST_DEVICE double curvature_error(const Mesh& mesh, Film film) {
  const Half h = film.half();
  const double asked = mesh.pressure_difference(h) * norm(mesh.chord(h)) / mesh.tension(film);
  return std::abs(2 * std::sin(mesh.half_angle(h)) - std::clamp(asked, -2.0, 2.0));
}

/// Whether the films leave a junction in counter-clockwise order; on a wall, whether one leaves to
/// the foam's side, which at an edge is that of either piece.
template <class Mesh> FOAM_APART bool counter_clockwise(const Mesh& mesh, Junction junction) {
  if (mesh.on_wall(junction)) {
    const WallPlace at = mesh.place_on_wall(junction);
    const WallPiece& before = mesh.wall_piece[neighbour_piece(mesh, at.piece, -1)];
    return contact_angle(mesh, junction) > 0 ||
           (at.place == 0 && starts_at_edge(mesh, at.piece) &&
            cross(before.tangent(before.length()), mesh.tangent(mesh.off_wall(junction))) > 0);
  }
  const std::array<Half, 3>& halves = mesh.junction_half[junction];
  const Vec2 first = mesh.tangent(halves[0]);
  const double second = angle_from_to(first, mesh.tangent(halves[1]));
  const double third = angle_from_to(first, mesh.tangent(halves[2]));
  const auto positive = [](double x) { return x < 0 ? x + 2 * std::numbers::pi : x; };
  return positive(second) < positive(third);
}

} // namespace foam
