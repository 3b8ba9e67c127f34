// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "equilibrium/newton_equilibrator.h"
#include "evolution/coarsening.h"
#include "topology/thresholds.h"

namespace foam {

/// Coarsening that moves from one topological event to the next.
///
/// Between events every target area is linear in time, so the instant at which a bubble reaches the
/// T2 area is known; the instant at which a film reaches the T1 length is predicted from the
/// equilibrium's response to the areas' rates. At an event the film is swapped or the bubble
/// removed and a patch around it relaxes, while the rest of the foam moves on along its response; a
/// few rings away an event is hardly felt. Every frame ends in an equilibrium of the whole foam to
/// the tolerance. A frame that does not get there so is done again, the whole foam relaxing at
/// every event.
class EventCoarsening final : public Coarsening {
public:
  explicit EventCoarsening(const CoarseningOptions& options);

  void restart(Foam foam) override;
  bool advance(const AbortCheck& aborted) override;
  const Foam& foam() const override { return foam_; }

private:
  /// How the equilibrium moves in time, to first order; by junction, film and bubble.
  struct Motion {
    std::vector<Vec2> junctions;   ///< cm/s
    std::vector<double> angles;    ///< rad/s
    std::vector<double> pressures; ///< N/(cm s)
    std::vector<double> areas;     ///< of the targets, cm²/s

    void take(const Region& region, const Step& response);
    /// What has become a piece of a container's wall does not move any more.
    void hold_wall(const Foam& foam);
    Vec2 chord_rate(const Foam& foam, Index film) const;
  };
  /// What an event that fails is undone to.
  struct State {
    Foam foam;
    Motion motion;
    std::vector<double> patience;
  };

  bool integrate(bool careful, const AbortCheck& aborted);
  void predict_whole();
  void move(double time);
  void balance_gas();
  double time_to_next_event() const;
  std::vector<Index> strained_bubbles(double time) const;
  bool settle_events(const AbortCheck& aborted);
  bool reduce_remnants(const AbortCheck& aborted);
  bool reduce_remnant(Index bubble, const AbortCheck& aborted);
  bool cannot_go_on() const;
  void slide_two_sided_bubbles(const AbortCheck& aborted);
  bool relax_around(std::span<const Index> bubbles, const AbortCheck& aborted);
  void relax_whole(double tolerance, const AbortCheck& aborted);
  bool film_is_due(Index film, const Thresholds& limit) const;
  double collapse_area(Index bubble, const Thresholds& limit) const;
  Thresholds limits() const;
  void undo(State state);

  CoarseningOptions options_;
  NewtonEquilibrator newton_;
  Foam foam_;
  Motion motion_;
  std::vector<double> patience_; ///< of each bubble: the part of the T2 area that it waits for
  bool careful_ = false;         ///< relax the whole foam at every event
  int rounds_left_ = 0;          ///< of events and relaxation in this frame
  int iterations_ = 0;
};

} // namespace foam
