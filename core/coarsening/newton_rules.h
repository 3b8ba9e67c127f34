// SPDX-License-Identifier: GPL-3.0-or-later
//
// When films and bubbles give way in a foam that Newton's method keeps in equilibrium.
#pragma once

#include <algorithm>

#include "physics/gas.h"
#include "physics/swap_rule.h"
#include "physics/thresholds.h"
#include "topology/local_operations.h"

namespace foam {

inline constexpr double kSmallestArea = 1e-6;  // of the mean area: no bubble gets smaller
inline constexpr double kManySidedArea = 1e-4; // of the mean area: with more than three sides, none
inline constexpr double kSmallestLength = 1e-3; // of the mean spacing: no T1 length is shorter

/// Residual of a foam that has not met the tolerance, below which it is still one to go on from.
inline constexpr double kNearlyConverged = 1e-6;

/// Thresholds down to which there are equilibria to be found.
inline Thresholds newton_thresholds(const Thresholds& asked, double spacing) {
  return {std::max(asked.t1_length, kSmallestLength * spacing),
          std::max(asked.t2_area, kSmallestArea * spacing * spacing)};
}

/// The conditions for a bubble's end in a step of Newton's frames: it has reached its limit, the T2
/// area say, or the step would take more of its gas than it can in one go. With more than three
/// sides it first loses those beyond, by swaps of its shortest films. All other T1s are those of
/// films that are pulled shut while the foam finds its equilibrium.
struct NewtonRules {
  static constexpr double kLargestLoss = 0.5; // of a bubble's gas in a step

  Thresholds limit{};
  TwoSidedRule two_sided{};
  double many_sided_area = 0; ///< at which a bubble with more than three sides loses them, cm²
  AreaRate rate{};            ///< at which gas is lost
  double time_step = 0;       ///< s
  ConstFieldView<Film, std::uint8_t> swappable{}; ///< of a film: not swapped yet

  template <class Mesh> FOAM_HOST_DEVICE static double film_size(const Mesh& mesh, Film film) {
    return mesh.length(film.half());
  }
  template <class Mesh>
  FOAM_HOST_DEVICE static double bubble_size(const Mesh& mesh, Bubble bubble) {
    return mesh.target_area[bubble];
  }

  /// Area at which the bubble's end has come, however short the step, cm².
  template <class Mesh> FOAM_HOST_DEVICE double end_area(const Mesh& mesh, Bubble bubble) const {
    return mesh.sides[bubble] <= 3 ? limit.t2_area : many_sided_area;
  }
  /// The least gas with which the bubble can go through the step, cm².
  FOAM_HOST_DEVICE double needed(Bubble bubble) const {
    return std::max(-rate(bubble), 0.0) * time_step / kLargestLoss;
  }
  template <class Mesh> FOAM_HOST_DEVICE bool vanishes(const Mesh& mesh, Bubble bubble) const {
    const double area = mesh.target_area[bubble];
    return area <= limit.t2_area || area < needed(bubble);
  }
  /// Whether the film is to be swapped so that a bubble beside it has a side less, or so that a
  /// two-sided one that has slid there has one more.
  template <class Mesh> FOAM_HOST_DEVICE bool shrunk(const Mesh& mesh, Film film) const {
    const Half h = film.half();
    return takes_side(mesh, mesh.left(h), film) || takes_side(mesh, mesh.right(h), film) ||
           ((slid_to(mesh, h) || slid_to(mesh, h.twin())) && spares_sides(mesh, film));
  }
  template <class Mesh> FOAM_HOST_DEVICE bool slides(const Mesh& mesh, Bubble bubble) const {
    return two_sided.slides(mesh, bubble);
  }

private:
  template <class Mesh>
  FOAM_HOST_DEVICE bool takes_side(const Mesh& mesh, Bubble bubble, Film film) const {
    if (bubble.is_outside() || mesh.sides[bubble] <= 3) {
      return false;
    }
    const double area = mesh.target_area[bubble];
    const double gas = needed(bubble);
    return gas > 0 && (area <= many_sided_area || area < gas) && film_to_swap(mesh, bubble) == film;
  }

  /// The shortest film by which the bubble can lose a side; one whose other bubble cannot well
  /// spare one only if there is no other.
  template <class Mesh> FOAM_HOST_DEVICE Film film_to_swap(const Mesh& mesh, Bubble bubble) const {
    Film best = kNone;
    bool best_spares = false;
    for_each_half(mesh, bubble, [&](Half h) {
      const Film film = h.film();
      if (swappable[film] && can_perform_t1(mesh, film)) {
        const bool spares = spares_sides(mesh, film);
        const bool shorter = best == kNone || film_size(mesh, film) < film_size(mesh, best);
        if (best == kNone || (spares == best_spares ? shorter : spares)) {
          best = film;
          best_spares = spares;
        }
      }
    });
    return best;
  }

  /// Whether a two-sided bubble has slid to the corner at the end of h.
  template <class Mesh> FOAM_HOST_DEVICE bool slid_to(const Mesh& mesh, Half h) const {
    const Bubble bubble = mesh.left(mesh.next_around_junction(h));
    return !bubble.is_outside() && mesh.sides[bubble] == 2 && slides(mesh, bubble) &&
           mesh.length(h) <= limit.t1_length;
  }
};

} // namespace foam
