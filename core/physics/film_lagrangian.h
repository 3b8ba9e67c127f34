// SPDX-License-Identifier: GPL-3.0-or-later
//
// One film's share of the foam's Lagrangian
//
//   L(x, α, p) = Σ_films T·l − Σ_bubbles p·(A − A^τ)
//
// with the films' tensions T, 2γ for those that have none of their own. The share is
// φ = T·l(d, α) − q·S(d, α) − q·½ a×b, with q = p_left − p_right, the film's ends a and b, its
// chord d = |b − a| and its segment area S: its stationary points are the foam's equilibria. ∂φ/∂α
// = 0 is the Laplace–Young law 2T sin α/d = q, the sum of ∂φ/∂x over a junction's films is
// Plateau's balance of tensions, that of ∂φ/∂p over a bubble's films its area.
#pragma once

#include <array>
#include <cmath>

#include "geometry/arc.h"
#include "mesh/ids.h"
#include "mesh/surroundings.h"

namespace foam {

/// Derivatives of φ by a film's local unknowns (a_x, a_y, b_x, b_y, p_left, p_right, α), in this
/// order. The pressures' part of the gradient is left to the bubbles, whose areas are summed as
/// loops.
struct FilmLagrangian {
  static constexpr std::size_t kVariables = 7;
  static constexpr std::size_t kAngle = 6;
  /// One figure for each.
  template <class T> using Each = std::array<T, kVariables>;

