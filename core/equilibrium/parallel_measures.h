// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a whole foam is from equilibrium, on any machine (parallel/host.h).
#pragma once

#include <algorithm>

#include "mesh/element_measures.h"
#include "mesh/foam_view.h"

namespace foam {

/// How far a foam is from equilibrium, and whether it is possible.
struct EquilibriumMeasures {
  double angle_error = 0;
  double area_error = 0;
  bool possible = true; ///< no junction is inverted, no bubble inside out
};

namespace detail {

struct MeasureJunction {
  FoamView mesh;

  FOAM_HOST_DEVICE EquilibriumMeasures operator()(Index junction) const {
    EquilibriumMeasures measures;
    if (mesh.has_junction(junction) && !mesh.pinned(junction)) {
      measures.angle_error = angle_error(mesh, junction);
      measures.possible = counter_clockwise(mesh, junction);
    }
    return measures;
  }
};

struct MeasureBubble {
  FoamView mesh;

  FOAM_HOST_DEVICE EquilibriumMeasures operator()(Index bubble) const {
    EquilibriumMeasures measures;
    if (mesh.has_bubble(bubble)) {
      measures.area_error = area_error(mesh, bubble);
      measures.possible = mesh.area(bubble) > 0;
    }
    return measures;
  }
};

struct WorseOfEach {
  FOAM_HOST_DEVICE EquilibriumMeasures operator()(const EquilibriumMeasures& a,
                                                  const EquilibriumMeasures& b) const {
    return {std::max(a.angle_error, b.angle_error), std::max(a.area_error, b.area_error),
            a.possible && b.possible};
  }
};

} // namespace detail

template <class Machine>
EquilibriumMeasures measure_equilibrium(Machine& machine, const FoamView& mesh) {
  using namespace detail;
  const EquilibriumMeasures junctions =
      machine.reduce(mesh.junctions, EquilibriumMeasures{}, MeasureJunction{mesh}, WorseOfEach{});
  return machine.reduce(mesh.bubbles, junctions, MeasureBubble{mesh}, WorseOfEach{});
}

} // namespace foam
