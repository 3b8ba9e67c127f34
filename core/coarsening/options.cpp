// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarsening/options.h"

#include "base/error.h"

namespace foam {

void check(const CoarseningOptions& options) {
  require(options.time_step > 0, "TimeStep", "positive", options.time_step);
  require(options.permeability >= 0, "Permeability", "at least 0", options.permeability);
  check(options.thresholds);
  check(options.equilibrator);
}

} // namespace foam
