// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "construct/containers.h"
#include "mesh/foam.h"

namespace foam {

/// Where the bubbles' target areas come from.
enum class TargetAreas {
  Initial, ///< each bubble's area in the initial mesh (thesis 4.5.3)
  Uniform, ///< the mean of those for every bubble
  Array    ///< given, one per point
};

struct BuildOptions {
  Boundary boundary = Boundary::Free;
  std::optional<Lattice> torus; ///< cm; without one default_torus()
  bool fold = false;            ///< whether points may extend over more than the torus
  Container container;          ///< that is filled
  TargetAreas target_areas = TargetAreas::Initial;
  /// cm², one per point, > 0; on a torus and in a container they must add up to its area, to 1 %.
  std::vector<double> target_area_array;
  bool fit_areas = false;        ///< scale those by any factor, so that they do
  double surface_tension = 0.25; ///< γ, N/cm, > 0
  /// How far the tips of the fins (thesis 4.5.3, s in the formula for x_free) stand out from the
  /// boundary, cm; 0 stands for 1.5 mean spacings, √(area of the triangles per point). No fin is
  /// longer than 1.5 times its edge.
  double fin_size = 0;
};

/// The initial foam of a set of points: one bubble per point, with the point's index as its id, one
/// junction per Delaunay triangle at its barycentre, one film per Delaunay edge, straight,
/// pressures 0 (thesis 4.5.3). For a free or fixed boundary each edge of the triangulation's
/// outline has a junction on the outside, at the barycentre of the thesis's fin. The outline is the
/// points' hull, less the flat triangles on it that see their outer edge under more than 132°: they
/// would make bubbles many spacings long. Every bubble has a positive area: where barycentres do
/// not achieve that, incentres take their place. Not in equilibrium yet.
///
/// A function of the points and options alone. Points outside of a torus's cell are wrapped into
/// it; that they extend over more than it is an error unless they are to be folded.
/// \param points cm, at least 3, finite, distinct (on a torus modulo its periods), not all on a
/// line. \throws FoamError naming the cause and the offending value.
Foam build_from_points(std::span<const Vec2> points, const BuildOptions& options);

} // namespace foam
