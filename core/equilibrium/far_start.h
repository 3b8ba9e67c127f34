// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>

#include "base/abort.h"
#include "equilibrium/compressible_relaxation.h"
#include "mesh/foam.h"

namespace foam {

/// Brings a foam to equilibrium from wherever it is. Where Newton's method may not be up to that,
/// or has turned out not to be, it begins anew from a foam that has been relaxed as if its gas were
/// soft (relax_compressible), and from nearer each time. A foam that gets entangled while it is
/// relaxed is relaxed again, with films swapped sooner. What is left of a foam that finds no
/// equilibrium is the nearest of what Newton's method began with last and what it came to.
/// \param far whether Newton's method may not be up to it
/// \param newton newton(foam, most) runs Newton's method for so many iterations at most, and notes
/// its report in the foam. \returns foam.report, with the iterations of all attempts.
/// \throws Aborted
template <class Newton>
EquilibriumReport equilibrate_from_afar(Foam& foam, bool far, double t1_length, int most_iterations,
                                        const AbortCheck& aborted, const Newton& newton) {
  constexpr double kNear = 0.2;     // residual that relaxed gas leaves at first,
  constexpr double kNearer = 0.25;  // and part of it that it leaves each time after
  constexpr double kSwapped = 0.05; // films of this part of the mean spacing are short at first,
  constexpr double kLongest = 8;    // and in the end those so many times longer

  newton(foam, 0);
  const Foam origin = foam;
  const auto go_back_to = [&](const Foam& before) {
    const auto topology = foam.topology;
    foam = before;
    foam.topology = topology + 1; // it is another one again
  };
  const double swapped = std::min(t1_length, kSwapped * foam.mean_spacing());
  double longer = 1;
  const auto relax = [&](double closeness) {
    while (!relax_compressible(foam, longer * swapped, closeness, aborted)) {
      if (longer == kLongest) {
        return false;
      }
      longer *= 2;
      go_back_to(origin);
    }
    return true;
  };

  double closeness = kNear;
  bool reached = true;
  const auto come_nearer = [&] {
    reached = relax(closeness);
    closeness *= kNearer;
    newton(foam, 0);
  };

  if (far) {
    come_nearer();
  }
  int iterations = 0;
  while (!foam.report.converged && iterations < most_iterations) {
    const Foam start = foam;
    newton(foam, most_iterations - iterations);
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

} // namespace foam
