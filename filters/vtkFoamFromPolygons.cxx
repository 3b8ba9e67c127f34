// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamFromPolygons.h"

#include <algorithm>
#include <vector>

#include "vtkCellType.h"
#include "vtkIdList.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointSet.h"

#include "Message.h"
#include "PlanePoints.h"
#include "construct/from_polygons.h"

vtkStandardNewMacro(vtkFoamFromPolygons);

namespace {

std::vector<foam::Polygon> ReadPolygons(vtkPointSet* input) {
  std::vector<foam::Polygon> polygons;
  vtkNew<vtkIdList> ids;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell) {
    const int type = input->GetCellType(cell);
    if (type != VTK_POLYGON && type != VTK_TRIANGLE && type != VTK_QUAD) {
      continue;
    }
    input->GetCellPoints(cell, ids);
    foam::Polygon& polygon = polygons.emplace_back();
    polygon.cell = cell;
    for (const vtkIdType id : *ids) {
      polygon.points.push_back(static_cast<foam::Index>(id));
    }
  }
  if (polygons.empty()) {
    foam::filters::fail("the input has no polygons, but ", input->GetNumberOfCells(),
                        " other cells");
  }
  return polygons;
}

} // namespace

vtkFoamFromPolygons::vtkFoamFromPolygons() = default;
vtkFoamFromPolygons::~vtkFoamFromPolygons() = default;

void vtkFoamFromPolygons::MakeFoam(vtkInformation*, vtkInformationVector** inputs,
                                   vtkInformationVector* outputs) {
  vtkPointSet* input = vtkPointSet::GetData(inputs[0]);
  if (!input) {
    foam::filters::fail("the input is a ", vtkDataObject::GetData(inputs[0])->GetClassName(),
                        "; what is wanted is one data set of polygons");
  }
  const auto outline =
      this->Boundary == Container ? foam::DivisionOutline::Wall : foam::DivisionOutline::Films;
  foam::DivisionFoam made = foam::build_from_polygons(
      foam::filters::plane_points(input), ReadPolygons(input), outline, this->GetSurfaceTension());
  this->ShowFoam(made, outputs);
}

void vtkFoamFromPolygons::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Boundary: " << this->Boundary << "\n";
}
