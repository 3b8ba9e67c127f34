// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamEvolverWriter.h"

#include <exception>
#include <system_error>

#include "vtkErrorCode.h"
#include "vtkInformation.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "FilmReading.h"
#include "Message.h"
#include "WholeFile.h"
#include "evolver/write_foam.h"

vtkStandardNewMacro(vtkFoamEvolverWriter);

vtkFoamEvolverWriter::vtkFoamEvolverWriter() = default;
vtkFoamEvolverWriter::~vtkFoamEvolverWriter() = default;

int vtkFoamEvolverWriter::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject"); // what it is, is told once
  return 1;
}

int vtkFoamEvolverWriter::Write() {
  this->SetErrorCode(vtkErrorCode::NoError);
  return this->Superclass::Write() && this->GetErrorCode() == vtkErrorCode::NoError;
}

void vtkFoamEvolverWriter::WriteData() {
  try {
    if (this->FileName.empty()) {
      foam::filters::fail("FileName names no file to write");
    }
    const foam::Foam foam = foam::filters::read_foam(foam::filters::films_in(this->GetInput()));
    foam::filters::write_whole(this->FileName, foam::write_evolver(foam));
  } catch (const std::system_error& error) {
    this->SetErrorCode(static_cast<unsigned long>(error.code().value()));
    vtkErrorMacro(<< error.what());
  } catch (const std::exception& error) {
    this->SetErrorCode(vtkErrorCode::UserError);
    vtkErrorMacro(<< error.what());
  }
}

void vtkFoamEvolverWriter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n";
}
