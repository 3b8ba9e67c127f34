// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamFilmsRepresentation.h"

#include <vtkImageReader2.h>
#include <vtkImageReader2Factory.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPVLODActor.h>
#include <vtkPVView.h>
#include <vtkProperty.h>
#include <vtkSmartPointer.h>
#include <vtkTexture.h>
#include <vtksys/SystemTools.hxx>

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

void vtkFoamFilmsRepresentation::SetFilmStyle(int style) {
  vtkFoamFilmMapper::SafeDownCast(this->Mapper)->SetFilmStyle(style);
}

void vtkFoamFilmsRepresentation::SetFilmTextureFile(const char* path) {
  auto* mapper = vtkFoamFilmMapper::SafeDownCast(this->Mapper);
  mapper->SetFilmTexture(nullptr);
  if (!path || !*path) {
    return;
  }
  const auto reader = vtkSmartPointer<vtkImageReader2>::Take(
      vtksys::SystemTools::FileExists(path, true) ? vtkImageReader2Factory::CreateImageReader2(path)
                                                  : nullptr);
  if (!reader) {
    vtkWarningMacro(
        "Films are drawn without a texture: "
        << path
        << (vtksys::SystemTools::FileExists(path, true) ? " is not a picture" : " does not exist"));
    return;
  }
  reader->SetFileName(path);
  vtkNew<vtkTexture> texture;
  texture->SetInputConnection(reader->GetOutputPort());
  texture->InterpolateOn();
  texture->MipmapOn();
  texture->RepeatOn();
  mapper->SetFilmTexture(texture);
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