  Each<double> gradient{};
  Each<Each<double>> hessian{}; ///< symmetric, both triangles filled
};

/// What belongs to a film's variables, in the order of FilmLagrangian.
/// \param of_junction of_junction(junction) has x and y; \param of_bubble of_bubble(bubble), be it
/// an outside
template <class Mesh, class OfJunction, class OfBubble>
FOAM_HOST_DEVICE FilmLagrangian::Each<double>
film_variables(const Mesh& mesh, Film film, const OfJunction& of_junction,
               const OfBubble& of_bubble, double of_angle) {
  const Half h = film.half();
  const Vec2 start = of_junction(mesh.start(h));
  const Vec2 end = of_junction(mesh.end(h));
  return {start.x, start.y, end.x, end.y, of_bubble(mesh.left(h)), of_bubble(mesh.right(h)),
          of_angle};
}

/// φ's derivatives by (a_x, a_y, b_x, b_y, α).
struct FilmForces {
  std::array<double, 4> ends{};
  double angle = 0;
  double along = 0; ///< ∂φ/∂d
};

/// \param chord from a to b, cm; \param unit the same, of length 1; \param d its length, cm; \param
/// q p_left − p_right, N/cm²; \param tension T, N/cm.
FOAM_HOST_DEVICE inline FilmForces film_forces(Vec2 chord, Vec2 unit, double d,
                                               const ArcShape& shape, double q, double tension) {
  FilmForces forces;
  forces.along = tension * shape.f - 2 * q * d * shape.g;
  forces.angle = tension * d * shape.f1 - q * d * d * shape.g1;
  const Vec2 along = forces.along * unit;
  // ∂(½ a×b) is ½(D_y, −D_x) at either end, once summed over a bubble's closed loop.
  const Vec2 polygon{0.5 * chord.y, -0.5 * chord.x};
  forces.ends = {-along.x - q * polygon.x, -along.y - q * polygon.y, along.x - q * polygon.x,
                 along.y - q * polygon.y};
  return forces;
}

/// \param chord from a to b, cm; \param alpha half-angle, rad; \param q p_left − p_right, N/cm²;
/// \param tension T, N/cm.
FOAM_HOST_DEVICE inline FilmLagrangian film_lagrangian(Vec2 chord, double alpha, double q,
                                                       double tension) {
  const double d = norm(chord);
  const Vec2 u = (1 / d) * chord;
  const ArcShape s = arc_shape(alpha);

  const FilmForces forces = film_forces(chord, u, d, s, q, tension);
  const double phi_dd = -2 * q * s.g;
  const double phi_d_alpha = tension * s.f1 - 2 * q * d * s.g1;
  const double phi_alpha_alpha = tension * d * s.f2 - q * d * d * s.g2;
  const double area_d = 2 * d * s.g; // of the segment
  const double area_alpha = d * d * s.g1;
  const Vec2 polygon{0.5 * chord.y, -0.5 * chord.x};

  FilmLagrangian r;
  for (std::size_t i = 0; i < 4; ++i) {
    r.gradient[i] = forces.ends[i];
  }
  r.gradient[FilmLagrangian::kAngle] = forces.angle;

  const double across = forces.along / d;
  const double xx = phi_dd * u.x * u.x + across * u.y * u.y;
  const double yy = phi_dd * u.y * u.y + across * u.x * u.x;
  const double xy = (phi_dd - across) * u.x * u.y;
  const double half_q = 0.5 * q; // of −q·½ a×b, which couples a_x with b_y and a_y with b_x
  r.hessian[0] = {xx, xy, -xx, -xy - half_q, 0, 0, -phi_d_alpha * u.x};
  r.hessian[1] = {xy, yy, -xy + half_q, -yy, 0, 0, -phi_d_alpha * u.y};
  r.hessian[2] = {-xx, -xy + half_q, xx, xy, 0, 0, phi_d_alpha * u.x};
  r.hessian[3] = {-xy - half_q, -yy, xy, yy, 0, 0, phi_d_alpha * u.y};
  r.hessian[6] = {-phi_d_alpha * u.x, -phi_d_alpha * u.y, phi_d_alpha * u.x, phi_d_alpha * u.y,
                  -area_alpha,        area_alpha,         phi_alpha_alpha};
  const FilmLagrangian::Each<double> area{-area_d * u.x + polygon.x,
                                          -area_d * u.y + polygon.y,
                                          area_d * u.x + polygon.x,
                                          area_d * u.y + polygon.y,
                                          0,
                                          0,
                                          area_alpha};
  for (std::size_t i = 0; i < FilmLagrangian::kVariables; ++i) {
    r.hessian[4][i] = r.hessian[i][4] = -area[i];
    r.hessian[5][i] = r.hessian[i][5] = area[i];
  }
  return r;
}

/// Keeps an end of a film to a curve, or where it is: of its second derivatives those along the
/// curve remain. With X(s) on a curve of tangent t, normal n and curvature k, ∂²φ/∂s² is
/// t·∂²φ/∂x²·t + k·n·∂φ/∂x. The position across, which does not change, has an equation of its own.
/// \param end 0 the start, 1 the end; \param bend k·n·∂φ/∂x; \param stiffness of that equation,
/// both N/cm²
template <std::size_t Size>
FOAM_HOST_DEVICE void keep_to_curve(std::array<std::array<double, Size>, Size>& hessian,
                                    std::size_t end, const Freedom& curve, double bend,
                                    double stiffness) {
  const std::size_t x = 2 * end;
  const std::size_t y = x + 1;
  for (std::array<double, Size>& row : hessian) {
    const Vec2 kept = curve.of({row[x], row[y]});
    row[x] = kept.x;
    row[y] = kept.y;
  }
  for (std::size_t i = 0; i < Size; ++i) {
    const Vec2 kept = curve.of({hessian[x][i], hessian[y][i]});
    hessian[x][i] = kept.x;
    hessian[y][i] = kept.y;
  }
  const Vec2 t = curve.tangent();
  const Vec2 rest_x = Vec2{1, 0} - curve.of({1, 0}); // what is not along the curve
  const Vec2 rest_y = Vec2{0, 1} - curve.of({0, 1});
  hessian[x][x] += bend * t.x * t.x + stiffness * rest_x.x;
  hessian[x][y] += bend * t.x * t.y + stiffness * rest_y.x;
  hessian[y][x] += bend * t.x * t.y + stiffness * rest_x.y;
  hessian[y][y] += bend * t.y * t.y + stiffness * rest_y.y;
}

/// k·n·∂φ/∂x.
FOAM_HOST_DEVICE inline double bend_of(const Freedom& curve, Vec2 gradient) {
  return curve.curvature() * dot(left_normal(curve.tangent()), gradient);
}

/// Keeps an end of a film to a curve with both its derivatives: ∂φ/∂s is t·∂φ/∂x.
FOAM_HOST_DEVICE inline void keep_to_curve(FilmLagrangian& film, std::size_t end,
                                           const Freedom& curve, double stiffness) {
  const std::size_t x = 2 * end;
  const Vec2 gradient{film.gradient[x], film.gradient[x + 1]};
  film.gradient[x] = curve.of(gradient).x;
  film.gradient[x + 1] = curve.of(gradient).y;
  keep_to_curve(film.hessian, end, curve, bend_of(curve, gradient), stiffness);
}

/// Takes α out of the derivatives: α follows the other unknowns so that ∂φ/∂α stays what Newton's
/// step makes it, zero (static condensation). \pre ∂²φ/∂α² is safely away from 0.
FOAM_HOST_DEVICE inline void eliminate_angle(FilmLagrangian& film) {
  constexpr std::size_t k = FilmLagrangian::kAngle;
  const double pivot = film.hessian[k][k];
  for (std::size_t i = 0; i < k; ++i) {
    const double factor = film.hessian[i][k] / pivot;
    film.gradient[i] -= factor * film.gradient[k];
    for (std::size_t j = 0; j < k; ++j) {
      film.hessian[i][j] -= factor * film.hessian[k][j];
    }
  }
}

/// The change of an eliminated α that goes with one of the other variables. \param gradient ∂φ/∂α,
/// which it takes away; \param row ∂²φ/∂α² and before it those by α and the others.
FOAM_HOST_DEVICE inline double eliminated_angle(double gradient, const double* row,
                                                const FilmLagrangian::Each<double>& change) {
  double sum = gradient;
  for (std::size_t k = 0; k < FilmLagrangian::kAngle; ++k) {
    sum += row[k] * change[k];
  }
  return -sum / row[FilmLagrangian::kAngle];
}

} // namespace foam
