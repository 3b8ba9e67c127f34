// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamEquilibratingAlgorithm.h"

#include <algorithm>
#include <cmath>
#include <exception>

#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkTimerLog.h"

#include "FoamWriting.h"
#include "Message.h"
#include "PipelineRequest.h"
#include "engines/engines.h"
#include "equilibrium/options.h"
#include "physics/equilibrium_measures.h"
#include "physics/obstacle.h"

namespace {

/// Seconds between two reports of progress.
constexpr double POLL_INTERVAL = 0.1;

/// T1 threshold of the first equilibration, in mean spacings.
constexpr double T1_LENGTH = 0.05;

/// How far a foam is from equilibrium: angles (rad) and areas (relative).
double Residual(const foam::Foam& foam) {
  return std::max(foam::max_angle_error(foam), foam::max_area_error(foam));
}

} // namespace

using ThisClass = vtkFoamEquilibratingAlgorithm;

// clang-format off
#define FOAM_OPTIONS(option, choice) \
  choice(Equilibrator, this->Options->kind) \
  choice(Device, this->Options->device) \
  option(Tolerance, double, this->Options->tolerance) \
  option(MaximumIterations, int, this->Options->maximum_iterations) \
  choice(LinearSolver, this->Options->linear_solver) \
  choice(Sweep, this->Options->junction.sweep) \
  choice(RootSearch, this->Options->junction.root_search) \
  choice(EnergyTarget, this->Options->junction.energy_target) \
  option(EnergyDecay, bool, this->Options->junction.energy_decay) \
  option(OrientationInvariant, bool, this->Options->junction.orientation_invariant) \
  option(Damping, double, this->Options->junction.damping) \
  option(FiniteDifferenceStep, double, this->Options->junction.finite_difference_step) \
  option(JacobianTolerance, double, this->Options->junction.jacobian_tolerance) \
  option(PressureTolerance, double, this->Options->junction.pressure_tolerance) \
  option(PositionTolerance, double, this->Options->junction.position_tolerance) \
  option(MinimumScale, double, this->Options->junction.minimum_scale)
// clang-format on

FOAM_OPTIONS(foamDefineOption, foamDefineChoice)

vtkFoamEquilibratingAlgorithm::vtkFoamEquilibratingAlgorithm()
    : Options(std::make_unique<foam::EquilibratorOptions>()) {
  this->SetNumberOfOutputPorts(2);
}

vtkFoamEquilibratingAlgorithm::~vtkFoamEquilibratingAlgorithm() = default;

int vtkFoamEquilibratingAlgorithm::RequestData(vtkInformation* request,
                                               vtkInformationVector** inputs,
                                               vtkInformationVector* outputs) {
  if (!foam::filters::is_first_piece(request, outputs)) {
    this->ClearOutputs(outputs);
    return 1;
  }
  this->SetAbortExecute(0); // what ended an earlier request
  try {
    this->CheckOutputProperties();
    this->MakeFoam(request, inputs, outputs);
  } catch (const std::exception& error) {
    this->ClearOutputs(outputs);
    vtkErrorMacro(<< error.what());
  }
  return 1;
}

void vtkFoamEquilibratingAlgorithm::CheckOutputProperties() const {
  if (!(this->ChordError >= 0) || !std::isfinite(this->ChordError)) {
    foam::filters::fail("ChordError must be 0 or positive, but is ", this->ChordError);
  }
}

void vtkFoamEquilibratingAlgorithm::WriteOutputs(const foam::SampledFoam& sampled,
                                                 vtkInformationVector* outputs) {
  foam::filters::write_films(sampled, vtkPolyData::GetData(outputs, 0));
  foam::filters::write_bubbles(sampled, vtkPolyData::GetData(outputs, 1));
}

void vtkFoamEquilibratingAlgorithm::ClearOutputs(vtkInformationVector* outputs) {
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port) {
    vtkPolyData::GetData(outputs, port)->Initialize();
  }
}

void vtkFoamEquilibratingAlgorithm::BringToEquilibrium(foam::Foam& foam, bool equilibrate) {
  const auto equilibrator = foam::make_equilibrator(*this->Options);
  if (!equilibrate) {
    return;
  }
  // The part of the way that the residual has fallen, on a logarithmic scale.
  const double first = Residual(foam);
  const double way = std::log(first / this->Options->tolerance);
  double progress = 0;
  const auto aborted = [&] {
    progress = std::max(progress, std::min(1.0, std::log(first / Residual(foam)) / way));
    return this->PollAbort(progress);
  };
  try {
    equilibrator->equilibrate(foam, T1_LENGTH * foam.mean_spacing(), aborted);
    if (!foam.report.converged) {
      vtkWarningMacro("The foam did not reach equilibrium: residual "
                      << foam.report.residual << " after " << foam.report.iterations
                      << " iterations. What stands in the way: " << foam::obstacle(foam) << ".");
    }
  } catch (const foam::Aborted&) {
    // What there is of the foam is shown.
  }
}

bool vtkFoamEquilibratingAlgorithm::PollAbort(double progress) {
  const double now = vtkTimerLog::GetUniversalTime();
  if (now - this->LastPoll > POLL_INTERVAL || now < this->LastPoll) {
    this->LastPoll = now;
    this->UpdateProgress(progress);
  }
  return this->GetAbortExecute() != 0;
}

void vtkFoamEquilibratingAlgorithm::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "ChordError: " << this->ChordError << "\n";
  FOAM_OPTIONS(foamPrintOption, foamPrintOption)
}
