// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamSoapFilmsRepresentation.h"

#include <string>

#include <vtkAlgorithmOutput.h>
#include <vtkLookupTable.h>
#include <vtkMapper.h>
#include <vtkObjectFactory.h>
#include <vtkProperty.h>

#include "SoapThickness.h"
#include "optics/thin_film.h"

vtkStandardNewMacro(vtkFoamSoapFilmsRepresentation);

vtkFoamSoapFilmsRepresentation::vtkFoamSoapFilmsRepresentation()
    : SoapThickness(foam::rendering::SoapThickness::New()) {
  this->SoapThickness->SetInputConnection(this->GeometryFilter->GetOutputPort());
  this->MultiBlockMaker->SetInputConnection(this->SoapThickness->GetOutputPort());
  this->Property->LightingOff();
}

vtkFoamSoapFilmsRepresentation::~vtkFoamSoapFilmsRepresentation() {
  this->SoapThickness->Delete();
}

void vtkFoamSoapFilmsRepresentation::SetThicknessArray(const char* name) {
  const std::string array = name ? name : "";
  this->SoapThickness->SetThicknessArray(array == "None" ? "" : array); // as the panel calls it
  this->MarkModified();
}

void vtkFoamSoapFilmsRepresentation::SetThickness(double thickness) {
  this->SoapThickness->SetThickness(thickness);
  this->MarkModified();
}

void vtkFoamSoapFilmsRepresentation::SetThicknessGradient(double gradient) {
  this->SoapThickness->SetGradient(gradient);
  this->MarkModified();
}

void vtkFoamSoapFilmsRepresentation::SetRefractiveIndex(double index) {
  if (!(index > 1)) {
    vtkWarningMacro("RefractiveIndex must be greater than 1, not " << index);
    return;
  }
  // Fringes of a film thicker than this are too narrow to have colours.
  constexpr double kThickest = 3000; // nm
  constexpr int kCount = 3001;
  const auto colours = foam::film_colours(kThickest, kCount, index);
  this->Colours->SetNumberOfTableValues(kCount);
  for (int i = 0; i < kCount; ++i) {
    const foam::Colour& c = colours[static_cast<std::size_t>(i)];
    this->Colours->SetTableValue(i, c.red, c.green, c.blue);
  }
  this->Colours->SetTableRange(0, kThickest);
}

void vtkFoamSoapFilmsRepresentation::UpdateColoringParameters() {
  for (vtkMapper* mapper : {this->Mapper, this->LODMapper}) {
    mapper->SetScalarVisibility(1);
    mapper->SetScalarMode(VTK_SCALAR_MODE_USE_POINT_FIELD_DATA);
    mapper->SelectColorArray(foam::rendering::SoapThickness::kArray);
    mapper->SetColorMode(VTK_COLOR_MODE_MAP_SCALARS);
    mapper->SetInterpolateScalarsBeforeMapping(1);
    mapper->SetUseLookupTableScalarRange(1);
    mapper->SetLookupTable(this->Colours);
  }
  this->Property->SetRepresentation(VTK_SURFACE);
  this->Property->SetEdgeVisibility(0);
  this->Property->SetAmbient(1);
  this->Property->SetDiffuse(0);
}
