// SPDX-License-Identifier: GPL-3.0-or-later
//
// How core comes to compute on a device that it does not know: the library for the device says
// what it offers.
#pragma once

#include <memory>
#include <string>

#include "coarsening/coarsening.h"
#include "engines/methods.h"
#include "equilibrium/equilibrator.h"

namespace foam {

struct Accelerator {
  std::string (*unavailable)(); ///< why there is no device to use; empty if there is one
  std::unique_ptr<Equilibrator> (*make_equilibrator)(const EquilibratorOptions&);
  std::unique_ptr<Coarsening> (*make_coarsening)(const CoarseningOptions&);
};

/// Makes known what Device::CUDA computes with. To be called once, before anything else.
void register_cuda(const Accelerator& accelerator);

/// What a method shall be computed with; null for the CPU. Auto takes the device only for what it
/// computes as the CPU does, and where that is all that is missing says once, on the standard
/// error, that there is none. \throws FoamError if CUDA is asked for and cannot be had.
const Accelerator* accelerator_for(Device device, const Method& method);

} // namespace foam
