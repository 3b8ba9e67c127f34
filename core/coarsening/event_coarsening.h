// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <optional>
#include <span>

#include "coarsening/coarsening.h"
#include "coarsening/event_queue.h"
#include "coarsening/motion.h"
#include "coarsening/newton_frame_coarsening.h"
#include "equilibrium/newton_equilibrator.h"
#include "physics/thresholds.h"

namespace foam {

/// Coarsening that moves from one topological event to the next.
///
/// Between events every target area is linear in time, by von Neumann's law or, where that does not
/// hold (AreaRate), quadratic, with the change of its rate that the response gives, so the instant
/// at which a bubble reaches the T2 area is known; the instant at which a film reaches the T1
/// length is predicted from the equilibrium's response to the areas' rates. A frame goes in steps
/// short enough for that, each of which ends in an equilibrium of the whole foam to the tolerance.
///
/// A foam of few bubbles feels an event everywhere. There the whole foam relaxes at every event,
/// before and after: the instant of a T1 is the one at which the film has the T1 length in
/// equilibrium, whatever the frames are. In a larger one a patch around the event relaxes, while
/// the rest of the foam moves on along its response; a few rings away an event is hardly felt, nor
/// does it cost anything there. A frame that does not succeed in one way is done again in the
/// other, and if that leads nowhere in fixed steps. Only where those find no way either has the
/// foam come to its end.
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

  std::optional<Obstacle> integrate(bool whole, const AbortCheck& aborted);
  double length_of_step(double time, const Field<Bubble, double>& rates) const;
  void be_at(double time);
  void set_limits();
  void note_thresholds();
  std::optional<Obstacle> step(double remaining, const AbortCheck& aborted);
  std::optional<Obstacle> step_by_patches(const AbortCheck& aborted);
  std::optional<Obstacle> step_whole(const AbortCheck& aborted);
  bool arrive(double time, const AbortCheck& aborted);
  bool correct_areas(double interval, double& part, const AbortCheck& aborted);
  void predict_whole();
  void predict_whole(Field<Bubble, double> rates);
  /// At which a foam may leave equilibrium along its response, 1/s: in a step by so much that one
  /// more step of Newton's method is enough.
  double drift() const { return 300 * options_.equilibrator.tolerance / step_; }
  double same_time() const;
  bool has_short_film() const;
  std::optional<Event> next_touch() const;
  void touch(const AbortCheck& aborted);
  void balance_gas();

  void schedule_all();
  void schedule_film(Film film);
  void schedule_bubble(Bubble bubble);
  void schedule(const Event& event);

  std::optional<Obstacle> handle(const Event& event, const AbortCheck& aborted);
  std::optional<Obstacle> handle_collapse(Bubble bubble, const AbortCheck& aborted);
  Obstacle cannot_vanish(Bubble bubble) const;
  void swap(Film film, const AbortCheck& aborted);
  std::array<Bubble, 4> swap_early(Film film, double early);
  bool vanish(Bubble bubble, const AbortCheck& aborted);
  bool reduce_sides(Bubble bubble, const AbortCheck& aborted);
  void slide_two_sided_bubbles(const AbortCheck& aborted);
  bool film_is_due(Film film) const;
  double time_to_close(Film film) const;
  double length_growth(Film film) const;
  double collapse_area(Bubble bubble) const;

  void relax_around(std::span<const Bubble> bubbles, const AbortCheck& aborted);
  bool relax_patch(std::span<const Bubble> bubbles, const AbortCheck& aborted);
  void move_on();
  void relax_whole(double tolerance, double t1_length, int most, const AbortCheck& aborted);
  void undo(State state);

  CoarseningOptions options_;
  NewtonEquilibrator newton_;
  NewtonFrameCoarsening in_need_;
  Foam foam_;
  Motion motion_;
  EventQueue queue_;
  double step_ = 0;                ///< s
  double begin_ = 0;               ///< of the step, s
  double now_ = 0;                 ///< s from the beginning of the step
  double changed_ = 0;             ///< when topology changed last in it, s likewise
  double predicted_ = 0;           ///< when the whole foam's response was found last, s likewise
  double longest_ = 0;             ///< interval through which rates are known well enough, s
  bool rates_change_ = false;      ///< between events
  double unit_of_time_ = 0;        ///< in which a seventh side brings a bubble the mean area, s
  Thresholds limit_;               ///< at this instant
  double room_ = 0;                ///< of a bubble that is to lose sides, cm²
  double smallest_area_ = 0;       ///< of a bubble, cm²
  Field<Bubble, double> back_off_; ///< the part of the T2 area that it waits for
  bool whole_ = false;             ///< the whole foam relaxes at every event
  int iterations_ = 0;
};

} // namespace foam
