// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamBubblesRepresentation.h"

#include <vtkCommand.h>
#include <vtkObjectFactory.h>
#include <vtkPVGeometryFilter.h>
#if __has_include(<vtkRecoverGeometryWireframe.h>)
#include <vtkRecoverGeometryWireframe.h>
#endif

namespace {

/// ParaView's, which from 5.13 on does not say which polygon a triangle comes from: it warns then,
/// and takes all edges of triangles for the polygons'.
class BubbleGeometry : public vtkPVGeometryFilter {
public:
  static BubbleGeometry* New();
  vtkTypeMacro(BubbleGeometry, vtkPVGeometryFilter);

#if __has_include(<vtkRecoverGeometryWireframe.h>)
protected:
  BubbleGeometry() {
    this->RecoverWireframeFilter->SetCellIdsAttribute("vtkOriginalCellIds");
  }
#endif
};

vtkStandardNewMacro(BubbleGeometry);

} // namespace

vtkStandardNewMacro(vtkFoamBubblesRepresentation);

vtkFoamBubblesRepresentation::vtkFoamBubblesRepresentation() {
  this->GeometryFilter->Delete();
  this->GeometryFilter = BubbleGeometry::New();
  this->GeometryFilter->AddObserver(
      vtkCommand::ProgressEvent, this,
      &vtkFoamBubblesRepresentation::HandleGeometryRepresentationProgress);
  this->SetupDefaults();
  this->Superclass::SetTriangulate(1);
}

void vtkFoamBubblesRepresentation::SetRepresentation(int type) {
  if (type != this->Representation) {
    this->Superclass::SetRepresentation(type);
    // Cut only to be filled: VTK gets the colours of a wireframe of triangles wrong.
    this->Superclass::SetTriangulate(type == SURFACE || type == SURFACE_WITH_EDGES);
  }
}
