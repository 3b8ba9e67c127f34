// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "coarsening/coarsening.h"

namespace foam::cuda {

/// core's NewtonFrameCoarsening on the device, where the foam stays (ResidentCoarsening).
/// \throws FoamError when the device fails, or a direct solver is asked for that this build lacks.
std::unique_ptr<Coarsening> make_newton_frame_coarsening(const CoarseningOptions& options);

} // namespace foam::cuda
