// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton's equations of LagrangianSystem for a whole foam, without a matrix: one thread a film
// takes its second derivatives, half-angle eliminated, and a product gathers them, one thread a
// junction or a bubble.
//
// A vector has all junctions' displacements (x, y), in units of the bubbles' mean spacing ℓ, then
// all bubbles' pressures in units of T/ℓ. Elements that are absent or held have zeros.
#pragma once

#include <algorithm>
#include <cmath>

#include "equilibrium/displacements.h"
#include "mesh/foam_view.h"
#include "physics/film_lagrangian.h"

namespace foam::newton {

/// What the equations are made dimensionless by.
struct Units {
  double length = 1;  ///< ℓ, cm
  double tension = 1; ///< T = 2γ, N

  FOAM_HOST_DEVICE double pressure() const { return tension / length; }
};

FOAM_HOST_DEVICE inline bool moves(const FoamView& mesh, Index junction) {
  return mesh.has_junction(junction) && !mesh.pinned(junction);
}

FOAM_HOST_DEVICE inline bool bends(const FoamView& mesh, Index film) {
  return mesh.has_film(film) && !mesh.wall(2 * film);
}

/// Length of a vector.
inline Index size_of(const FoamView& mesh) {
  return 2 * mesh.junctions + mesh.bubbles;
}

/// Of a bubble or the world.
FOAM_HOST_DEVICE inline double pressure_in(const FoamView& mesh, const double* vector,
                                           Index bubble) {
  return bubble == kWorld ? 0 : vector[2 * mesh.junctions + bubble];
}

/// Dimensionless derivatives of a film's φ, half-angle not eliminated yet.
/// \param stiffening what is added to the energy's second derivatives, in units of a stretched
/// film's: 0 for Newton's own equations; with 1 the films are springs, and the matrix that of a
/// minimum wherever the foam is. ∂²φ/∂α² is kept away from 0, where arcs of 90° have it.
FOAM_HOST_DEVICE inline FilmLagrangian film_derivatives(const FoamView& mesh, Index film,
                                                        const Units& units, double stiffening) {
  constexpr double kSmallestPivot = 0.1; // of d
  const Index h = 2 * film;
  const Vec2 chord = (1 / units.length) * mesh.chord(h);
  const double q =
      (mesh.pressure_of(mesh.left(h)) - mesh.pressure_of(mesh.right(h))) / units.pressure();
  FilmLagrangian phi = film_lagrangian(chord, mesh.half_angle(h), q, 1);
  const double d = norm(chord);
  const std::array<double, 4> along{-chord.x / d, -chord.y / d, chord.x / d, chord.y / d};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      phi.hessian[i][k] += stiffening / d * along[i] * along[k];
    }
  }
  double& pivot = phi.hessian[FilmLagrangian::kAngle][FilmLagrangian::kAngle];
  pivot += stiffening * d;
  const double smallest = kSmallestPivot * d;
  pivot = pivot < 0 ? std::min(pivot, -smallest) : std::max(pivot, smallest);
  return phi;
}

/// A film's second derivatives, half-angle eliminated, seen from its half-film 2f; those from
/// 2f + 1 differ in the sign of `jump` and `polygon`.
struct FilmStiffness {
  double xx = 0, xy = 0, yy = 0; ///< ∂²φ/∂D²
  double jump = 0;               ///< ½q, of φ's −q·½ a×b
  Vec2 segment;                  ///< how the segment's area grows with D
  Vec2 polygon;                  ///< how ½ a×b grows with either end
  double compliance = 0;         ///< how the segment's area grows with q

  FOAM_HOST_DEVICE Vec2 times(Vec2 v) const { return {xx * v.x + xy * v.y, xy * v.x + yy * v.y}; }
  /// How the area on the left of h grows as h's start moves.
  FOAM_HOST_DEVICE Vec2 start_slope(Index h) const {
    return (h & 1 ? -polygon : polygon) - segment;
  }
  /// The same of h's end.
  FOAM_HOST_DEVICE Vec2 end_slope(Index h) const { return (h & 1 ? -polygon : polygon) + segment; }
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

/// The matrix K of Newton's equations.
struct WholeFoamMatrix {
  FoamView mesh;
  const FilmStiffness* film = nullptr; ///< by film; zeros for those of a wall

  FOAM_HOST_DEVICE Vec2 junction_row(const double* x, Index junction) const {
    Vec2 sum;
    if (!moves(mesh, junction)) {
      return sum;
    }
    const Vec2 own = displacement(x, junction);
    for (const Index h : mesh.junction_half[FoamView::size(junction)]) {
      const FilmStiffness& f = film[FoamView::film_of(h)];
      const Vec2 other = displacement(x, mesh.end(h));
      const double q = pressure_in(mesh, x, mesh.left(h)) - pressure_in(mesh, x, mesh.right(h));
      sum += f.times(own - other) + (h & 1 ? -f.jump : f.jump) * left_normal(other) -
             q * f.start_slope(h);
    }
    return sum;
  }

