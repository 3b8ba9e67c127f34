// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton's equations for a whole foam without a matrix, on an executor (parallel/host.h): one
// thread a film takes its second derivatives, half-angle eliminated, and a product gathers them,
// one thread a junction or a bubble.
//
// A vector has all junctions' displacements (x, y), in units of the bubbles' mean spacing ℓ, then
// all bubbles' pressures in units of T/ℓ. Elements that are absent or held have zeros.
#pragma once

#include <algorithm>
#include <cmath>

#include "algebra/displacements.h"
#include "equilibrium/evaluation.h"
#include "parallel/kernels.h"
#include "physics/film_stiffness.h"

namespace foam::newton {

/// Length of a vector.
inline Index size_of(const ConstFoamView& mesh) {
  return 2 * mesh.junctions + mesh.bubbles;
}

/// The pressures of a vector.
template <class Value>
FOAM_HOST_DEVICE FieldView<Bubble, Value> pressures_of(const ConstFoamView& mesh, Value* vector) {
  return FieldView<Bubble, Value>(vector + 2 * std::ptrdiff_t{mesh.junctions});
}

/// Of a bubble or an outside.
FOAM_HOST_DEVICE inline double pressure_in(const ConstFoamView& mesh, const double* vector,
                                           Bubble bubble) {
  return bubble.is_outside() ? 0 : pressures_of(mesh, vector)[bubble];
}

/// Dimensionless derivatives of a film's φ, half-angle not eliminated yet.
/// \param convexification what is added to the energy's second derivatives, in units of a stretched
/// film's: 0 for Newton's own equations; with 1 the films are convexification, and the matrix that
/// of a minimum wherever the foam is. ∂²φ/∂α² is kept away from 0, where arcs of 90° have it.
FOAM_HOST_DEVICE inline FilmLagrangian
film_derivatives(const ConstFoamView& mesh, Film film, const Units& units, double convexification) {
  constexpr double kSmallestPivot = 0.1; // of the tension times d
  const Half h = film.half();
  const Vec2 chord = (1 / units.length) * mesh.chord(h);
  const double q = mesh.pressure_difference(h) / units.pressure();
  const double tension = mesh.relative_tension(film);
  FilmLagrangian phi = film_lagrangian(chord, mesh.half_angle(h), q, tension);
  const double d = norm(chord);
  const std::array<double, 4> along{-chord.x / d, -chord.y / d, chord.x / d, chord.y / d};
  for (std::size_t i = 0; i < 4; ++i) {
    for (std::size_t k = 0; k < 4; ++k) {
      phi.hessian[i][k] += convexification * tension / d * along[i] * along[k];
    }
  }
  double& pivot = phi.hessian[FilmLagrangian::kAngle][FilmLagrangian::kAngle];
  pivot += convexification * tension * d;
  const double smallest = kSmallestPivot * tension * d;
  pivot = pivot < 0 ? std::min(pivot, -smallest) : std::max(pivot, smallest);
  return phi;
}

/// The matrix K of Newton's equations.
struct WholeFoamMatrix {
  ConstFoamView mesh;
  FieldView<Film, const FilmStiffness> film;    ///< zeros for those of a wall
  FieldView<Film, const FilmGradient> gradient; ///< of which walls that are curved make stiffness
  double length = 1;                            ///< ℓ, cm

  FOAM_HOST_DEVICE Vec2 junction_row(const double* x, Junction junction) const {
    Vec2 sum;
    if (!mesh.moves(junction)) {
      return sum;
    }
    const Vec2 own = displacement(x, junction);
    for (const Half h : mesh.junction_half[junction]) {
      const FilmStiffness& f = film[h.film()];
      const Vec2 other = displacement(x, mesh.end(h));
      const double q = pressure_in(mesh, x, mesh.left(h)) - pressure_in(mesh, x, mesh.right(h));
      sum += f.times(own - other) + (h.reversed() ? -f.jump : f.jump) * left_normal(other) -
             q * f.start_slope(h);
    }
    return mesh.on_wall(junction) ? along_wall(sum, own, junction) : sum;
  }

  /// A film's second derivatives, in the order of FilmLagrangian, with ends kept to walls.
  FOAM_HOST_DEVICE std::array<std::array<double, 6>, 6> film_matrix(Film f) const {
    auto entries = film[f].matrix();
    for (const Half h : {f.half(), f.half().twin()}) {
      const Junction junction = mesh.start(h);
      if (mesh.on_wall(junction) && mesh.moves(junction) && mesh.bends(f)) {
        keep_to_wall(entries, h);
      }
    }
    return entries;
  }

