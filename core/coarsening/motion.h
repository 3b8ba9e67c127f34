// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "equilibrium/domain.h"
#include "equilibrium/step.h"
#include "mesh/foam.h"
#include "physics/rates.h"

namespace foam {

/// How a foam moves in time between topological events: a rate for every junction, film and bubble.
/// Each of them is moved only when it is looked at, and remembers the instant at which it stands,
/// so that an event in one place costs nothing elsewhere.
class Motion {
public:
  /// The whole foam stands at this instant (s); target areas change at the given rates (cm²/s).
  void begin(const Foam& foam, Field<Bubble, double> area_rates, double now);
  /// The whole foam moves along a response from now on. \param bend what its rates will change by
  /// until the motion is finished, in units of what they have since the last whole response
  void take_whole(const Region& region, const newton::StepView& response, double bend);
  /// A patch moves along a response from now on. \pre it has been brought to now
  void take_patch(const Region& region, const newton::StepView& response);
  /// Nothing moves, but target areas change.
  void rest();
  /// The rates of target areas change evenly from the beginning on, by so much, cm²/s².
  void bend_areas(Field<Bubble, double> changes) { area_bends_ = std::move(changes); }
  /// A target area changes at another rate from now on. \pre it has been brought to now
  void set_area_rate(Bubble bubble, double rate) {
    area_rates_[bubble] = rate;
    area_bends_[bubble] = 0;
  }
  /// What has become a piece of a container's wall beside the bubble does not move any more.
  void hold_wall(const Foam& foam, Bubble bubble);

  /// Moves bubbles, with all their films and junctions, to an instant (s).
  void bring(Foam& foam, std::span<const Bubble> bubbles, double now);
  void bring_all(Foam& foam, double now);
  /// The same, to second order where a whole response has held from the beginning.
  void finish(Foam& foam, double now);

  const Field<Bubble, double>& area_rates() const { return area_rates_; }
  Rates rates() const { return {junctions_.rate, angles_.rate, pressures_.rate}; }
  /// What they will be if they go on changing as they did; until the next call.
  Rates expected();
  /// Where the bubble stands.
  double area_rate(Bubble bubble) const {
    return area_rates_[bubble] + (pressures_.time[bubble] - begin_) * area_bends_[bubble];
  }
  double area_bend(Bubble bubble) const { return area_bends_[bubble]; }
  double angle_rate(Film film) const { return angles_.rate[film]; }
  Vec2 chord_rate(const Foam& foam, Film film) const;
  /// Of a film's chord, or of a stretch of a wall, in units of what it has, 1/s.
  double relative_growth(const Foam& foam, Film film) const;

private:
  template <class Element, class Value> struct Trajectory {
    Field<Element, Value> rate;  ///< per s
    Field<Element, Value> bend;  ///< of the rate in all, per s
    Field<Element, char> steady; ///< the rate is a whole response's
    Field<Element, double> time; ///< where it stands, s
    std::vector<Value> ahead;    ///< the rates expected next

    void begin(std::size_t count, double now);
    void take_whole(Element e, const Value& rate, double bend);
    void take_patch(Element e, const Value& rate);
    void rest();
    void bring(Field<Element, Value>& values, Element e, double now);
    std::span<const Value> expected();
  };
  void bring_junction(Foam& foam, Junction junction, double now);
  void bring_bubble(Foam& foam, Bubble bubble, double now);

  Trajectory<Junction, Vec2> junctions_; ///< cm
  Trajectory<Film, double> angles_;      ///< rad
  Trajectory<Bubble, double> pressures_; ///< N/cm²
  Field<Bubble, double> area_rates_;     ///< of the targets at the beginning, cm²/s
  Field<Bubble, double> area_bends_;     ///< by which those change, cm²/s²
  double begin_ = 0;                     ///< s
};

} // namespace foam
