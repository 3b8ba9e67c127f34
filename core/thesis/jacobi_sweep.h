// SPDX-License-Identifier: GPL-3.0-or-later
//
// The thesis's method with all junctions at once (Figure 4.12), on any executor (parallel/host.h):
// all junctions solve against one state of the foam. Positions then change in the order of
// update_order.h, as the constraints need it, pressures all at the end, each bubble gathering the
// changes of its junctions in the order of its films.
#pragma once

#include <algorithm>
#include <cmath>

#include "base/abort.h"
#include "equilibrium/options.h"
#include "physics/equilibrium_measures.h"
#include "thesis/junction_step.h"
#include "thesis/one_tension.h"
#include "thesis/update_order.h"

namespace foam::thesis {

/// The largest changes of a sweep, for the halting rule (thesis 4.2.1).
struct Maxima {
  double pressure = 0;  ///< |Δp|, N/cm²
  double position = 0;  ///< |Δx|, cm
  bool solvable = true; ///< no junction's system was singular

  FOAM_HOST_DEVICE void include(const JunctionChange& change) {
    solvable = solvable && change.solvable;
    for (const double dp : change.pressure) {
      pressure = std::max(pressure, std::abs(dp));
    }
    position = std::max(position, norm(change.position));
  }
};

namespace detail {

struct Solve {
  static constexpr std::size_t kLeastPerThread = 64;

  ConstFoamView mesh;
  JunctionOptions options;
  FieldView<Junction, JunctionStep> step;

  FOAM_HOST_DEVICE void operator()(Junction junction) const {
    if (mesh.has_junction(junction)) {
      step[junction] = junction_step(mesh, junction, options);
    }
  }
};

struct Move {
  FoamView mesh;
  JunctionOptions options;
  Index wave = 0;
  ConstFieldView<Junction, Index> wave_of;
  ConstFieldView<Junction, JunctionStep> step;
  FieldView<Junction, JunctionChange> change;

  FOAM_HOST_DEVICE void operator()(Junction junction) const {
    if (wave_of[junction] == wave && mesh.has_junction(junction)) {
      FoamView moved = mesh;
      change[junction] = move_junction(moved, junction, step[junction], options);
    }
  }
};

struct GatherPressure {
  FoamView mesh;
  ConstFieldView<Junction, JunctionChange> change;

  FOAM_HOST_DEVICE void operator()(Bubble bubble) const {
    if (mesh.has_bubble(bubble)) {
      double sum = 0;
      for_each_half(mesh, bubble, [&](Half h) {
        const Junction junction = mesh.start(h);
        const std::array<Half, 3>& halves = mesh.junction_half[junction];
        const std::size_t k = halves[0] == h ? 0 : (halves[1] == h ? 1 : 2);
        sum += change[junction].pressure[k];
      });
      mesh.pressure[bubble] += sum / mesh.sides[bubble];
    }
  }
};

struct MaximaOf {
  ConstFoamView mesh;
  ConstFieldView<Junction, JunctionChange> change;

  FOAM_HOST_DEVICE Maxima operator()(Junction junction) const {
    Maxima maxima;
    if (mesh.has_junction(junction)) {
      maxima.include(change[junction]);
    }
    return maxima;
  }
};

struct LargerOfEach {
  FOAM_HOST_DEVICE Maxima operator()(const Maxima& a, const Maxima& b) const {
    return {std::max(a.pressure, b.pressure), std::max(a.position, b.position),
            a.solvable && b.solvable};
  }
};

/// The half-angles that go with the pressures.
struct WriteHalfAngle {
  FoamView mesh;

  FOAM_HOST_DEVICE void operator()(Film film) const {
    const Half h = film.half();
    if (mesh.has_film(film)) {
      mesh.film_angle[film] =
          mesh.wall(h) ? 0
                       : thesis_half_angle(norm(mesh.chord(h)), mesh.pressure_difference(h),
                                           mesh.reference_tension());
    }
  }
};

} // namespace detail

/// Sweeps over all junctions of a mesh at once.
template <class Executor> class JacobiSweep {
public:
  JacobiSweep(Executor& executor, const JunctionOptions& options)
      : executor_(executor), options_(options), order_(executor) {}

  /// Prepares for a mesh; to be called anew after every topological change.
  void prepare(const FoamView& mesh) {
    order_.find(const_view(mesh), constraint_reach(options_));
    step_.resize(place_of(mesh.junctions));
    change_.resize(place_of(mesh.junctions));
  }

  Maxima sweep(const FoamView& mesh) {
    const Slots<Junction> junctions = mesh.junction_slots();
    const ConstFoamView state = const_view(mesh);
    const FieldView<Junction, JunctionStep> step(step_.data());
    const FieldView<Junction, JunctionChange> change(change_.data());
    const ConstFieldView<Junction, JunctionStep> solved(step.data());
    const ConstFieldView<Junction, JunctionChange> made(change.data());
    executor_.for_each(junctions, detail::Solve{state, options_, step});
    for (Index wave = 0; wave < order_.waves(); ++wave) {
      executor_.for_each(junctions,
                         detail::Move{mesh, options_, wave, order_.wave(), solved, change});
    }
    executor_.for_each(mesh.bubble_slots(), detail::GatherPressure{mesh, made});
    return executor_.reduce(junctions, Maxima{}, detail::MaximaOf{state, made},
                            detail::LargerOfEach{});
  }

private:
  Executor& executor_;
  JunctionOptions options_;
  UpdateOrder<Executor> order_;
  typename Executor::template Array<JunctionStep> step_;
  typename Executor::template Array<JunctionChange> change_;
};

/// Figure 4.3, with the thesis's words where they differ from it: what counts are the changes after
/// each junction's equilibration, another sweep follows if either maximum differs by more than its
/// tolerance from the last sweep's, and it may differ in either direction.
inline bool halt(const Maxima& now, const Maxima& old, const JunctionOptions& options) {
  return std::abs(now.pressure - old.pressure) <= options.pressure_tolerance &&
         std::abs(now.position - old.position) <= options.position_tolerance;
}

/// Calls sweep() until the halting rule is met, then gives the films the half-angles of their
/// pressures and measures what was reached. \throws Aborted between two sweeps, and FoamError
/// before the first for a mesh that the method is not made for.
template <class Executor, class Sweep>
EquilibriumReport sweep_to_rest(Executor& executor, const FoamView& mesh,
                                const EquilibratorOptions& options, const AbortCheck& aborted,
                                Sweep&& sweep) {
  require_one_tension(mesh);
  EquilibriumReport report;
  Maxima now;
  bool halted = false;
  while (!halted && report.iterations < options.maximum_iterations) {
    if (aborted && aborted()) {
      throw Aborted();
    }
    const Maxima old = now;
    now = sweep();
    ++report.iterations;
    halted = halt(now, old, options.junction);
  }
  executor.for_each(mesh.film_slots(), detail::WriteHalfAngle{mesh});
  const EquilibriumMeasures measures = measure_equilibrium(executor, const_view(mesh));
  report.max_angle_error = measures.angle_error;
  report.max_area_error = measures.area_error;
  report.residual = std::max(report.max_angle_error, report.max_area_error);
  report.converged = halted && now.solvable && std::isfinite(report.residual) && measures.possible;
  return report;
}

} // namespace foam::thesis
