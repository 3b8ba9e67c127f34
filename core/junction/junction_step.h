// SPDX-License-Identifier: GPL-3.0-or-later
//
// What one junction does in the thesis's method: find its change and take as much of it as the
// constraints allow.
#pragma once

#include "equilibrium/equilibrator.h"
#include "junction/angle_root_search.h"
#include "junction/energy_root_search.h"

namespace foam::junction {

/// The junction's own solution z by a root search, undamped. Not finite where its system is
/// singular.
template <class Search>
JunctionStep junction_step(const Search& search, const Foam& foam, Index junction,
                           const JunctionOptions& options) {
  const JunctionStar star = junction_star(foam, junction);
  const DifferenceOptions difference{options.finite_difference_step, options.jacobian_tolerance,
                                     options.minimum_scale};
  return search.solve(star, junction_system(search, foam, junction, star, difference));
}

/// By the root search that is asked for.
inline JunctionStep junction_step(const Foam& foam, Index junction,
                                  const JunctionOptions& options) {
  return options.root_search == RootSearch::Energies
             ? junction_step(EnergyRootSearch{options.energy_target}, foam, junction, options)
             : junction_step(AngleRootSearch{}, foam, junction, options);
}

/// The constraints on a junction's movement (thesis 3.5), against the state they are made in.
class MovementConstraints {
public:
  MovementConstraints(const Foam& foam, Index junction, const JunctionOptions& options);

  /// Whether the state that the foam is in now may follow.
  bool hold() const;

private:
  /// Of the junction and the three beside it, which are oriented.
  std::array<bool, 4> orientations() const;

  const Foam& foam_;
  Index junction_;
  bool energy_decay_;
  bool orientation_invariant_;
  double energy_ = 0;
  std::array<bool, 4> oriented_{};
};

/// What a junction does with its step.
struct JunctionChange {
  std::array<double, 3> pressure{}; ///< for its bubbles, before division by their films, N/cm
  Vec2 position;                    ///< by which it was moved, cm
  bool solvable = true;             ///< its system was not singular
};

/// Moves the junction by τ·Δx, halved as often as the constraints ask for; the pressures get the
/// same share of their step (Figure 4.2). Where no scale above the minimum will do, or the step is
/// not finite, nothing changes. A junction that is pinned to a wall stays, and its pressures get τ.
JunctionChange move_junction(Foam& foam, Index junction, const JunctionStep& step,
                             const JunctionOptions& options);

/// Equilibrates one junction: solves its system, moves it and passes the pressure changes, divided
/// by the bubbles' numbers of films (3.1.3), to its bubbles.
JunctionChange equilibrate_junction(Foam& foam, Index junction, const JunctionOptions& options);

} // namespace foam::junction
