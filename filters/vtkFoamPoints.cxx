// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamPoints.h"

#include <cstdint>
#include <exception>

#include "vtkCellArray.h"
#include "vtkDoubleArray.h"
#include "vtkFieldData.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPoints.h"
#include "vtkPolyData.h"

#include "PipelineRequest.h"
#include "construct/jittered_grid.h"

vtkStandardNewMacro(vtkFoamPoints);

vtkFoamPoints::vtkFoamPoints() {
  this->SetNumberOfInputPorts(0);
}

int vtkFoamPoints::RequestData(vtkInformation* request, vtkInformationVector**,
                               vtkInformationVector* outputs) {
  vtkPolyData* output = vtkPolyData::GetData(outputs);
  output->Initialize();
  if (!foam::filters::is_first_piece(request, outputs)) {
    return 1;
  }
  try {
    const auto grid = foam::jittered_grid(this->NumberOfPoints, this->Spacing, this->Jitter,
                                          static_cast<std::uint64_t>(this->Seed));
    vtkNew<vtkPoints> points;
    points->SetDataTypeToDouble();
    vtkNew<vtkCellArray> vertices;
    for (const auto p : grid) {
      const vtkIdType id = points->InsertNextPoint(p.x, p.y, 0);
      vertices->InsertNextCell(1, &id);
    }
    output->SetPoints(points);
    output->SetVerts(vertices);
    const foam::Vec2 corner = foam::grid_corner(this->NumberOfPoints, this->Spacing);
    vtkNew<vtkDoubleArray> bounds;
    bounds->SetName("PeriodicBounds");
    bounds->SetNumberOfComponents(4);
    bounds->InsertNextTuple4(0, corner.x, 0, corner.y);
    output->GetFieldData()->AddArray(bounds);
    vtkNew<vtkDoubleArray> of; // for these points, and no others
    of->SetName("PeriodicBoundsOf");
    of->SetNumberOfComponents(4);
    of->InsertNextTuple(output->GetBounds());
    output->GetFieldData()->AddArray(of);
  } catch (const std::exception& error) {
    vtkErrorMacro(<< error.what());
  }
  return 1;
}

void vtkFoamPoints::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "NumberOfPoints: " << this->NumberOfPoints << "\n"
     << indent << "Spacing: " << this->Spacing << "\n"
     << indent << "Jitter: " << this->Jitter << "\n"
     << indent << "Seed: " << this->Seed << "\n";
}
