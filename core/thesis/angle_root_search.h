// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "thesis/gauss_jordan.h"
#include "thesis/junction_system.h"

namespace foam::thesis {

/// The thesis's root search (3.1): 120° between films. Of the three angles, which add up to 360°,
/// two are conditions, so that there are as many equations as unknowns.
struct AngleRootSearch {
  static constexpr std::size_t kConditions = 2;

  /// The angles that are left: not an outside's, or else not the last (3.4.1). Angle k lies between
  /// films k and k + 1.
  FOAM_HOST_DEVICE static std::array<std::size_t, kConditions> angles(const JunctionStar& star) {
    if (star.bubble[0].is_outside()) {
      return {1, 2};
    }
    return star.bubble[1].is_outside() ? std::array<std::size_t, 2>{0, 2}
                                       : std::array<std::size_t, 2>{0, 1};
  }

  /// θ, rad.
  FOAM_HOST_DEVICE static std::array<double, kConditions> values(const JunctionStar& star) {
    const auto theta = angles_between(star);
    const auto [a, b] = angles(star);
    return {theta[a], theta[b]};
  }

  FOAM_HOST_DEVICE static std::array<double, kConditions> targets(const JunctionStar& /*star*/) {
    return {2 * std::numbers::pi / 3, 2 * std::numbers::pi / 3};
  }

  /// The change z that, to first order, makes areas and angles what they shall be (3.1.7).
  FOAM_HOST_DEVICE static JunctionStep solve(const JunctionStar& /*star*/,
                                             const JunctionSystem<AngleRootSearch>& system) {
    const Vector5 z = gauss_jordan(system.jacobian, system.deviation, system.ignored);
    return {{z[0], z[1], z[2]}, {z[3], z[4]}};
  }
};

} // namespace foam::thesis
