// SPDX-License-Identifier: GPL-3.0-or-later
//
// A step of Newton's method, element by element, and how much of it is taken: no film shrinks or
// turns by more than half of its length in one, no arc by more than half a radian
// (physics/step_limits.h).
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "equilibrium/domain.h"
#include "mesh/foam_view.h"
#include "parallel/kernels.h"
#include "physics/step_limits.h"

namespace foam::newton {

/// A value for each junction, film and bubble: a change of the unknowns, or the unknowns.
struct StepView {
  FieldView<Junction, Vec2> junction; ///< cm; zero for those that are held
  FieldView<Film, double> angle;      ///< rad
  FieldView<Bubble, double> pressure; ///< N/cm²

  FOAM_HOST_DEVICE Vec2 chord_change(const ConstFoamView& mesh, Film film) const {
    return junction[mesh.end(film.half())] - junction[mesh.start(film.half())];
  }
};

/// A step's arrays, on an executor (parallel/host.h).
template <class Executor> class Step {
public:
  /// Makes room for a mesh. What is there of it already keeps its values.
  void fit(const ConstFoamView& mesh) {
    junction_.resize(place_of(mesh.junctions));
    angle_.resize(place_of(mesh.films));
    pressure_.resize(place_of(mesh.bubbles));
  }
  StepView view() {
    return {FieldView<Junction, Vec2>(junction_.data()), FieldView<Film, double>(angle_.data()),
            FieldView<Bubble, double>(pressure_.data())};
  }

private:
  typename Executor::template Array<Vec2> junction_;
  typename Executor::template Array<double> angle_, pressure_;
};

/// Moves a junction; a mesh may have gaps.
FOAM_HOST_DEVICE inline void move(FoamView mesh, Junction junction, Vec2 from, Vec2 change) {
  mesh.displace(junction, from, change);
}

/// The state of a domain, to step from and to return to.
template <class Executor>
void save(Executor& executor, const FoamView& mesh, const Domain& domain, const StepView& to) {
  executor.for_each(
      domain.junctions, FOAM_KERNEL(Junction j) { to.junction[j] = mesh.position[j]; });
  executor.for_each(
      domain.films, FOAM_KERNEL(Film f) { to.angle[f] = mesh.film_angle[f]; });
  executor.for_each(
      domain.bubbles, FOAM_KERNEL(Bubble b) { to.pressure[b] = mesh.pressure[b]; });
}

template <class Executor>
void restore(Executor& executor, const FoamView& mesh, const Domain& domain, const StepView& from) {
  executor.for_each(
      domain.junctions, FOAM_KERNEL(Junction j) { move(mesh, j, from.junction[j], {}); });
  executor.for_each(
      domain.films, FOAM_KERNEL(Film f) { mesh.film_angle[f] = from.angle[f]; });
  executor.for_each(
      domain.bubbles, FOAM_KERNEL(Bubble b) { mesh.pressure[b] = from.pressure[b]; });
}

/// The saved state and a fraction of a step.
template <class Executor>
void walk(Executor& executor, const FoamView& mesh, const Domain& domain, const StepView& from,
          const StepView& step, double fraction) {
  executor.for_each(
      domain.junctions,
      FOAM_KERNEL(Junction j) { move(mesh, j, from.junction[j], fraction * step.junction[j]); });
  executor.for_each(
      domain.films,
      FOAM_KERNEL(Film f) { mesh.film_angle[f] = from.angle[f] + fraction * step.angle[f]; });
  executor.for_each(
      domain.bubbles,
      FOAM_KERNEL(Bubble b) { mesh.pressure[b] = from.pressure[b] + fraction * step.pressure[b]; });
}

/// The largest fraction ≤ 1 of a step with which the stretches of a wall beside an end of a film
/// shrink by no more than half of their length.
FOAM_HOST_DEVICE inline double longest_wall_step(const ConstFoamView& mesh, const StepView& step,
                                                 Junction junction) {
  double fraction = 1;
  if (mesh.moves(junction) && mesh.on_wall(junction)) {
    for (const Half h : mesh.junction_half[junction]) {
      if (mesh.wall(h)) {
        const double growth =
            mesh.relative_growth(h, step.junction[junction], step.junction[mesh.end(h)]);
        fraction = growth < -0.5 ? std::min(fraction, -0.5 / growth) : fraction;
      }
    }
  }
  return fraction;
}

/// The largest fraction ≤ 1 of a step that every film of the domain can take.
template <class Executor>
double longest_step(Executor& executor, const ConstFoamView& mesh, const Domain& domain,
                    const StepView& step) {
  const double of_walls =
      mesh.surroundings.has_walls()
          ? executor.reduce(
                domain.junctions, 1.0,
                FOAM_KERNEL(Junction j) { return longest_wall_step(mesh, step, j); },
                parallel::Smaller{})
          : 1.0;
  return executor.reduce(
      domain.films, of_walls,
      FOAM_KERNEL(Film f) {
        return mesh.bends(f) ? longest_film_step(mesh.chord(f.half()), step.chord_change(mesh, f),
                                                 mesh.half_angle(f.half()), step.angle[f])
                             : 1.0;
      },
      parallel::Smaller{});
}

/// The step, but no junction moves by more than a part of its shortest film and no arc turns by
/// more than it can. Where one film alone is in the way of a whole foam this gets on, though it is
/// no direction of descent for sure.
template <class Executor>
void limit_step(Executor& executor, const ConstFoamView& mesh, const Domain& domain,
                const StepView& step, const StepView& to) {
  executor.for_each(
      domain.junctions, FOAM_KERNEL(Junction j) {
        to.junction[j] = step.junction[j];
        if (!mesh.moves(j)) {
          return;
        }
        double shortest = std::numeric_limits<double>::infinity();
        for (const Half h : mesh.junction_half[j]) {
          shortest = std::min(shortest, mesh.wall(h) ? mesh.length(h) : norm(mesh.chord(h)));
        }
        const double length = norm(step.junction[j]);
        if (length > kLargestMove * shortest) {
          to.junction[j] = (kLargestMove * shortest / length) * step.junction[j];
        }
      });
  executor.for_each(
      domain.films, FOAM_KERNEL(Film f) {
        const double largest = largest_turn(mesh.film_angle[f], step.angle[f]);
        to.angle[f] = std::clamp(step.angle[f], -largest, largest);
      });
  executor.for_each(
      domain.bubbles, FOAM_KERNEL(Bubble b) { to.pressure[b] = step.pressure[b]; });
}

} // namespace foam::newton
