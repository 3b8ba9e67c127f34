// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamWriter.h"

#include <exception>
#include <system_error>
#include <vector>

#include "vtkAppendPolyData.h"
#include "vtkCommunicator.h"
#include "vtkErrorCode.h"
#include "vtkFieldData.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkMultiProcessController.h"
#include "vtkNew.h"
#include "vtkPolyData.h"
#include "vtkStreamingDemandDrivenPipeline.h"

using SDDP = vtkStreamingDemandDrivenPipeline;

namespace {

/// What several processes have of a data set, in one. The parts that some have of others' to look
/// at are left out.
vtkSmartPointer<vtkPolyData> Joined(const std::vector<vtkSmartPointer<vtkDataObject>>& pieces) {
  vtkNew<vtkAppendPolyData> joined;
  vtkNew<vtkFieldData> ofTheWhole;
  for (const auto& piece : pieces) {
    auto* part = vtkPolyData::SafeDownCast(piece);
    if (part && part->GetNumberOfCells() > 0) {
      if (ofTheWhole->GetNumberOfArrays() == 0) {
        ofTheWhole->ShallowCopy(part->GetFieldData());
      }
      part->RemoveGhostCells(); // and all field data with them
      joined->AddInputData(part);
    }
  }
  joined->Update();
  vtkSmartPointer<vtkPolyData> whole = joined->GetOutput();
  whole->SetFieldData(ofTheWhole);
  return whole;
}

} // namespace

vtkFoamWriter::vtkFoamWriter() : Controller(vtkMultiProcessController::GetGlobalController()) {}

vtkFoamWriter::~vtkFoamWriter() = default;

void vtkFoamWriter::SetController(vtkMultiProcessController* controller) {
  if (this->Controller != controller) {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkFoamWriter::GetController() {
  return this->Controller;
}

int vtkFoamWriter::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject"); // what it is, is told once
  return 1;
}

int vtkFoamWriter::Write() {
  this->SetErrorCode(vtkErrorCode::NoError);
  return this->Superclass::Write() && this->GetErrorCode() == vtkErrorCode::NoError;
}

vtkTypeBool vtkFoamWriter::ProcessRequest(vtkInformation* request, vtkInformationVector** inputs,
                                          vtkInformationVector* outputs) {
  if (request->Has(SDDP::REQUEST_UPDATE_EXTENT())) {
    vtkInformation* input = inputs[0]->GetInformationObject(0);
    input->Set(SDDP::UPDATE_PIECE_NUMBER(), this->Piece);
    input->Set(SDDP::UPDATE_NUMBER_OF_PIECES(), this->NumberOfPieces);
    return 1;
  }
  return this->Superclass::ProcessRequest(request, inputs, outputs);
}

bool vtkFoamWriter::IsOneOfSeveral() const {
  return this->NumberOfPieces > 1 && this->Controller &&
         this->Controller->GetNumberOfProcesses() > 1;
}

vtkSmartPointer<vtkPolyData> vtkFoamWriter::WholeInput() {
  vtkSmartPointer<vtkPolyData> whole = vtkPolyData::SafeDownCast(this->GetInput());
  if (this->IsOneOfSeveral()) {
    const int spread = this->Piece > 0 && whole && whole->GetNumberOfCells() > 0;
    int anywhere = 0;
    this->Controller->AllReduce(&spread, &anywhere, 1, vtkCommunicator::MAX_OP);
    if (anywhere) {
      vtkNew<vtkPolyData> part;
      part->ShallowCopy(whole);
      std::vector<vtkSmartPointer<vtkDataObject>> pieces;
      this->Controller->Gather(part, pieces, 0);
      whole = this->Piece == 0 ? Joined(pieces) : nullptr;
    }
  }
  return whole;
}

void vtkFoamWriter::Try(const std::function<void()>& action) {
  try {
    action();
  } catch (const std::system_error& error) {
    this->SetErrorCode(static_cast<unsigned long>(error.code().value()));
    vtkErrorMacro(<< error.what());
  } catch (const std::exception& error) {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro(<< error.what());
  }
}

void vtkFoamWriter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n"
     << indent << "Piece: " << this->Piece << "\n"
     << indent << "NumberOfPieces: " << this->NumberOfPieces << "\n"
     << indent << "Controller: " << this->Controller.Get() << "\n";
}
