// SPDX-License-Identifier: GPL-3.0-or-later
//
// What core's algorithms are on the device.
#pragma once

#include <memory>

#include "coarsening/coarsening.h"
#include "equilibrium/equilibrator.h"

namespace foam::cuda {

/// core's KrylovEquilibrator, or its JunctionEquilibrator with Sweep::Jacobi: the foam is sent to
/// the device, brought to equilibrium and fetched back. One so far from it that Newton needs
/// relax_compressible() is relaxed on the processor first.
/// \throws FoamError for options out of range, when the device fails, or when a direct solver is
/// asked for that this build lacks.
std::unique_ptr<Equilibrator> make_equilibrator(const EquilibratorOptions& options);

/// core's NewtonFrameCoarsening, or its FrameCoarsening with Sweep::Jacobi and
/// TopologicalAlgorithm::Simultaneous: the foam stays on the device (ResidentCoarsening).
/// \throws FoamError as above.
std::unique_ptr<Coarsening> make_coarsening(const CoarseningOptions& options);

} // namespace foam::cuda
