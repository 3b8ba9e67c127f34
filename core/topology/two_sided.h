// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/mesh_access.h"

namespace foam {

enum class TwoSidedBubbles {
  Remove, ///< a two-sided bubble stays on its film and is removed (T3) at the T2 area
  Slide   ///< it slides to the nearest corner and becomes three-sided (thesis 3.6.1)
};

/// What becomes of two-sided bubbles in a frame.
struct TwoSidedRule {
  TwoSidedBubbles fate = TwoSidedBubbles::Remove;
  double t1_length = 0; ///< δ_T1, cm

  /// Whether a two-sided bubble slides and stays. On the wall of a container it has no corner to
  /// slide to.
  template <class Mesh> FOAM_HOST_DEVICE bool slides(const Mesh& mesh, Bubble bubble) const {
    return fate == TwoSidedBubbles::Slide &&
           !(mesh.surroundings.has_walls() && mesh.bubble_on_outside(bubble));
  }

  /// How far from its corner a bubble slides, cm. The film between is to be found short enough for
  /// a T1 whatever rounding does.
  FOAM_HOST_DEVICE double sliding_distance() const { return t1_length * (1 - 1e-9); }
};

} // namespace foam
