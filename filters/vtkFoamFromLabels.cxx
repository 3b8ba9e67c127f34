// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamFromLabels.h"

#include <array>
#include <cmath>
#include <string>
#include <utility>

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdTypeArray.h"
#include "vtkImageData.h"
#include "vtkInformationVector.h"
#include "vtkMatrix3x3.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPolyData.h"

#include "Message.h"
#include "construct/from_labels.h"

vtkStandardNewMacro(vtkFoamFromLabels);

namespace {

using foam::filters::fail;

/// Integers up to here survive as double.
constexpr double LARGEST_INTEGER = 9007199254740992.0;

/// The array of labels. \param ofCells set to whether they are the cells'
vtkDataArray* FindLabels(vtkImageData* input, const std::string& name, bool& ofCells) {
  for (const bool cells : {false, true}) {
    vtkDataSetAttributes* data =
        cells ? static_cast<vtkDataSetAttributes*>(input->GetCellData()) : input->GetPointData();
    vtkDataArray* array = name.empty() ? data->GetScalars() : data->GetArray(name.c_str());
    if (array) {
      ofCells = cells;
      if (array->GetNumberOfComponents() != 1) {
        fail("the labels, array ", array->GetName() ? array->GetName() : "without a name",
             ", have ", array->GetNumberOfComponents(),
             " components, not 1: is this a coloured picture?");
      }
      return array;
    }
  }
  if (name.empty()) {
    fail("the image has no active scalars to take for labels");
  }
  fail("LabelArray '", name, "' is no numeric array of the image");
}

foam::LabelImage ReadImage(vtkImageData* input, const std::string& name) {
  bool ofCells = false;
  vtkDataArray* labels = FindLabels(input, name, ofCells);
  int dimensions[3];
  input->GetDimensions(dimensions);
  if (dimensions[2] != 1) {
    fail("the image must be a single picture in the plane of x and y, but has ", dimensions[0],
         " x ", dimensions[1], " x ", dimensions[2], " points");
  }
  if (!input->GetDirectionMatrix()->IsIdentity()) {
    fail("the image must not be turned: its direction matrix is not 1");
  }
  const double* spacing = input->GetSpacing();
  const double* bounds = input->GetBounds();
  const double out = ofCells ? 0 : 0.5; // how far the picture goes beyond the points, in pixels
  foam::LabelImage image;
  image.width = dimensions[0] - (ofCells ? 1 : 0);
  image.height = dimensions[1] - (ofCells ? 1 : 0);
  image.pixel = {spacing[0], spacing[1]};
  image.corner = {bounds[0] - out * spacing[0], bounds[2] - out * spacing[1]};
  const vtkIdType count = labels->GetNumberOfTuples();
  image.labels.resize(static_cast<std::size_t>(count));
  for (vtkIdType i = 0; i < count; ++i) {
    const double value = labels->GetComponent(i, 0);
    if (value != std::trunc(value) || !(std::abs(value) < LARGEST_INTEGER)) {
      fail("labels must be whole numbers, but one is ", value);
    }
    image.labels[static_cast<std::size_t>(i)] = static_cast<std::int64_t>(value);
  }
  return image;
}

} // namespace

vtkFoamFromLabels::vtkFoamFromLabels() = default;
vtkFoamFromLabels::~vtkFoamFromLabels() = default;

void vtkFoamFromLabels::MakeFoam(vtkInformation*, vtkInformationVector** inputs,
                                 vtkInformationVector* outputs) {
  vtkImageData* input = vtkImageData::GetData(inputs[0]);
  if (!input) {
    fail("the input is a ", vtkDataObject::GetData(inputs[0])->GetClassName(),
         "; what is wanted is an image of labels");
  }
  foam::LabelOptions options;
  options.border = static_cast<foam::PictureBorder>(this->Boundary);
  options.surface_tension = this->GetSurfaceTension();
  options.background.reset();
  if (this->Background >= 0) {
    options.background = this->Background;
  }
  foam::LabelFoam made = foam::build_from_labels(ReadImage(input, this->LabelArray), options);
  this->ShowFoam(made, outputs);

  const std::array<std::pair<const char*, foam::Index>, 4> counts = {
      {{"Holes", made.holes},
       {"SplitLabels", made.split_labels},
       {"Pockets", made.pockets},
       {"LeftOut", made.left_out}}};
  std::string told;
  for (const auto& [name, count] : counts) {
    vtkNew<vtkIdTypeArray> array;
    array->SetName(name);
    array->InsertNextValue(count);
    vtkPolyData::GetData(outputs, 0)->GetFieldData()->AddArray(array);
    if (count > 0) {
      told += foam::filters::message(told.empty() ? "" : ", ", name, " ", count);
    }
  }
  if (!told.empty()) {
    vtkWarningMacro(<< "Not all of the picture is bubbles as it stands: " << told << ".");
  }
}

void vtkFoamFromLabels::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Boundary: " << this->Boundary << "\n"
     << indent << "LabelArray: " << this->LabelArray << "\n"
     << indent << "Background: " << this->Background << "\n";
}
