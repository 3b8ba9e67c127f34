// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/abort.h"
#include "coarsening/options.h"
#include "mesh/foam.h"
#include "sampling/sampled_foam.h"
#include "statistics/statistics.h"

namespace foam {

/// The coarsening of a foam, frame by frame. Composes an equilibrator.
class Coarsening {
public:
  Coarsening() = default;
  Coarsening(const Coarsening&) = delete;
  Coarsening& operator=(const Coarsening&) = delete;
  virtual ~Coarsening() = default;

  /// Begins anew from a foam; nothing is kept from before. Its record gets the thresholds that are
  /// in force. Where it throws, the foam is as before.
  virtual void restart(Foam foam) = 0;

  /// Advances by one time step.
  /// \returns false if the foam cannot go on: a bubble would vanish that cannot, one of a double
  /// bubble, say, for a single bubble has no junction and is outside the model; or no equilibrium
  /// is found for what would come next. The foam is as it was then, and its record's `ended` says
  /// why. \throws Aborted, with the foam as it was before the call; what was kept to be fast is
  /// lost, so that only restart() leads back to the bits of a run that was not aborted.
  virtual bool advance(const AbortCheck& aborted) = 0;

  virtual const Foam& foam() const = 0;

  // Of foam(), without fetching it where it lies on a device.
  virtual const FoamRecord& record() const { return foam(); }
  virtual SampledFoam sample(double chord_error) { return foam::sample(foam(), chord_error); }
  virtual FoamStatistics statistics(bool include_boundary) {
    return foam::statistics(foam(), include_boundary);
  }
};

} // namespace foam
