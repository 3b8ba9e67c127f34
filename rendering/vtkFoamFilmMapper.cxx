// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamFilmMapper.h"

#include <vtkObjectFactory.h>

#include "FilmMapperHelper.h"

vtkStandardNewMacro(vtkFoamFilmMapper);

vtkFoamFilmMapper::vtkFoamFilmMapper() = default;
vtkFoamFilmMapper::~vtkFoamFilmMapper() = default;

void vtkFoamFilmMapper::SetFilmTexture(vtkTexture* texture) {
  if (this->FilmTexture != texture) {
    this->FilmTexture = texture;
    this->Modified();
  }
}

void vtkFoamFilmMapper::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "FilmWidth: " << this->FilmWidth << "\n";
  os << indent << "BorderRadius: " << this->BorderRadius << "\n";
  os << indent << "FilmStyle: " << this->FilmStyle << "\n";
  os << indent << "FilmTexture: " << this->FilmTexture.Get() << "\n";
}

vtkCompositeMapperHelper2* vtkFoamFilmMapper::CreateHelper() {
  return foam::rendering::FilmMapperHelper::New();
}

void vtkFoamFilmMapper::CopyMapperValuesToHelper(vtkCompositeMapperHelper2* helper) {
  this->Superclass::CopyMapperValuesToHelper(helper);
  auto* films = foam::rendering::FilmMapperHelper::SafeDownCast(helper);
  films->SetFilmWidth(this->FilmWidth);
  films->SetBorderRadius(this->BorderRadius);
  const bool plain = this->FilmStyle == Texture && !this->FilmTexture;
  films->SetFilmStyle(plain ? Plain : this->FilmStyle);
  films->SetFilmTexture(this->FilmTexture);
}
