// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <memory>

#include "engines/evolution_options.h"
#include "equilibrium/equilibrator.h"
#include "evolution/evolution.h"

namespace foam {

/// The equilibrator that the options ask for, on the device that they ask for (methods.h).
/// \throws FoamError for options out of range, or a device that is not there.
std::unique_ptr<Equilibrator> make_equilibrator(const EquilibratorOptions& options);

/// The coarsening that goes with the equilibrator: for Newton from one topological event to the
/// next, or in fixed steps; for Junction the thesis's frame (Figures 3.13 and 4.8).
/// \throws FoamError for options out of range, or a device that is not there.
std::unique_ptr<Evolution> make_coarsening(const CoarseningOptions& options);

/// What deforms a torus. \throws FoamError for options out of range.
std::unique_ptr<Evolution> make_deformation(const DeformationOptions& options);

/// The one or the other. \throws FoamError likewise
std::unique_ptr<Evolution> make_evolution(const EvolutionOptions& options);

} // namespace foam