  FOAM_HOST_DEVICE double bubble_row(const double* x, Index bubble) const {
    if (!mesh.has_bubble(bubble)) {
      return 0;
    }
    const double own = pressure_in(mesh, x, bubble);
    double growth = 0;
    for_each_half(mesh, bubble, [&](Index h) {
      const FilmStiffness& f = film[FoamView::film_of(h)];
      growth += dot(f.start_slope(h), displacement(x, mesh.start(h))) +
                dot(f.end_slope(h), displacement(x, mesh.end(h))) +
                f.compliance * (own - pressure_in(mesh, x, mesh.right(h)));
    });
    return -growth;
  }
};

/// y ← K·x, one index a junction, then one a bubble.
struct Multiply {
  WholeFoamMatrix matrix;
  const double* x = nullptr;
  double* y = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    const Index junctions = matrix.mesh.junctions;
    if (i < junctions) {
      set_displacement(y, i, matrix.junction_row(x, i));
    } else {
      y[junctions + i] = matrix.bubble_row(x, i - junctions);
    }
  }
};

/// What a film adds to the right-hand side, half-angle eliminated, seen from its half-film 2f.
struct FilmGradient {
  Vec2 start, end;
  double left = 0; ///< by the pressure on the left, and its negative by that on the right
};

FOAM_HOST_DEVICE inline FilmGradient film_gradient(FilmLagrangian phi) {
  eliminate_angle(phi);
  return {{phi.gradient[0], phi.gradient[1]}, {phi.gradient[2], phi.gradient[3]}, phi.gradient[4]};
}

struct Linearise {
  FoamView mesh;
  Units units;
  double stiffening = 0;
  FilmStiffness* stiffness = nullptr;
  FilmGradient* gradient = nullptr;

  FOAM_HOST_DEVICE void operator()(Index film) const {
    stiffness[film] = {};
    gradient[film] = {};
    if (bends(mesh, film)) {
      const FilmLagrangian phi = film_derivatives(mesh, film, units, stiffening);
      stiffness[film] = film_stiffness(phi);
      gradient[film] = film_gradient(phi);
    }
  }
};

/// The right-hand side of Newton's equations, that is minus the gradient, one index a junction,
/// then one a bubble.
struct RightHandSide {
  FoamView mesh;
  Units units;
  const FilmGradient* gradient = nullptr;
  double* to = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    if (i < mesh.junctions) {
      set_displacement(to, i, force(i));
    } else {
      to[mesh.junctions + i] = excess(i - mesh.junctions);
    }
  }

private:
  FOAM_HOST_DEVICE Vec2 force(Index junction) const {
    Vec2 sum;
    if (moves(mesh, junction)) {
      for (const Index h : mesh.junction_half[FoamView::size(junction)]) {
        const FilmGradient& film = gradient[FoamView::film_of(h)];
        sum -= h & 1 ? film.end : film.start;
      }
    }
    return sum;
  }

  /// A − A^τ as far as one step asks for it, with what the eliminated angles make of it.
  FOAM_HOST_DEVICE double excess(Index bubble) const {
    constexpr double kLargestGrowth = 0.5; // of a bubble's area
    if (!mesh.has_bubble(bubble)) {
      return 0;
    }
    const double area = mesh.area(bubble);
    const double largest = kLargestGrowth * std::abs(area);
    double sum = std::clamp(area - mesh.target_area[bubble], -largest, largest) /
                 (units.length * units.length);
    for_each_half(mesh, bubble, [&](Index h) {
      const double left = gradient[FoamView::film_of(h)].left;
      sum -= h & 1 ? -left : left;
    });
    return sum;
  }
};

/// How the eliminated half-angle of a film answers to a solution, rad.
FOAM_HOST_DEVICE inline double angle_change(const FoamView& mesh, Index film, const Units& units,
                                            double stiffening, const double* solution) {
  constexpr auto k = FilmLagrangian::kAngle;
  const Index h = 2 * film;
  const FilmLagrangian phi = film_derivatives(mesh, film, units, stiffening);
  const Vec2 a = displacement(solution, mesh.start(h));
  const Vec2 b = displacement(solution, mesh.end(h));
  const std::array<double, 6> local{a.x,
                                    a.y,
                                    b.x,
                                    b.y,
                                    pressure_in(mesh, solution, mesh.left(h)),
                                    pressure_in(mesh, solution, mesh.right(h))};
  double sum = phi.gradient[k];
  for (std::size_t i = 0; i < local.size(); ++i) {
    sum += phi.hessian[k][i] * local[i];
  }
  return -sum / phi.hessian[k][k];
}

} // namespace foam::newton
