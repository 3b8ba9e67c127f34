// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>

#include "coarsening/coarsening.h"
#include "coarsening/event_queue.h"
#include "coarsening/motion.h"
#include "coarsening/newton_frame_coarsening.h"
#include "equilibrium/newton_equilibrator.h"
#include "physics/thresholds.h"
#include "topology/cascade.h"

namespace foam {

/// Coarsening that moves from one topological event to the next.
///
/// Between events every target area is linear in time, by von Neumann's law or, where that does not
/// hold (AreaRate), to the first order of the time step, so the instant at which a bubble reaches
/// the T2 area is known; the instant at which a film reaches the T1 length is predicted from the
/// equilibrium's response to the areas' rates. At an event the film is swapped or the bubble
/// removed and a patch around it relaxes, while the rest of the foam moves on along its response; a
/// few rings away an event is hardly felt, nor does it cost anything there. Every frame ends in an
/// equilibrium of the whole foam to the tolerance. A frame that does not get there so is done
/// again, the whole foam relaxing at every event, and if that leads nowhere in fixed steps. Only
/// where those find no way either has the foam come to its end.
class EventCoarsening final : public Coarsening {
public:
  explicit EventCoarsening(const CoarseningOptions& options);

  void restart(Foam foam) override;
  bool advance(const AbortCheck& aborted) override;
  const Foam& foam() const override { return foam_; }

private:
  /// What an event that fails is undone to.
  struct State {
    Foam foam;
    Motion motion;
    Field<Bubble, double> back_off;
  };

  /// What a frame cannot get over.
  struct Obstacle {
    End::Cause cause;
    Bubble bubble = kNone; ///< that is to vanish
  };

  std::optional<Obstacle> integrate(bool fallback, const AbortCheck& aborted);
  void predict_whole();
  /// At which a foam may leave equilibrium along its response, 1/s: in a frame by so much that one
  /// more step of Newton's method is enough.
  double drift() const { return 300 * options_.equilibrator.tolerance / options_.time_step; }
  void balance_gas();

  void schedule_all();
  void schedule_film(Film film);
  void schedule_bubble(Bubble bubble);
  void schedule(const Event& event);

  std::optional<Obstacle> handle(const Event& event, const AbortCheck& aborted);
  std::optional<Obstacle> handle_collapse(Bubble bubble, const AbortCheck& aborted);
  Obstacle cannot_vanish(Bubble bubble) const;
  bool reduce_sides(Bubble bubble, const AbortCheck& aborted);
  void slide_two_sided_bubbles(const AbortCheck& aborted);
  CollapseRules rules() const;
  bool film_is_due(Film film) const;
  double collapse_area(Bubble bubble) const;

  void relax_around(std::span<const Bubble> bubbles, const AbortCheck& aborted);
  bool relax_patch(std::span<const Bubble> bubbles, const AbortCheck& aborted);
  void move_on();
  void relax_whole(double tolerance, const AbortCheck& aborted);
  void undo(State state);

  CoarseningOptions options_;
  NewtonEquilibrator newton_;
  NewtonFrameCoarsening in_need_;
  Foam foam_;
  Motion motion_;
  EventQueue queue_;
  double now_ = 0;                 ///< s from the beginning of the frame
  Thresholds limit_;               ///< in this frame
  double smallest_area_ = 0;       ///< of a bubble, in this frame, cm²
  Field<Bubble, double> back_off_; ///< the part of the T2 area that it waits for
  bool fallback_ = false;          ///< relax the whole foam at every event
  bool lost_ = false;              ///< no equilibrium was found then
  int iterations_ = 0;
};

} // namespace foam
