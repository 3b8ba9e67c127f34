// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>

#include "physics/thresholds.h"
#include "thesis/junction_system.h"
#include "topology/two_sided.h"

namespace foam {

/// Target areas below this share of the mean are raised to it.
inline constexpr double kLeastTarget = 1e-6;

/// The thesis's conditions for a topological operation (3.2.2), and for T3 that of T2. Areas are
/// those of the pressures: the arcs' own angles lag behind while junctions are equilibrated between
/// the operations.
struct ThesisRules {
  Thresholds limit;
  TwoSidedBubbles two_sided_bubbles = TwoSidedBubbles::Remove;

  /// What a film's length is measured by, cm.
  template <class Mesh> FOAM_HOST_DEVICE static double film_size(const Mesh& mesh, Film film) {
    return norm(mesh.chord(film.half()));
  }
  /// What a bubble's size is measured by, in fact and in target, cm².
  template <class Mesh>
  FOAM_HOST_DEVICE static double bubble_size(const Mesh& mesh, Bubble bubble) {
    return std::min(mesh.target_area[bubble], thesis::thesis_area(mesh, mesh.bubble_half[bubble]));
  }

  template <class Mesh> FOAM_HOST_DEVICE bool shrunk(const Mesh& mesh, Film film) const {
    return film_size(mesh, film) <= limit.t1_length;
  }
  template <class Mesh> FOAM_HOST_DEVICE bool vanishes(const Mesh& mesh, Bubble bubble) const {
    return bubble_size(mesh, bubble) <= limit.t2_area;
  }
  FOAM_HOST_DEVICE TwoSidedRule two_sided() const { return {two_sided_bubbles, limit.t1_length}; }
  template <class Mesh> FOAM_HOST_DEVICE bool slides(const Mesh& mesh, Bubble bubble) const {
    return two_sided().slides(mesh, bubble);
  }
};

} // namespace foam
