// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "coarsening/options.h"
#include "evolution/evolution.h"

namespace foam {

/// The coarsening of a foam, frame by frame. Composes an equilibrator.
///
/// The foam's record gets the thresholds that are in force when it begins. It cannot go on where a
/// bubble would vanish that cannot, one of a double bubble, say, for a single bubble has no
/// junction and is outside the model; or where no equilibrium is found for what would come next.
class Coarsening : public Evolution {
public:
  double frame_time() const override { return record().time_step; }
};

} // namespace foam
