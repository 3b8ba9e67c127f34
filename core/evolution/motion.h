// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <utility>
#include <vector>

#include "equilibrium/lagrangian_system.h"
#include "mesh/foam.h"

namespace foam {

/// How a foam moves in time between topological events, to first order: a rate for every junction,
/// film and bubble. Each of them is moved only when it is looked at, and remembers the instant at
/// which it stands, so that an event in one place costs nothing elsewhere.
class Motion {
public:
  /// The whole foam stands at this instant (s) and rests; target areas change at the given rates
  /// (cm²/s, by bubble).
  void begin(const Foam& foam, std::vector<double> area_rates, double now);
  /// The region moves along a response from now on. \pre it has been brought to now
  void take(const Region& region, const Step& response);
  /// A target area changes at another rate from now on. \pre it has been brought to now
  void set_area_rate(Index bubble, double rate) { area_rates_[Foam::size(bubble)] = rate; }
  /// What has become a piece of a container's wall beside the bubble does not move any more.
  void hold_wall(const Foam& foam, Index bubble);

  /// Moves bubbles, with all their films and junctions, to an instant (s).
  void bring(Foam& foam, std::span<const Index> bubbles, double now);
  void bring_all(Foam& foam, double now);

  void set_area_rates(std::vector<double> rates) { area_rates_ = std::move(rates); }
  const std::vector<double>& area_rates() const { return area_rates_; }
  double area_rate(Index bubble) const { return area_rates_[Foam::size(bubble)]; }
  double angle_rate(Index film) const { return angle_rates_[Foam::size(film)]; }
  Vec2 chord_rate(const Foam& foam, Index film) const;

private:
  void bring_junction(Foam& foam, Index junction, double now);
  void bring_film(Foam& foam, Index film, double now);
  void bring_bubble(Foam& foam, Index bubble, double now);

  std::vector<Vec2> junction_rates_;                            ///< cm/s
  std::vector<double> angle_rates_;                             ///< rad/s
  std::vector<double> pressure_rates_;                          ///< N/(cm s)
  std::vector<double> area_rates_;                              ///< of the targets, cm²/s
  std::vector<double> junction_time_, film_time_, bubble_time_; ///< where each of them stands, s
};

} // namespace foam
