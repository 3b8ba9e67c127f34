// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "base/abort.h"
#include "mesh/foam.h"
#include "sampling/sampled_foam.h"
#include "statistics/statistics.h"

namespace foam {

/// A foam that changes frame by frame.
class Evolution {
public:
  Evolution() = default;
  Evolution(const Evolution&) = delete;
  Evolution& operator=(const Evolution&) = delete;
  virtual ~Evolution() = default;

  /// Begins anew from a foam; nothing is kept from before. Where it throws, the foam is as before.
  virtual void restart(Foam foam) = 0;

  /// Advances by one frame.
  /// \returns false if the foam cannot go on. It is as it was then, and its record's `ended` says
  /// why. \throws Aborted, with the foam as it was before the call; what was kept to be fast is
  /// lost, so that only restart() leads back to the bits of a run that was not aborted.
  virtual bool advance(const AbortCheck& aborted) = 0;

  virtual const Foam& foam() const = 0;
  /// From one frame to the next, s.
  virtual double frame_time() const = 0;

  /// What happened in the last frame, in its order.
  virtual std::vector<TopologicalEvent> events() const { return events_of(foam()); }

  // Of foam(), without fetching it where it lies on a device.
  virtual const FoamRecord& record() const { return foam(); }
  virtual SampledFoam sample(double chord_error) { return foam::sample(foam(), chord_error); }
  virtual FoamStatistics statistics(bool include_boundary) {
    return foam::statistics(foam(), include_boundary);
  }
};

} // namespace foam
