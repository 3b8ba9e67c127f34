// SPDX-License-Identifier: GPL-3.0-or-later
#include "deformation/options.h"

#include <cmath>

#include "base/error.h"

namespace foam {

void check(const DeformationOptions& options) {
  require(std::isfinite(options.strain_step) && options.strain_step != 0, "StrainStep",
          "finite and not 0", options.strain_step);
  require(options.amplitude == 0 || (options.amplitude >= std::abs(options.strain_step) &&
                                     std::isfinite(options.amplitude)),
          "Amplitude", "0, or at least the StrainStep and finite", options.amplitude);
  check(options.equilibrator);
  if (options.equilibrator.kind != EquilibratorKind::Newton) {
    throw FoamError("a foam is deformed from T1 to T1 by Equilibrator = Newton alone");
  }
  if (options.equilibrator.device == Device::CUDA) {
    throw FoamError("a foam is deformed on the CPU alone, but Device is CUDA");
  }
}

} // namespace foam
