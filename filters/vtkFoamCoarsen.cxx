// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamCoarsen.h"

#include <cmath>

#include "vtkObjectFactory.h"

#include "coarsening/options.h"
#include "engines/evolution_options.h"
#include "mesh/film_set.h"
#include "physics/thresholds.h"

vtkStandardNewMacro(vtkFoamCoarsen);

using ThisClass = vtkFoamCoarsen;

// clang-format off
#define FOAM_OPTIONS(option, choice) \
  option(TimeStep, double, this->Options->time_step) \
  option(Permeability, double, this->Options->permeability) \
  choice(Thresholds, this->Options->thresholds.kind) \
  option(T1Length, double, this->Options->thresholds.t1_length) \
  option(T2Area, double, this->Options->thresholds.t2_area) \
  option(Alpha, double, this->Options->thresholds.alpha) \
  choice(TwoSidedBubbles, this->Options->two_sided_bubbles) \
  choice(Stepping, this->Options->stepping) \
  choice(TopologicalAlgorithm, this->Options->topological_algorithm)
// clang-format on

FOAM_OPTIONS(foamDefineOption, foamDefineChoice)

vtkFoamCoarsen::vtkFoamCoarsen()
    : vtkFoamEvolutionAlgorithm(300), Options(std::make_unique<foam::CoarseningOptions>()) {}

vtkFoamCoarsen::~vtkFoamCoarsen() = default;

foam::EvolutionOptions vtkFoamCoarsen::GetEvolutionOptions() const {
  foam::CoarseningOptions options = *this->Options;
  options.equilibrator = this->GetEquilibratorOptions();
  return {options};
}

double vtkFoamCoarsen::GetAskedTimeStep() const {
  return this->Options->time_step;
}

double vtkFoamCoarsen::GetAutomaticTimeStep(const foam::FilmSet& films, double meanArea) const {
  return foam::time_step(*this->Options, films, meanArea);
}

void vtkFoamCoarsen::WarnOfStart(const foam::Foam& start) {
  constexpr double LARGEST_LENGTH = 0.2; // of the root of the bubbles' mean area
  constexpr double LARGEST_AREA = 0.1;   // of their mean area
  const double area = start.mean_area();
  const auto [length, smallest] = foam::thresholds(start, this->Options->thresholds);
  if (length > LARGEST_LENGTH * std::sqrt(area) || smallest > LARGEST_AREA * area) {
    vtkWarningMacro("The thresholds are not small beside the bubbles: T1Length is "
                    << length << " cm, T2Area " << smallest
                    << " cm², but the bubbles' mean area is " << area << " cm², its root "
                    << std::sqrt(area) << " cm. Thresholds Automatic takes a hundredth of each.");
  }
}

void vtkFoamCoarsen::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  FOAM_OPTIONS(foamPrintOption, foamPrintOption)
}
