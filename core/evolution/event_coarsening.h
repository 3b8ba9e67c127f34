// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "equilibrium/newton_equilibrator.h"
#include "evolution/coarsening.h"
#include "topology/thresholds.h"

namespace foam {

/// Coarsening that moves from one topological event to the next.
///
/// Between events every target area is linear in time, so the instant at which a bubble reaches the
/// T2 area is known; the instant at which a film reaches the T1 length is predicted from the
/// equilibrium's response to the areas' rates, and met by repeated prediction to within Δt/64 or
/// better. At an event the film is swapped or the bubble removed, the surroundings relax, and time
/// goes on. Every frame ends in an equilibrium to the tolerance, every event within it happens in
/// one to 1e-6.
class EventCoarsening final : public Coarsening {
public:
  explicit EventCoarsening(const CoarseningOptions& options);

  void restart(Foam foam) override;
  bool advance(const AbortCheck& aborted) override;
  const Foam& foam() const override { return foam_; }

private:
  bool integrate(const AbortCheck& aborted);
  double time_to_next_event(const std::vector<double>& rates, const Step& response,
                            const Thresholds& limits) const;
  void move(double time, const std::vector<double>& rates, const Step& response);
  bool settle_events(const std::vector<char>& shrinking, const AbortCheck& aborted);
  bool reduce_remnants(const AbortCheck& aborted);
  bool reduce_remnant(Index bubble, const AbortCheck& aborted);
  double collapse_area(Index bubble, const Thresholds& limit) const;
  void slide_two_sided_bubbles(const AbortCheck& aborted);
  void relax_around(const std::vector<Index>& bubbles, double tolerance, const AbortCheck& aborted);
  double tolerance_between_events() const;
  Thresholds limits() const;

  CoarseningOptions options_;
  NewtonEquilibrator newton_;
  Foam foam_;
  std::vector<double> patience_; ///< of each bubble: the part of the T2 area that it waits for
  int iterations_ = 0;
};

} // namespace foam
