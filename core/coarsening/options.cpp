// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarsening/options.h"

#include "base/error.h"
#include "physics/gas.h"

namespace foam {
namespace {

constexpr double kAutomaticSteps = 300;
/// In the scaling state the mean area grows by 0.85 to 1.0 K a second, K = (2π/3)γκ (J. Stavans, J.
/// A. Glazier, Phys. Rev. Lett. 62 (1989) 1318), so that it is three times the first one, Ā, after
/// about so many Ā/K.
constexpr double kTimeToAThird = 2.2;

} // namespace

double time_step(const CoarseningOptions& options, const FoamRecord& foam, double mean_area) {
  if (options.time_step > 0) {
    return options.time_step;
  }
  const double constant = von_neumann_constant(foam.surface_tension, options.permeability);
  if (foam.time_step > 0 && foam.growth_constant == constant) {
    return foam.time_step;
  }
  const double permeability = options.permeability > 0 ? options.permeability : 1;
  const double growth = von_neumann_constant(foam.surface_tension, permeability);
  return kTimeToAThird * mean_area / growth / kAutomaticSteps;
}

void check(const CoarseningOptions& options) {
  require(options.time_step >= 0, "TimeStep", "at least 0", options.time_step);
  require(options.permeability >= 0, "Permeability", "at least 0", options.permeability);
  check(options.thresholds);
  check(options.equilibrator);
}

} // namespace foam
