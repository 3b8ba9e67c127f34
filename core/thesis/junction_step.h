// SPDX-License-Identifier: GPL-3.0-or-later
//
// What one junction does in the thesis's method: find its change and take as much of it as the
// constraints allow.
#pragma once

#include "equilibrium/options.h"
#include "mesh/foam.h"
#include "thesis/angle_root_search.h"
#include "thesis/energy_root_search.h"

namespace foam::thesis {

/// The junction's own solution z by a root search, undamped. Not finite where its system is
/// singular.
template <class Search, class Mesh>
FOAM_HOST_DEVICE JunctionStep junction_step(const Search& search, const Mesh& mesh,
                                            Junction junction, const JunctionOptions& options) {
  const JunctionStar star = junction_star(mesh, junction);
  const DifferenceOptions difference{options.finite_difference_step, options.jacobian_tolerance,
                                     options.minimum_scale};
  return search.solve(star, junction_system(search, mesh, junction, star, difference));
}

/// By the root search that is asked for.
template <class Mesh>
FOAM_HOST_DEVICE JunctionStep junction_step(const Mesh& mesh, Junction junction,
                                            const JunctionOptions& options) {
  return options.root_search == RootSearch::Energies
             ? junction_step(EnergyRootSearch{options.energy_target}, mesh, junction, options)
             : junction_step(AngleRootSearch{}, mesh, junction, options);
}

/// The constraints on a junction's movement (thesis 3.5), against the state they are made in.
template <class Mesh> class MovementConstraints {
public:
  FOAM_HOST_DEVICE MovementConstraints(const Mesh& mesh, Junction junction,
                                       const JunctionOptions& options)
      : mesh_(mesh), junction_(junction), energy_decay_(options.energy_decay),
        orientation_invariant_(options.orientation_invariant) {
    if (energy_decay_) {
      energy_ = local_energy(junction_star(mesh_, junction_));
    }
    if (orientation_invariant_) {
      oriented_ = orientations();
    }
  }

  /// Whether the state that the mesh is in now may follow.
  FOAM_HOST_DEVICE bool hold() const {
    if (energy_decay_ && !(local_energy(junction_star(mesh_, junction_)) <= energy_)) {
      return false;
    }
    if (!orientation_invariant_) {
      return true;
    }
    // The invariant is to be maintained: a junction that was inverted before binds nobody.
    const std::array<bool, 4> now = orientations();
    for (std::size_t k = 0; k < now.size(); ++k) {
      if (oriented_[k] && !now[k]) {
        return false;
      }
    }
    return true;
  }

private:
  /// Of the junction and the three beside it, which are oriented.
  FOAM_HOST_DEVICE std::array<bool, 4> orientations() const {
    const JunctionStar star = junction_star(mesh_, junction_);
    std::array<bool, 4> result{oriented(star)};
    for (std::size_t k = 0; k < 3; ++k) {
      result[k + 1] = oriented(junction_star(mesh_, mesh_.end(star.half[k])));
    }
    return result;
  }

  const Mesh& mesh_;
  Junction junction_;
  bool energy_decay_;
  bool orientation_invariant_;
  double energy_ = 0;
  std::array<bool, 4> oriented_{};
};

/// What a junction does with its step.
struct JunctionChange {
  std::array<double, 3> pressure{}; ///< for its bubbles, before division by their films, N/cm²
  Vec2 position;                    ///< by which it was moved, cm
  bool solvable = true;             ///< its system was not singular
};

/// A share of a step.
FOAM_HOST_DEVICE inline JunctionChange share_of(const JunctionStep& step, double share) {
  JunctionChange change;
  for (std::size_t k = 0; k < 3; ++k) {
    change.pressure[k] = share * step.pressure[k];
  }
  change.position = share * step.position;
  return change;
}

/// Moves the junction by τ·Δx, halved as often as the constraints ask for; the pressures get the
/// same share of their step (Figure 4.2). Where no scale above the minimum will do, or the step is
/// not finite, nothing changes. A junction that is pinned to a wall stays, and its pressures get τ.
template <class Mesh>
FOAM_HOST_DEVICE JunctionChange move_junction(Mesh& mesh, Junction junction,
                                              const JunctionStep& step,
                                              const JunctionOptions& options) {
  JunctionChange nothing;
  if (!step.finite()) {
    nothing.solvable = false;
    return nothing;
  }
  if (!mesh.freedom(junction).any()) {
    return share_of(step, options.damping);
  }
  const MovementConstraints<Mesh> constraints(mesh, junction, options);
  Vec2& position = mesh.position[junction];
  const Vec2 old = position;
  for (double scale = 1; scale > options.minimum_scale; scale *= 0.5) {
    const JunctionChange change = share_of(step, options.damping * scale);
    position = old + change.position;
    if (constraints.hold()) {
      return change;
    }
  }
  position = old;
  return nothing;
}

/// Equilibrates one junction: solves its system, moves it and passes the pressure changes, divided
/// by the bubbles' numbers of films (3.1.3), to its bubbles.
JunctionChange equilibrate_junction(Foam& foam, Junction junction, const JunctionOptions& options);

} // namespace foam::thesis
