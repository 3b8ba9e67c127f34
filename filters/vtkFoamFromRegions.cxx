// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamFromRegions.h"

#include "vtkCellData.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkPolyData.h"

#include "PipelineRequest.h"
#include "construct/division.h"
#include "physics/equilibrium_measures.h"
#include "sampling/sampled_foam.h"

vtkFoamFromRegions::vtkFoamFromRegions() = default;
vtkFoamFromRegions::~vtkFoamFromRegions() = default;

int vtkFoamFromRegions::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject"); // what it is, is told once
  return 1;
}

int vtkFoamFromRegions::RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputs,
                                            vtkInformationVector* outputs) {
  if (foam::filters::is_first_piece(request, outputs)) {
    foam::filters::request_whole(inputs[0]->GetInformationObject(0));
  }
  return 1;
}

void vtkFoamFromRegions::ShowFoam(foam::DivisionFoam& made, vtkInformationVector* outputs) {
  made.foam.report = foam::measured_report(made.foam);
  this->BringToEquilibrium(made.foam, this->Equilibrate);
  this->WriteOutputs(foam::sample(made.foam, this->GetChordError()), outputs);
  vtkPolyData* films = vtkPolyData::GetData(outputs, 0);
  vtkNew<vtkDoubleArray> misfit;
  misfit->SetName("ArcMisfit");
  for (const foam::Film f : made.foam.film_slots()) {
    if (made.foam.has_film(f)) {
      misfit->InsertNextValue(made.misfit[f.place()]);
    }
  }
  films->GetCellData()->AddArray(misfit);
  vtkNew<vtkIdTypeArray> points;
  points->SetName("FourFoldPoints");
  points->InsertNextValue(made.points_of_more_films);
  films->GetFieldData()->AddArray(points);
}

void vtkFoamFromRegions::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "SurfaceTension: " << this->SurfaceTension << "\n"
     << indent << "Equilibrate: " << this->Equilibrate << "\n";
}
