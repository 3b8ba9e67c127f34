// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "equilibrium/equilibrator.h"
#include "equilibrium/options.h"

namespace foam::cuda {

/// core's JunctionEquilibrator with Sweep::Jacobi, on the device: the foam is sent there, swept to
/// rest and fetched back.
/// \throws FoamError for options out of range, and when the device fails.
std::unique_ptr<Equilibrator> make_junction_equilibrator(const EquilibratorOptions& options);

} // namespace foam::cuda
