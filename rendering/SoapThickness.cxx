// SPDX-License-Identifier: GPL-3.0-or-later
#include "SoapThickness.h"

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkFloatArray.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkNew.h>
#include <vtkObjectFactory.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkTriangleFilter.h>

namespace foam::rendering {

vtkStandardNewMacro(SoapThickness);

int SoapThickness::RequestData(vtkInformation*, vtkInformationVector** input,
                               vtkInformationVector* output) {
  vtkPolyData* polygons = vtkPolyData::GetData(input[0]);
  vtkPolyData* result = vtkPolyData::GetData(output);
  vtkNew<vtkTriangleFilter> cut;
  cut->SetInputData(polygons);
  cut->PassVertsOff();
  cut->PassLinesOff();
  cut->Update();
  vtkPolyData* triangles = cut->GetOutput();

  vtkDataArray* thickness = nullptr;
  if (!this->ThicknessArray.empty()) {
    vtkCellData* data = triangles->GetCellData();
    thickness = data->GetArray(this->ThicknessArray.c_str());
    if (!thickness) {
      vtkWarningMacro("Soap films are drawn "
                      << this->Thickness << " nm thick: cell array " << this->ThicknessArray
                      << " is "
                      << (data->GetAbstractArray(this->ThicknessArray.c_str()) ? "not numeric"
                                                                               : "missing"));
    }
  }

  double bounds[6];
  polygons->GetBounds(bounds);
  const double middle = (bounds[2] + bounds[3]) / 2;
  vtkCellArray* cells = triangles->GetPolys();
  const vtkIdType count = cells->GetNumberOfCells();
  vtkNew<vtkPoints> points;
  points->SetDataType(triangles->GetPoints() ? triangles->GetPoints()->GetDataType() : VTK_FLOAT);
  points->SetNumberOfPoints(3 * count);
  vtkNew<vtkFloatArray> values;
  values->SetName(kArray);
  values->SetNumberOfValues(3 * count);
  vtkNew<vtkCellArray> own;
  own->AllocateExact(count, 3 * count);
  vtkPointData* source = triangles->GetPointData();
  result->GetPointData()->CopyAllocate(source, 3 * count);
  for (vtkIdType i = 0; i < count; ++i) {
    vtkIdType size = 0;
    const vtkIdType* corners = nullptr;
    cells->GetCellAtId(i, size, corners);
    const double base = thickness ? thickness->GetComponent(i, 0) : this->Thickness;
    vtkIdType ids[3];
    for (int k = 0; k < 3; ++k) {
      ids[k] = 3 * i + k;
      double p[3];
      triangles->GetPoint(corners[k], p);
      points->SetPoint(ids[k], p);
      values->SetValue(ids[k], static_cast<float>(base + this->Gradient * (middle - p[1])));
      result->GetPointData()->CopyData(source, corners[k], ids[k]);
    }
    own->InsertNextCell(3, ids);
  }
  result->SetPoints(points);
  result->SetPolys(own);
  result->GetCellData()->ShallowCopy(triangles->GetCellData());
  result->GetFieldData()->ShallowCopy(polygons->GetFieldData());
  result->GetPointData()->AddArray(values);
  return 1;
}

} // namespace foam::rendering
