// SPDX-License-Identifier: GPL-3.0-or-later
//
// How far a mesh is from solving the equilibrium's equations, on a machine (parallel/host.h).
#pragma once

#include <cmath>

#include "equilibrium/whole_foam_system.h"
#include "mesh/element_measures.h"
#include "parallel/kernels.h"

namespace foam::newton {
namespace detail {

struct ForceAt {
  FoamView mesh;
  Units units;

  FOAM_HOST_DEVICE double operator()(Index junction) const {
    if (!moves(mesh, junction)) {
      return 0;
    }
    Vec2 sum;
    for (const Index h : mesh.junction_half[FoamView::size(junction)]) {
      const Vec2 chord = mesh.chord(h);
      const double d = norm(chord);
      const double q = mesh.pressure_of(mesh.left(h)) - mesh.pressure_of(mesh.right(h));
      const FilmForces forces =
          film_forces(chord, (1 / d) * chord, d, arc_shape(mesh.half_angle(h)), q, units.tension);
      sum += Vec2{forces.ends[0], forces.ends[1]};
    }
    return norm(sum) / units.tension;
  }
};

struct CurvatureOf {
  FoamView mesh;
  Units units;

  FOAM_HOST_DEVICE double operator()(Index film) const {
    if (!bends(mesh, film)) {
      return 0;
    }
    const Index h = 2 * film;
    const double q = mesh.pressure_of(mesh.left(h)) - mesh.pressure_of(mesh.right(h));
    return std::abs(2 * std::sin(mesh.half_angle(h)) - q * norm(mesh.chord(h)) / units.tension);
  }
};

struct AreaErrorOf {
  FoamView mesh;

  FOAM_HOST_DEVICE double operator()(Index bubble) const {
    return mesh.has_bubble(bubble) ? area_error(mesh, bubble) : 0;
  }
};

} // namespace detail

/// The largest dimensionless residual, as LagrangianSystem has it.
template <class Machine>
double largest_residual(Machine& machine, const FoamView& mesh, const Units& units) {
  using namespace detail;
  constexpr parallel::Larger larger{};
  const double force = machine.reduce(mesh.junctions, 0.0, ForceAt{mesh, units}, larger);
  const double curvature = machine.reduce(mesh.films, 0.0, CurvatureOf{mesh, units}, larger);
  const double area = machine.reduce(mesh.bubbles, 0.0, AreaErrorOf{mesh}, larger);
  return larger(larger(force, curvature), area);
}

} // namespace foam::newton
