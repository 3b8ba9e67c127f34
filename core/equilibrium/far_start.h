// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "base/abort.h"
#include "equilibrium/compressible_relaxation.h"
#include "geometry/bounds.h"
#include "mesh/foam.h"
#include "physics/measured_targets.h"
#include "topology/wall_contact.h"

namespace foam {

/// relax_compressible() of a foam whose gas comes and goes in steps: from the areas that bubbles
/// have, target areas change by the same factor in each. A bubble that is to shrink loses its
/// neighbours one by one.
inline bool relax_in_steps(Foam& foam, int steps, double shortness, double closeness,
                           const AbortCheck& aborted) {
  constexpr double kLeast = 1e-3; // of a target area, that a bubble is taken to have
  Foam way = foam;
  const double gas = foam.bubble_count() * foam.mean_area();
  const auto fill = [&](double rest) { // A^τ·(A/A^τ)^rest, of as much gas in all
    double sum = 0;
    for (const Bubble b : foam.bubble_slots()) {
      if (foam.has_bubble(b)) {
        const double target = foam.target_area[b];
        way.target_area[b] = target * std::pow(std::max(foam.area(b) / target, kLeast), rest);
        sum += way.target_area[b];
      }
    }
    for (double& area : way.target_area) {
      area *= gas / sum;
    }
  };
  bool reached = true;
  for (int step = 1; step < steps && reached; ++step) {
    fill(1 - static_cast<double>(step) / steps);
    reached = relax_compressible(way, shortness, closeness, aborted);
  }
  way.target_area = foam.target_area;
  foam = way; // a copy, since there are views of the foam's arrays
  return reached && relax_compressible(foam, shortness, closeness, aborted);
}

/// Nothing holds a free foam to a size: it takes at once the one that its gas asks for, if that is
/// another by far, round its middle and with the pressures that go with its arcs then.
inline void take_size_of_gas(Foam& foam) {
  constexpr double kFar = 2;
  if (foam.surroundings.closed()) {
    return;
  }
  double area = 0;
  for (const Bubble b : foam.bubble_slots()) {
    area += foam.has_bubble(b) ? foam.area(b) : 0;
  }
  const double gas = foam.bubble_count() * foam.mean_area();
  if (!(area > 0) || std::max(area / gas, gas / area) < kFar) {
    return;
  }
  const Bounds bounds = bounds_of(foam.position);
  const Vec2 middle = bounds.low + 0.5 * bounds.extent();
  const double length = std::sqrt(gas / area);
  for (Vec2& position : foam.position) {
    position = middle + length * (position - middle);
  }
  fit_bubble_pressures(foam);
}

/// Brings a foam to equilibrium from wherever it is. Where Newton's method may not be up to that,
/// or has turned out not to be, it begins anew from a foam that has been relaxed as if its gas were
/// soft (relax_compressible), and from nearer each time. A foam that gets entangled while it is
/// relaxed is relaxed again, with films swapped sooner, and then in steps. What is left of a foam
/// that finds no equilibrium is the nearest of what Newton's method began with last and what it
/// came to.
/// \param is_far is_far(foam) says whether Newton's method may not be up to it
/// \param newton newton(foam, most) runs Newton's method for so many iterations at most, and notes
/// its report in the foam. \returns foam.report, with the iterations of all attempts.
/// \throws Aborted
template <class IsFar, class Newton>
EquilibriumReport find_equilibrium(Foam& foam, const IsFar& is_far, double t1_length,
                                   int most_iterations, const AbortCheck& aborted,
                                   const Newton& newton) {
  constexpr double kNear = 0.2;     // residual that relaxed gas leaves at first,
  constexpr double kNearer = 0.25;  // and part of it that it leaves each time after
  constexpr double kSwapped = 0.05; // films of this part of a bubble's size are short at first,
  constexpr double kLongest = 4;    // and in the end those so many times longer
  constexpr int kMostSteps = 16;    // in which gas comes in the end
  constexpr int kPatience = 64;     // iterations in which Newton's method gets there, or needs help

  take_size_of_gas(foam);
  const bool far = is_far(foam);
  newton(foam, 0);
  const Foam origin = foam;
  const auto go_back_to = [&](const Foam& before) {
    const auto topology = foam.topology;
    foam = before;
    foam.topology = topology + 1; // it is another one again
  };
  const double swapped = std::min(t1_length / foam.mean_spacing(), kSwapped);
  double longer = 1;
  int steps = 1;
  double closeness = kNear;
  bool reached = true;
  const auto relax_otherwise = [&] {
    if (longer < kLongest) {
      longer *= 2;
    } else {
      longer = 1;
      steps *= 4;
    }
    closeness = kNear;
    go_back_to(origin);
  };
  const auto come_nearer = [&] {
    while (!relax_in_steps(foam, steps, longer * swapped, closeness, aborted)) {
      if (longer == kLongest && steps == kMostSteps) {
        reached = false;
        break;
      }
      relax_otherwise();
    }
    closeness *= kNearer;
    newton(foam, 0);
  };

  if (far) {
    come_nearer();
  }
  int iterations = 0;
  while (!foam.report.converged && iterations < most_iterations) {
    const Foam start = foam;
    const int left = most_iterations - iterations;
    newton(foam, reached ? std::min(left, kPatience) : left);
    iterations += foam.report.iterations;
    if (foam.report.converged) {
      break;
    }
    const bool last = !reached || iterations >= most_iterations;
    if (!last || !(foam.report.residual < start.report.residual)) {
      go_back_to(start);
    }
    if (last) {
      break;
    }
    come_nearer();
  }
  if (!std::isfinite(foam.report.residual)) { // no foam at all
    go_back_to(origin);
  }
  foam.report.iterations = iterations;
  return foam.report;
}

/// The same, and again with films that have gone beyond obstacles ending on these, until there is
/// none.
template <class IsFar, class Newton>
EquilibriumReport equilibrate_from_afar(Foam& foam, const IsFar& is_far, double t1_length,
                                        int most_iterations, const AbortCheck& aborted,
                                        const Newton& newton) {
  do {
    find_equilibrium(foam, is_far, t1_length, most_iterations, aborted, newton);
  } while (foam.report.converged && t1_length > 0 && touch_walls(foam));
  return foam.report;
}

} // namespace foam
