// SPDX-License-Identifier: GPL-3.0-or-later
#include "Columns.h"

#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>

namespace foam::filters {

void add_bubble_columns(vtkFieldData* data, const std::vector<BubbleStatistics>& bubbles) {
  using Bubble = BubbleStatistics;
  add_column<vtkIdTypeArray>(data, "BubbleId", bubbles, [](const Bubble& b) { return b.id; });
  add_column<vtkDoubleArray>(data, "Area", bubbles, [](const Bubble& b) { return b.area; });
  add_column<vtkDoubleArray>(data, "TargetArea", bubbles,
                             [](const Bubble& b) { return b.target_area; });
  add_column<vtkDoubleArray>(data, "Pressure", bubbles, [](const Bubble& b) { return b.pressure; });
  add_column<vtkIntArray>(data, "Sides", bubbles, [](const Bubble& b) { return b.sides; });
  add_column<vtkDoubleArray>(data, "Perimeter", bubbles,
                             [](const Bubble& b) { return b.perimeter; });
  add_column<vtkIntArray>(data, "OnBoundary", bubbles,
                          [](const Bubble& b) { return b.on_boundary; });
}

} // namespace foam::filters
