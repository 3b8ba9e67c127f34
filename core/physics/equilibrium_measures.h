// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a whole foam is from equilibrium, on any executor (parallel/host.h).
#pragma once

#include <algorithm>

#include "mesh/element_measures.h"
#include "mesh/foam.h"
#include "mesh/foam_view.h"
#include "parallel/kernels.h"

namespace foam {

/// How far a foam is from equilibrium, and whether it is possible.
struct EquilibriumMeasures {
  double angle_error = 0; ///< rad
  double area_error = 0;  ///< relative
  bool possible = true;   ///< no junction is inverted, no bubble inside out

  /// The worse of each.
  friend FOAM_HOST_DEVICE EquilibriumMeasures operator+(const EquilibriumMeasures& a,
                                                        const EquilibriumMeasures& b) {
    return {std::max(a.angle_error, b.angle_error), std::max(a.area_error, b.area_error),
            a.possible && b.possible};
  }
};

template <class Executor>
EquilibriumMeasures measure_equilibrium(Executor& executor, const ConstFoamView& mesh) {
  const EquilibriumMeasures of_junctions = executor.reduce(
      mesh.junction_slots(), EquilibriumMeasures{},
      FOAM_KERNEL(Junction j) {
        return mesh.moves(j)
                   ? EquilibriumMeasures{angle_error(mesh, j), 0, counter_clockwise(mesh, j)}
                   : EquilibriumMeasures{};
      },
      parallel::Add{});
  return executor.reduce(
      mesh.bubble_slots(), of_junctions,
      FOAM_KERNEL(Bubble b) {
        return mesh.has_bubble(b) ? EquilibriumMeasures{0, area_error(mesh, b), mesh.area(b) > 0}
                                  : EquilibriumMeasures{};
      },
      parallel::Add{});
}

/// Largest deviation at junctions that may move from the angles that their films' tensions ask for
/// (rad).
double max_angle_error(const Foam& foam);

/// Largest |A − A^τ|/A^τ.
double max_area_error(const Foam& foam);

/// Largest |2 sin α − q·d/T| of films: how far they are from Laplace and Young's law. One whose
/// pressure difference q asks for less than half its chord d as radius counts as a half circle.
double max_curvature_error(const Foam& foam);

/// How far a foam is from equilibrium, found by measuring it. Nobody has said that it converged.
EquilibriumReport measured_report(const Foam& foam);

/// Whether a report of a foam is true: whether its angles, areas and curvatures are no further off
/// than it says and than they can be by rounding. \param rounding of a coordinate, cm
bool holds(const EquilibriumReport& report, const Foam& foam, double rounding);

/// A report of a foam, if it holds and is near what is measured. Otherwise what is measured, not
/// `converged` unless rounding explains it. \param rounding of a coordinate, cm
EquilibriumReport confirmed(const EquilibriumReport& report, const Foam& foam, double rounding);

} // namespace foam
