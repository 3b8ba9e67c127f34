// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamEvolverReader.h"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <string>

#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "Message.h"
#include "evolver/datafile.h"
#include "evolver/read_foam.h"
#include "physics/equilibrium_measures.h"
#include "sampling/sampled_foam.h"

vtkStandardNewMacro(vtkFoamEvolverReader);

namespace {

std::string ContentOf(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file || std::filesystem::is_directory(path)) {
    foam::filters::fail("cannot read ", path.string());
  }
  return {std::istreambuf_iterator<char>(file), std::istreambuf_iterator<char>()};
}

} // namespace

vtkFoamEvolverReader::vtkFoamEvolverReader() {
  this->SetNumberOfInputPorts(0);
}

vtkFoamEvolverReader::~vtkFoamEvolverReader() = default;

int vtkFoamEvolverReader::CanReadFile(const char* fileName) {
  constexpr std::size_t HEADER = 1 << 20; // the keyword stands before the vertices
  std::ifstream file(fileName, std::ios::binary);
  std::string start(HEADER, '\0');
  file.read(start.data(), static_cast<std::streamsize>(start.size()));
  start.resize(static_cast<std::size_t>(file.gcount()));
  return foam::evolver::is_string_model(start) ? 1 : 0;
}

void vtkFoamEvolverReader::MakeFoam(vtkInformation*, vtkInformationVector**,
                                    vtkInformationVector* outputs) {
  if (this->FileName.empty()) {
    foam::filters::fail("FileName names no file to read");
  }
  const std::filesystem::path path = this->FileName;
  foam::EvolverFoam read;
  try {
    read = foam::read_evolver(ContentOf(path), [&](const std::string& name) {
      return ContentOf(path.parent_path() / name);
    });
  } catch (const foam::FoamError& error) {
    foam::filters::fail(this->FileName, ": ", error.what());
  }
  for (const std::string& warning : read.warnings) {
    vtkWarningMacro(<< this->FileName << ": " << warning);
  }
  read.foam.report = foam::measured_report(read.foam);
  this->BringToEquilibrium(read.foam, this->Equilibrate);
  this->WriteOutputs(foam::sample(read.foam, this->GetChordError()), outputs);
  vtkNew<vtkDoubleArray> misfit;
  misfit->SetName("ArcMisfit");
  misfit->InsertNextValue(read.largest_misfit);
  vtkPolyData::GetData(outputs, 0)->GetFieldData()->AddArray(misfit);
}

void vtkFoamEvolverReader::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FileName: " << this->FileName << "\n"
     << indent << "Equilibrate: " << this->Equilibrate << "\n";
}
