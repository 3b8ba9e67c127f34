// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <variant>

#include "coarsening/options.h"
#include "deformation/options.h"

namespace foam {

/// How a foam changes from frame to frame.
struct EvolutionOptions {
  std::variant<CoarseningOptions, DeformationOptions> kind;

  friend bool operator==(const EvolutionOptions&, const EvolutionOptions&) = default;
};

} // namespace foam
