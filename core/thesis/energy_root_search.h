// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "equilibrium/options.h"
#include "thesis/junction_system.h"
#include "thesis/least_squares.h"

namespace foam::thesis {

/// The point with the least sum of distances to three others (Fermat, Steiner). Its barycentric
/// coordinates are 1/(s_k + S/√3), s_k the scalar product of the two sides that leave corner k and
/// S twice the area (Kimberling, Encyclopedia of Triangle Centers, X(13)). Where a corner has 120°
/// or more, or is two corners in one place, it is that corner.
FOAM_HOST_DEVICE inline Vec2 steiner_point(const std::array<Vec2, 3>& corner) {
  const double twice_area = std::abs(cross(corner[1] - corner[0], corner[2] - corner[0]));
  std::array<double, 3> inverse{};
  for (std::size_t k = 0; k < 3; ++k) {
    inverse[k] = dot(corner[after(k)] - corner[k], corner[before(k)] - corner[k]) +
                 twice_area / std::numbers::sqrt3;
    if (inverse[k] <= 0) {
      return corner[k];
    }
  }
  Vec2 sum;
  double weights = 0;
  for (std::size_t k = 0; k < 3; ++k) {
    const double weight = inverse[after(k)] * inverse[before(k)];
    sum += weight * corner[k];
    weights += weight;
  }
  return (1 / weights) * sum;
}

/// The root search that the thesis proposes (7.1.1) and leaves untried: target energies for the
/// films in the place of angles between them. Six equations for five unknowns, solved by least
/// squares.
///
/// The thesis wants areas (cm²) and energies (N) "of equal importance", which has no meaning before
/// one is converted to the other. What a bubble's area lacks counts as the energy that a round
/// bubble of its target area would gain with it, dE/dA = 2γ·√(π/A^τ) (its pressure), so that the
/// unit of length and γ do not matter. On random free foams, areas that count a quarter of that are
/// not kept, and with areas that count twice that, fewer foams come to rest.
///
/// The search unravels inverted junctions with Zero, as the thesis expects, but for neither target
/// is the foam's equilibrium a root: film energies leave out the work of the pressures, with which
/// ∂E/∂x = Σ p·∂A/∂x there, and not 0. With Zero, junctions seek the least sum of squares of their
/// films' energies, for straight films their neighbours' centroid, and stop with angles that are
/// off; with Straight, the point that films without pressure would shrink to, and films contract
/// until junctions meet.
struct EnergyRootSearch {
  static constexpr std::size_t kConditions = 3;

  EnergyTarget target = EnergyTarget::Zero;

  /// E_k = 2γ·l_k (3.5.2), N.
  FOAM_HOST_DEVICE static std::array<double, kConditions> values(const JunctionStar& star) {
    std::array<double, kConditions> energy{};
    for (std::size_t k = 0; k < 3; ++k) {
      energy[k] = star.tension * film_length(star, k);
    }
    return energy;
  }

  /// E^τ, N.
  FOAM_HOST_DEVICE std::array<double, kConditions> targets(const JunctionStar& star) const {
    std::array<double, kConditions> energy{};
    if (target == EnergyTarget::Straight) {
      const Vec2 steiner = steiner_point(star.chord);
      for (std::size_t k = 0; k < 3; ++k) {
        energy[k] = star.tension * norm(star.chord[k] - steiner);
      }
    }
    return energy;
  }

  /// The change z that, to first order, leaves the least sum of squared deviations, in N.
  FOAM_HOST_DEVICE static JunctionStep solve(const JunctionStar& star,
                                             JunctionSystem<EnergyRootSearch> system) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (!star.bubble[k].is_outside()) {
        const double pressure = star.tension * std::sqrt(std::numbers::pi / star.target_area[k]);
        for (double& derivative : system.jacobian[k]) {
          derivative *= pressure;
        }
        system.deviation[k] *= pressure;
      }
    }
    const auto z = least_squares(system.jacobian, system.deviation, system.ignored);
    return {{z[0], z[1], z[2]}, {z[3], z[4]}};
  }
};

} // namespace foam::thesis