  FOAM_HOST_DEVICE double bubble_row(const double* x, Bubble bubble) const {
    if (!mesh.has_bubble(bubble)) {
      return 0;
    }
    const double own = pressure_in(mesh, x, bubble);
    double growth = 0;
    for_each_half(mesh, bubble, [&](Half h) {
      const FilmStiffness& f = film[h.film()];
      growth += dot(f.start_slope(h), displacement(x, mesh.start(h))) +
                dot(f.end_slope(h), displacement(x, mesh.end(h))) +
                f.compliance * (own - pressure_in(mesh, x, mesh.right(h)));
    });
    return -growth;
  }

private:
  FOAM_APART Vec2 along_wall(Vec2 sum, Vec2 own, Junction junction) const {
    const Freedom freedom = mesh.freedom(junction);
    return freedom.of(sum) + bend(mesh.off_wall(junction), freedom) * freedom.of(own);
  }
  FOAM_APART void keep_to_wall(std::array<std::array<double, 6>, 6>& entries, Half h) const {
    const Freedom freedom = mesh.freedom(mesh.start(h));
    keep_to_curve(entries, h.reversed() ? 1 : 0, freedom, bend(h, freedom), 1);
  }
  /// What a curved wall adds to the stiffness along it. \param h the film that ends there
  FOAM_HOST_DEVICE double bend(Half h, const Freedom& freedom) const {
    const FilmGradient& g = gradient[h.film()];
    return length * bend_of(freedom, h.reversed() ? g.end : g.start);
  }
};

/// to ← K·x
template <class Executor>
void multiply(Executor& executor, const WholeFoamMatrix& matrix, const double* x, double* to) {
  const Index junctions = matrix.mesh.junctions;
  executor.for_each(
      junctions + matrix.mesh.bubbles, FOAM_KERNEL(Index i) {
        if (i < junctions) {
          set_displacement(to, Junction(i), matrix.junction_row(x, Junction(i)));
        } else {
          to[junctions + i] = matrix.bubble_row(x, Bubble(i - junctions));
        }
      });
}

/// Takes the derivatives of all films.
template <class Executor>
void linearise(Executor& executor, const ConstFoamView& mesh, const Units& units,
               double convexification, const FieldView<Film, FilmStiffness>& stiffness,
               const FieldView<Film, FilmGradient>& gradient) {
  executor.for_each(
      mesh.film_slots(), FOAM_KERNEL(Film f) {
        stiffness[f] = {};
        gradient[f] = {};
        if (mesh.bends(f)) {
          const FilmLagrangian phi = film_derivatives(mesh, f, units, convexification);
          stiffness[f] = film_stiffness(phi);
          gradient[f] = film_gradient(phi);
        }
      });
}

/// The right-hand side of Newton's equations, that is minus the gradient, with what the eliminated
/// angles make of it: what is left of equilibrium at junctions, and bubbles' excesses of area as
/// far as one step asks for them. \param areas of the bubbles, cm²
template <class Executor>
void gather_load(Executor& executor, const ConstFoamView& mesh, const Units& units,
                 const FieldView<Bubble, const double>& areas,
                 const FieldView<Film, const FilmGradient>& gradient, double* to) {
  const FieldView<Bubble, double> pressures = pressures_of(mesh, to);
  executor.for_each(
      mesh.junction_slots(), FOAM_KERNEL(Junction j) {
        Vec2 sum;
        if (mesh.moves(j)) {
          for (const Half h : mesh.junction_half[j]) {
            const FilmGradient& film = gradient[h.film()];
            sum -= h.reversed() ? film.end : film.start;
          }
          sum = mesh.freedom(j).of(sum);
        }
        set_displacement(to, j, sum);
      });
  executor.for_each(
      mesh.bubble_slots(), FOAM_KERNEL(Bubble b) {
        double sum = 0;
        if (mesh.has_bubble(b)) {
          sum = bounded_excess(mesh, areas, b) / units.area();
          for_each_half(mesh, b, [&](Half h) {
            const double left = gradient[h.film()].left;
            sum -= h.reversed() ? -left : left;
          });
        }
        pressures[b] = sum;
      });
}

/// How the eliminated half-angle of a film answers to a solution, rad.
FOAM_HOST_DEVICE inline double angle_change(const ConstFoamView& mesh, Film film,
                                            const Units& units, double convexification,
                                            const double* solution) {
  constexpr auto k = FilmLagrangian::kAngle;
  const FilmLagrangian phi = film_derivatives(mesh, film, units, convexification);
  const auto change = film_variables(
      mesh, film, [&](Junction j) { return displacement(solution, j); },
      [&](Bubble b) { return pressure_in(mesh, solution, b); }, 0);
  return eliminated_angle(phi.gradient[k], phi.hessian[k].data(), change);
}

/// The step that a solution is.
template <class Executor>
void take_step(Executor& executor, const ConstFoamView& mesh, const Units& units,
               double convexification, const double* solution, const StepView& step) {
  executor.for_each(
      mesh.junction_slots(),
      FOAM_KERNEL(Junction j) { step.junction[j] = units.length * displacement(solution, j); });
  executor.for_each(
      mesh.bubble_slots(), FOAM_KERNEL(Bubble b) {
        step.pressure[b] = units.pressure() * pressure_in(mesh, solution, b);
      });
  executor.for_each(
      mesh.film_slots(), FOAM_KERNEL(Film f) {
        step.angle[f] = mesh.bends(f) ? angle_change(mesh, f, units, convexification, solution) : 0;
      });
}

} // namespace foam::newton
