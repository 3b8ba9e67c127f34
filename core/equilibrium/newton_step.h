// SPDX-License-Identifier: GPL-3.0-or-later
//
// A step of Newton's method for a whole foam, element by element: from the solution of its
// equations to how much of it is taken.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>

#include "equilibrium/whole_foam_system.h"
#include "physics/step_limits.h"

namespace foam::newton {

/// A change of a foam's unknowns, by element.
struct StepView {
  Vec2* junction = nullptr;   ///< cm
  double* angle = nullptr;    ///< rad, by film
  double* pressure = nullptr; ///< N/cm², by bubble

  FOAM_HOST_DEVICE Vec2 chord_change(const FoamView& mesh, Index film) const {
    return junction[mesh.end(2 * film)] - junction[mesh.start(2 * film)];
  }
};

namespace detail {

inline constexpr double kLargestMove = 0.3; // of a junction's shortest film, in a limited step

/// A solution with its units.
struct TakeJunctionStep {
  Units units;
  const double* solution = nullptr;
  StepView step;

  FOAM_HOST_DEVICE void operator()(Index junction) const {
    step.junction[junction] = units.length * displacement(solution, junction);
  }
};

struct TakePressureStep {
  FoamView mesh;
  Units units;
  const double* solution = nullptr;
  StepView step;

  FOAM_HOST_DEVICE void operator()(Index bubble) const {
    step.pressure[bubble] = units.pressure() * pressure_in(mesh, solution, bubble);
  }
};

struct TakeAngleStep {
  FoamView mesh;
  Units units;
  double stiffening = 0;
  const double* solution = nullptr;
  StepView step;

  FOAM_HOST_DEVICE void operator()(Index film) const {
    step.angle[film] =
        bends(mesh, film) ? angle_change(mesh, film, units, stiffening, solution) : 0;
  }
};

/// The fraction of a step that the film can take.
struct LongestStep {
  FoamView mesh;
  StepView step;

  FOAM_HOST_DEVICE double operator()(Index film) const {
    return bends(mesh, film)
               ? longest_film_step(mesh.chord(2 * film), step.chord_change(mesh, film),
                                   mesh.half_angle(2 * film), step.angle[film])
               : 1;
  }
};

/// No junction moves by more than a part of its shortest film (limited_step).
struct LimitJunction {
  FoamView mesh;
  StepView step;

  FOAM_HOST_DEVICE void operator()(Index junction) const {
    if (!moves(mesh, junction)) {
      return;
    }
    double shortest = std::numeric_limits<double>::infinity();
    for (const Index h : mesh.junction_half[FoamView::size(junction)]) {
      shortest = std::min(shortest, norm(mesh.chord(h)));
    }
    const double length = norm(step.junction[junction]);
    if (length > kLargestMove * shortest) {
      step.junction[junction] = (kLargestMove * shortest / length) * step.junction[junction];
    }
  }
};

/// No arc turns by more than half a radian (limited_step).
struct LimitAngle {
  FoamView mesh;
  StepView step;

  FOAM_HOST_DEVICE void operator()(Index film) const {
    const double largest = largest_turn(mesh.film_angle[film], step.angle[film]);
    step.angle[film] = std::clamp(step.angle[film], -largest, largest);
  }
};

/// to[i] ← from[i] + fraction·step[i]
template <class T> struct Walk {
  const T* from = nullptr;
  const T* step = nullptr;
  double fraction = 0;
  T* to = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const { to[i] = from[i] + fraction * step[i]; }
};

struct LengthOf {
  FoamView mesh;

  FOAM_HOST_DEVICE double operator()(Index film) const {
    return bends(mesh, film) ? mesh.length(2 * film) : 0;
  }
};

struct ViolationOf {
  FoamView mesh;

  FOAM_HOST_DEVICE double operator()(Index bubble) const {
    return mesh.has_bubble(bubble) ? std::abs(mesh.area(bubble) - mesh.target_area[bubble]) : 0;
  }
};

struct LargestPressure {
  FoamView mesh;
  StepView step;

  FOAM_HOST_DEVICE double operator()(Index bubble) const {
    if (!mesh.has_bubble(bubble)) {
      return 0;
    }
    const double p = mesh.pressure[bubble];
    return std::max(std::abs(p), std::abs(p + step.pressure[bubble]));
  }
};

/// How fast a film grows along a step.
struct GrowthOf {
  FoamView mesh;
  StepView step;

  FOAM_HOST_DEVICE double operator()(Index film) const {
    return bends(mesh, film) ? arc_growth(mesh.chord(2 * film), step.chord_change(mesh, film),
                                          mesh.half_angle(2 * film), step.angle[film])
                             : 0;
  }
};

} // namespace detail
} // namespace foam::newton
