// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamFilmMapper.h"

#include <vtkObjectFactory.h>

#include "FilmBatchMapper.h"

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

foam::rendering::BatchMapper* vtkFoamFilmMapper::NewBatchMapper() {
  return foam::rendering::FilmBatchMapper::New();
}
