// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamEquilibratingAlgorithm.h"

#include <cmath>
#include <exception>

#include "vtkInformationVector.h"
#include "vtkPolyData.h"
#include "vtkTimerLog.h"

#include "FoamWriting.h"
#include "Message.h"
#include "PipelineRequest.h"
#include "equilibrium/options.h"

namespace {

/// Seconds between two reports of progress.
constexpr double POLL_INTERVAL = 0.1;

} // namespace

vtkFoamEquilibratingAlgorithm::vtkFoamEquilibratingAlgorithm() {
  this->SetNumberOfOutputPorts(2);
}

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

foam::EquilibratorOptions vtkFoamEquilibratingAlgorithm::GetEquilibratorOptions() const {
  foam::EquilibratorOptions options;
  options.kind = static_cast<foam::EquilibratorKind>(this->Equilibrator);
  options.device = static_cast<foam::Device>(this->Device);
  options.tolerance = this->Tolerance;
  options.maximum_iterations = this->MaximumIterations;
  options.linear_solver = static_cast<foam::LinearSolver>(this->LinearSolver);
  options.junction.sweep = static_cast<foam::Sweep>(this->Sweep);
  options.junction.root_search = static_cast<foam::RootSearch>(this->RootSearch);
  options.junction.energy_target = static_cast<foam::EnergyTarget>(this->EnergyTarget);
  options.junction.energy_decay = this->EnergyDecay;
  options.junction.orientation_invariant = this->OrientationInvariant;
  options.junction.damping = this->Damping;
  options.junction.finite_difference_step = this->FiniteDifferenceStep;
  options.junction.jacobian_tolerance = this->JacobianTolerance;
  options.junction.pressure_tolerance = this->PressureTolerance;
  options.junction.position_tolerance = this->PositionTolerance;
  options.junction.minimum_scale = this->MinimumScale;
  return options;
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
  os << indent << "ChordError: " << this->ChordError << "\n"
     << indent << "Equilibrator: " << this->Equilibrator << "\n"
     << indent << "Device: " << this->Device << "\n"
     << indent << "Tolerance: " << this->Tolerance << "\n"
     << indent << "MaximumIterations: " << this->MaximumIterations << "\n"
     << indent << "LinearSolver: " << this->LinearSolver << "\n"
     << indent << "Sweep: " << this->Sweep << "\n"
     << indent << "RootSearch: " << this->RootSearch << "\n"
     << indent << "EnergyTarget: " << this->EnergyTarget << "\n"
     << indent << "EnergyDecay: " << this->EnergyDecay << "\n"
     << indent << "OrientationInvariant: " << this->OrientationInvariant << "\n"
     << indent << "Damping: " << this->Damping << "\n"
     << indent << "FiniteDifferenceStep: " << this->FiniteDifferenceStep << "\n"
     << indent << "JacobianTolerance: " << this->JacobianTolerance << "\n"
     << indent << "PressureTolerance: " << this->PressureTolerance << "\n"
     << indent << "PositionTolerance: " << this->PositionTolerance << "\n"
     << indent << "MinimumScale: " << this->MinimumScale << "\n";
}
