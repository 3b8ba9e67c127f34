// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "equilibrium/options.h"
#include "mesh/foam.h"
#include "physics/thresholds.h"
#include "topology/two_sided.h"

namespace foam {

/// How Newton's coarsening goes through time.
enum class Stepping {
  Events,    ///< from one topological event to the next
  FixedSteps ///< in equal steps, with all events of a step at once, as on a GPU
};

/// In which order a frame of the thesis performs its topological operations (thesis 4.3).
enum class TopologicalAlgorithm {
  Final,       ///< Figure 4.8, which follows every cascade
  Original,    ///< Figure 4.4, a walk over the junctions that is the frame's first sweep as well
  Improved,    ///< Figure 4.6, bubbles and films in turn until nothing gives way
  Simultaneous ///< many at once, where they do not meet (topology/reservations.h), as on a GPU
};

struct CoarseningOptions {
  double time_step = 0;    ///< Δt, s, ≥ 0; 0 stands for an automatic one
  double permeability = 1; ///< κ, cm²/s in the thesis's units, ≥ 0
  ThresholdOptions thresholds;
  TwoSidedBubbles two_sided_bubbles = TwoSidedBubbles::Remove;
  Stepping stepping = Stepping::Events;                                     ///< of Newton
  TopologicalAlgorithm topological_algorithm = TopologicalAlgorithm::Final; ///< of Junction
  EquilibratorOptions equilibrator;

  friend bool operator==(const CoarseningOptions&, const CoarseningOptions&) = default;
};

/// Δt with which a foam is to coarsen, s: that of the options or, where it is automatic, the one
/// with which the foam has coarsened so far or, in a foam that has not, or at another rate, one of
/// which 300 leave about a third of the bubbles.
/// \param mean_area of its bubbles' targets, cm²
double time_step(const CoarseningOptions& options, const FoamRecord& foam, double mean_area);

/// \throws FoamError for options out of range.
void check(const CoarseningOptions& options);

} // namespace foam
