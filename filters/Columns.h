// SPDX-License-Identifier: GPL-3.0-or-later
//
// Arrays of a data set, or columns of a table, with a value for each element of a list.
#pragma once

#include <vector>

#include <vtkFieldData.h>
#include <vtkNew.h>

#include "statistics/statistics.h"

namespace foam::filters {

/// Adds an array with the value of each element.
template <class Array, class Elements, class Value>
void add_column(vtkFieldData* data, const char* name, const Elements& elements, Value value) {
  vtkNew<Array> column;
  column->SetName(name);
  auto* next = column->WritePointer(0, static_cast<vtkIdType>(std::size(elements)));
  for (const auto& element : elements) {
    *next++ = static_cast<typename Array::ValueType>(value(element));
  }
  data->AddArray(column);
}

/// Adds what is known of each bubble: BubbleId, Area, TargetArea (cm²), Pressure (N/cm²), Sides,
/// Perimeter (cm), OnBoundary, Stress (N/cm²), a symmetric tensor in VTK's order: XX, YY, ZZ, XY,
/// YZ, XZ.
void add_bubble_columns(vtkFieldData* data, const std::vector<BubbleStatistics>& bubbles);

} // namespace foam::filters
