// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamDeform.h"

#include <cmath>

#include "vtkObjectFactory.h"

#include "deformation/options.h"
#include "engines/evolution_options.h"

vtkStandardNewMacro(vtkFoamDeform);

using ThisClass = vtkFoamDeform;

// clang-format off
#define FOAM_OPTIONS(option, choice) \
  choice(Deformation, this->Options->kind) \
  option(StrainStep, double, this->Options->strain_step) \
  option(Amplitude, double, this->Options->amplitude)
// clang-format on

FOAM_OPTIONS(foamDefineOption, foamDefineChoice)

vtkFoamDeform::vtkFoamDeform()
    : vtkFoamEvolutionAlgorithm(100), Options(std::make_unique<foam::DeformationOptions>()) {}

vtkFoamDeform::~vtkFoamDeform() = default;

foam::EvolutionOptions vtkFoamDeform::GetEvolutionOptions() const {
  foam::DeformationOptions options = *this->Options;
  options.equilibrator = this->GetEquilibratorOptions();
  return {options};
}

double vtkFoamDeform::GetAskedTimeStep() const {
  return std::abs(this->Options->strain_step);
}

void vtkFoamDeform::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  FOAM_OPTIONS(foamPrintOption, foamPrintOption)
}
