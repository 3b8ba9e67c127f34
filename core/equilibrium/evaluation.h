// SPDX-License-Identifier: GPL-3.0-or-later
//
// A state of a foam as Newton's method sees it: the gradient of the Lagrangian
// (physics/film_lagrangian.h), how large it is, and the merit of the state.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include "equilibrium/step.h"
#include "physics/film_lagrangian.h"

namespace foam::newton {

/// Largest dimensionless residuals of the equilibrium's equations in a domain.
struct Residual {
  double force = 0;     ///< |Σ tensions| at a junction, in units of 2γ
  double curvature = 0; ///< |2 sin α − q·d/T| of a film
  double area = 0;      ///< |A − A^τ|/A^τ of a bubble

  double largest() const {
    constexpr parallel::Larger larger{};
    return larger(larger(force, curvature), area);
  }
};

/// What Newton's equations are made dimensionless by.
struct Units {
  double length = 1;  ///< ℓ, the bubbles' mean spacing, cm
  double tension = 1; ///< T = 2γ, N/cm

  FOAM_HOST_DEVICE double pressure() const { return tension / length; }
  FOAM_HOST_DEVICE double area() const { return length * length; }
  FOAM_HOST_DEVICE double energy() const { return tension * length; }
};

/// A film in a state; what belongs to one of its sides is seen from its half().
struct FilmState {
  FilmForces forces;
  double segment = 0;   ///< area between arc and chord, cm²
  double length = 0;    ///< in which it adds to the energy, in units of 2γ: cm
  double curvature = 0; ///< its residual
};

inline constexpr double kLargestGrowth = 0.5; // of a bubble's area that one step asks for

FOAM_HOST_DEVICE inline FilmState film_state(const ConstFoamView& mesh, Film film) {
  if (!mesh.bends(film)) {
    return {};
  }
  const Half h = film.half();
  const Vec2 chord = mesh.chord(h);
  const double d = norm(chord);
  const ArcShape shape = arc_shape(mesh.half_angle(h));
  const double tension = mesh.tension(film);
  FilmState state;
  state.forces =
      film_forces(chord, (1 / d) * chord, d, shape, mesh.pressure_difference(h), tension);
  state.segment = d * d * shape.g;
  state.length = mesh.relative_tension(film) * (d * shape.f);
  state.curvature = std::abs(state.forces.angle) / (tension * d * shape.g1); // as f′ = 2 sin α · g′
  return state;
}

/// ∂L/∂x of a junction as far as it may move, N/cm. Its films are added up in their order.
FOAM_HOST_DEVICE inline Vec2 junction_force(const ConstFoamView& mesh,
                                            const FieldView<Film, const FilmState>& films,
                                            Junction junction) {
  if (!mesh.moves(junction)) {
    return {};
  }
  const auto force = [&](Half h) {
    const std::array<double, 4>& ends = films[h.film()].forces.ends;
    return h.reversed() ? Vec2{ends[2], ends[3]} : Vec2{ends[0], ends[1]};
  };
  if (mesh.on_wall(junction)) {
    return mesh.freedom(junction).of(force(mesh.off_wall(junction)));
  }
  std::array<Half, 3> halves = mesh.junction_half[junction];
  const auto order = [&](std::size_t a, std::size_t b) {
    if (halves[b] < halves[a]) {
      const Half first = halves[b];
      halves[b] = halves[a];
      halves[a] = first;
    }
  };
  order(0, 1);
  order(1, 2);
  order(0, 1);
  Vec2 sum;
  for (const Half h : halves) {
    sum += force(h);
  }
  return sum;
}

/// Area of a bubble, cm².
FOAM_HOST_DEVICE inline double
area_of(const ConstFoamView& mesh, const FieldView<Film, const FilmState>& films, Bubble bubble) {
  return mesh.area(
      bubble, [&](Film f) { return mesh.wall(f.half()) ? mesh.segment(f) : films[f].segment; });
}

/// A − A^τ as far as one step asks for it, cm².
FOAM_HOST_DEVICE inline double bounded_excess(const ConstFoamView& mesh,
                                              const FieldView<Bubble, const double>& areas,
                                              Bubble bubble) {
  const double largest = kLargestGrowth * std::abs(areas[bubble]);
  return std::clamp(areas[bubble] - mesh.target_area[bubble], -largest, largest);
}

/// On an executor (parallel/host.h).
template <class Executor> class Evaluation {
public:
  /// Evaluates a state; what follows is of it. Arrays are by element, of the domain alone.
  Residual evaluate(Executor& executor, const ConstFoamView& mesh, const Domain& domain) {
    film_.resize(place_of(mesh.films));
    force_.resize(place_of(mesh.junctions));
    area_.resize(place_of(mesh.bubbles));
    const FieldView<Film, FilmState> film(film_.data());
    const FieldView<Junction, Vec2> force(force_.data());
    const FieldView<Bubble, double> area(area_.data());
    const auto films = this->films();
    const double tension = mesh.reference_tension();
    executor.for_each(
        domain.films, FOAM_KERNEL(Film f) { film[f] = film_state(mesh, f); });
    executor.for_each(
        domain.junctions, FOAM_KERNEL(Junction j) { force[j] = junction_force(mesh, films, j); });
    executor.for_each(
        domain.bubbles,
        FOAM_KERNEL(Bubble b) { area[b] = mesh.has_bubble(b) ? area_of(mesh, films, b) : 0; });
    constexpr parallel::Larger larger{};
    return {executor.reduce(
                domain.junctions, 0.0, FOAM_KERNEL(Junction j) { return norm(force[j]) / tension; },
                larger),
            executor.reduce(
                domain.films, 0.0, FOAM_KERNEL(Film f) { return films[f].curvature; }, larger),
            executor.reduce(
                domain.bubbles, 0.0,
                FOAM_KERNEL(Bubble b) {
                  const double target = mesh.target_area[b];
                  return mesh.has_bubble(b) ? std::abs(area[b] - target) / target : 0.0;
                },
                larger)};
  }

  FieldView<Film, const FilmState> films() const {
    return FieldView<Film, const FilmState>(film_.data());
  }
  /// ∂L/∂x, N/cm; 0 for those that are held.
  FieldView<Junction, const Vec2> forces() const {
    return FieldView<Junction, const Vec2>(force_.data());
  }
  FieldView<Bubble, const double> areas() const {
    return FieldView<Bubble, const double>(area_.data());
  }

private:
  template <class T> using Array = typename Executor::template Array<T>;

  Array<FilmState> film_;
  Array<Vec2> force_;  ///< N/cm
  Array<double> area_; ///< cm²
};

/// The exact penalty function of a domain, T·Σl − Σ_rim p·A + μ·Σ|A − A^τ|: films' energy, less the
/// work of bubbles whose pressure is held, and the areas' violation (J. Nocedal, S. J. Wright,
/// Numerical Optimization, 2nd ed., 2006, ch. 18).
template <class Executor> struct Merit {
  Executor& executor;
  ConstFoamView mesh;
  Domain domain;
  double mu = 0; ///< μ

  /// Takes μ above the largest multiplier before and after a step, and large enough for the step to
  /// be a direction of descent (Nocedal & Wright, 18.36).
  void weigh(const Evaluation<Executor>& state, const StepView& step) {
    const ConstFoamView& foam = mesh;
    const double largest = executor.reduce(
        domain.bubbles, 0.0,
        FOAM_KERNEL(Bubble b) {
          if (!foam.has_bubble(b)) {
            return 0.0;
          }
          const double p = foam.pressure[b];
          return std::max(std::abs(p), std::abs(p + step.pressure[b]));
        },
        parallel::Larger{});
    const double growth = executor.reduce( // of the films' energy, in units of 2γ
        domain.films, 0.0,
        FOAM_KERNEL(Film f) {
          return foam.bends(f) ? foam.relative_tension(f) *
                                     arc_growth(foam.chord(f.half()), step.chord_change(foam, f),
                                                foam.half_angle(f.half()), step.angle[f])
                               : 0.0;
        },
        parallel::Add{});
    const double slope = growth * mesh.reference_tension();
    const double descent = slope > 0 ? slope / violation(state) : 0;
    const double floor = 5e-4 * mesh.reference_tension() / domain.spacing;
    mu = 1.5 * std::max(largest, std::isfinite(descent) ? descent : 0) + floor;
  }

  /// Of an evaluated state.
  double operator()(const Evaluation<Executor>& state) const {
    const ConstFoamView& foam = mesh;
    const auto films = state.films();
    const double length = executor.reduce(
        domain.films, 0.0, FOAM_KERNEL(Film f) { return films[f].length; }, parallel::Add{});
    const double work = executor.reduce(
        domain.rim, 0.0, FOAM_KERNEL(Bubble b) { return foam.pressure[b] * foam.area(b); },
        parallel::Add{});
    return mesh.reference_tension() * length - work + mu * violation(state);
  }

  double violation(const Evaluation<Executor>& state) const {
    const ConstFoamView& foam = mesh;
    const auto areas = state.areas();
    return executor.reduce(
        domain.bubbles, 0.0,
        FOAM_KERNEL(Bubble b) {
          return foam.has_bubble(b) ? std::abs(areas[b] - foam.target_area[b]) : 0.0;
        },
        parallel::Add{});
  }
};

} // namespace foam::newton
