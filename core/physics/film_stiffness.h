// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is left of a film's derivatives (physics/film_lagrangian.h) once its half-angle is
// eliminated, in few numbers.
#pragma once

#include "physics/film_lagrangian.h"

namespace foam {

/// A film's second derivatives, half-angle eliminated, seen from its half(); those from the twin
/// differ in the sign of `jump` and `polygon`.
struct FilmStiffness {
  double xx = 0, xy = 0, yy = 0; ///< ∂²φ/∂D²
  double jump = 0;               ///< ½q, of φ's −q·½ a×b
  Vec2 segment;                  ///< how the segment's area grows with D
  Vec2 polygon;                  ///< how ½ a×b grows with either end
  double compliance = 0;         ///< how the segment's area grows with q

  FOAM_HOST_DEVICE Vec2 times(Vec2 v) const { return {xx * v.x + xy * v.y, xy * v.x + yy * v.y}; }
  /// How the area on the left of h grows as h's start moves.
  FOAM_HOST_DEVICE Vec2 start_slope(Half h) const {
    return (h.reversed() ? -polygon : polygon) - segment;
  }
  /// The same of h's end.
  FOAM_HOST_DEVICE Vec2 end_slope(Half h) const {
    return (h.reversed() ? -polygon : polygon) + segment;
  }
  /// All second derivatives, in the order of FilmLagrangian.
  FOAM_HOST_DEVICE std::array<std::array<double, 6>, 6> matrix() const {
    const Vec2 a = segment - polygon;
    const Vec2 b = -segment - polygon;
    return {{{xx, xy, -xx, -xy - jump, a.x, -a.x},
             {xy, yy, -xy + jump, -yy, a.y, -a.y},
             {-xx, -xy + jump, xx, xy, b.x, -b.x},
             {-xy - jump, -yy, xy, yy, b.y, -b.y},
             {a.x, a.y, b.x, b.y, -compliance, compliance},
             {-a.x, -a.y, -b.x, -b.y, compliance, -compliance}}};
  }
};

FOAM_HOST_DEVICE inline FilmStiffness film_stiffness(FilmLagrangian phi) {
  FilmStiffness film;
  film.jump = -0.5 * (phi.hessian[0][3] - phi.hessian[1][2]);
  eliminate_angle(phi);
  film.xx = phi.hessian[2][2];
  film.xy = phi.hessian[2][3];
  film.yy = phi.hessian[3][3];
  const Vec2 at_start{-phi.hessian[4][0], -phi.hessian[4][1]};
  const Vec2 at_end{-phi.hessian[4][2], -phi.hessian[4][3]};
  film.segment = 0.5 * (at_end - at_start);
  film.polygon = 0.5 * (at_end + at_start);
  film.compliance = phi.hessian[4][5];
  return film;
}

/// What a film adds to the right-hand side, half-angle eliminated, seen from its half().
struct FilmGradient {
  Vec2 start, end;
  double left = 0; ///< by the pressure on the left, and its negative by that on the right
};

FOAM_HOST_DEVICE inline FilmGradient film_gradient(FilmLagrangian phi) {
  eliminate_angle(phi);
  return {{phi.gradient[0], phi.gradient[1]}, {phi.gradient[2], phi.gradient[3]}, phi.gradient[4]};
}

} // namespace foam
