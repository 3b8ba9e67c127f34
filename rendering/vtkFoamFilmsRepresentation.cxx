// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamFilmsRepresentation.h"

#include <vtkObjectFactory.h>
#include <vtkPVLODActor.h>
#include <vtkPVView.h>
#include <vtkProperty.h>

#include "vtkFoamFilmMapper.h"

vtkStandardNewMacro(vtkFoamFilmsRepresentation);

vtkFoamFilmsRepresentation::vtkFoamFilmsRepresentation() {
  this->Mapper->Delete();
  auto* mapper = vtkFoamFilmMapper::New();
  mapper->SetProcessIdArrayName("vtkProcessId");
  mapper->SetCompositeIdArrayName("vtkCompositeIndex");
  this->Mapper = mapper;
  this->Representation = WIREFRAME; // colours as they are, without light
  this->SetupDefaults();
  this->Property->LightingOff();
  this->Actor->ForceTranslucentOn();
}

void vtkFoamFilmsRepresentation::SetFilmWidth(double width) {
  vtkFoamFilmMapper::SafeDownCast(this->Mapper)->SetFilmWidth(width);
}

void vtkFoamFilmsRepresentation::SetBorderRadius(double radius) {
  vtkFoamFilmMapper::SafeDownCast(this->Mapper)->SetBorderRadius(radius);
}

int vtkFoamFilmsRepresentation::ProcessViewRequest(vtkInformationRequestKey* request,
                                                   vtkInformation* in, vtkInformation* out) {
  if (request == vtkPVView::REQUEST_UPDATE_LOD()) {
    return 1;
  }
  const int processed = this->Superclass::ProcessViewRequest(request, in, out);
  this->Actor->SetEnableLOD(0);
  return processed;
}
