// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "coarsening/coarsening.h"

namespace foam::cuda {

/// core's FrameCoarsening with Sweep::Jacobi and TopologicalAlgorithm::Simultaneous, on the device,
/// where the foam stays (ResidentCoarsening). \throws FoamError for options of the equilibrator out
/// of range, and when the device fails.
std::unique_ptr<Coarsening> make_frame_coarsening(const CoarseningOptions& options);

} // namespace foam::cuda
