// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "equilibrium/equilibrator.h"
#include "equilibrium/options.h"

namespace foam::cuda {

/// core's KrylovEquilibrator on the device: the foam is sent there, brought to equilibrium and
/// fetched back. One so far from it that relax_compressible() is needed is relaxed on the processor
/// first.
/// \throws FoamError when the device fails, or a direct solver is asked for that this build lacks.
std::unique_ptr<Equilibrator> make_newton_equilibrator(const EquilibratorOptions& options);

} // namespace foam::cuda
