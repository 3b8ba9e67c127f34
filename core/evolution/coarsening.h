// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "equilibrium/equilibrator.h"
#include "evolution/diffusion.h"
#include "mesh/foam.h"
#include "sampling/sampled_foam.h"
#include "statistics/statistics.h"
#include "topology/thresholds.h"

namespace foam {

enum class TwoSidedBubbles {
  Remove, ///< a two-sided bubble stays on its film and is removed (T3) at the T2 area
  Slide   ///< it slides to the nearest corner and becomes three-sided (thesis 3.6.1)
};

/// In which order a frame performs its topological operations (thesis 4.3).
enum class TopologicalAlgorithm {
  Final,    ///< Figure 4.8, which follows every cascade
  Original, ///< Figure 4.4, a walk over the junctions that is the frame's first sweep as well
  Improved, ///< Figure 4.6, bubbles and films in turn until nothing gives way
  Bidding   ///< many at once, where they do not meet (topology/bidding.h), as on a GPU
};

struct CoarseningOptions {
  double time_step = 1.0 / 30; ///< Δt, s, > 0
  double permeability = 1;     ///< κ, cm²/s in the thesis's units, ≥ 0
  ThresholdOptions thresholds;
  TwoSidedBubbles two_sided_bubbles = TwoSidedBubbles::Remove;
  TopologicalAlgorithm topological_algorithm = TopologicalAlgorithm::Final; ///< of frames
  EquilibratorOptions equilibrator;
};

/// The coarsening of a foam, frame by frame. Composes an equilibrator.
class Coarsening {
public:
  virtual ~Coarsening() = default;

  /// Begins anew from a foam; nothing is kept from before.
  virtual void restart(Foam foam) = 0;

  /// Advances by one time step.
  /// \returns false, with the foam as it was, if the foam cannot go on: a bubble would vanish that
  /// cannot, one of a double bubble, say, for a single bubble has no junction and is outside the
  /// model; or what would come next is so far from any equilibrium that it is no foam.
  /// \throws Aborted, with the foam as it was before the call; what was kept to be fast is lost, so
  /// that only restart() leads back to the bits of a run that was not aborted.
  virtual bool advance(const AbortCheck& aborted) = 0;

  virtual const Foam& foam() const = 0;

  // Of foam(), without fetching it where it lies on a device.
  virtual const FoamRecord& record() const { return foam(); }
  virtual SampledFoam sample(double chord_error) { return foam::sample(foam(), chord_error); }
  virtual FoamStatistics statistics(bool include_boundary) {
    return foam::statistics(foam(), include_boundary);
  }
};

/// The coarsening that goes with the equilibrator: for Junction the thesis's frame (Figures 3.13
/// and 4.8); for Newton from one topological event to the next or, with
/// TopologicalAlgorithm::Bidding, in fixed steps with all events of a step at once, as on a GPU.
/// \throws FoamError for options out of range, or a device that is not there.
std::unique_ptr<Coarsening> make_coarsening(const CoarseningOptions& options);

} // namespace foam
