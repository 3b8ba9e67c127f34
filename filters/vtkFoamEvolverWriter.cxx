// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamEvolverWriter.h"

#include "vtkObjectFactory.h"
#include "vtkPolyData.h"

#include "FilmReading.h"
#include "Message.h"
#include "WholeFile.h"
#include "evolver/write_foam.h"

vtkStandardNewMacro(vtkFoamEvolverWriter);

vtkFoamEvolverWriter::vtkFoamEvolverWriter() = default;
vtkFoamEvolverWriter::~vtkFoamEvolverWriter() = default;

void vtkFoamEvolverWriter::WriteData() {
  const vtkSmartPointer<vtkPolyData> whole = this->WholeInput();
  if (this->Piece != 0) {
    return;
  }
  this->Try([&] {
    if (this->FileName.empty()) {
      foam::filters::fail("FileName names no file to write");
    }
    vtkDataObject* const input = whole ? whole.Get() : this->GetInput();
    const foam::Foam foam = foam::filters::read_foam(foam::filters::films_in(input));
    foam::filters::write_whole(this->FileName, foam::write_evolver(foam));
  });
}

void vtkFoamEvolverWriter::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
}
