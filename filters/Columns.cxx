// SPDX-License-Identifier: GPL-3.0-or-later
#include "Columns.h"

#include <array>

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
  vtkNew<vtkDoubleArray> stress;
  stress->SetName("Stress");
  stress->SetNumberOfComponents(6);
  stress->SetNumberOfTuples(static_cast<vtkIdType>(bubbles.size()));
  for (int component = 0; component < 6; ++component) {
    stress->SetComponentName(component, std::array{"XX", "YY", "ZZ", "XY", "YZ", "XZ"}[component]);
  }
  for (std::size_t i = 0; i < bubbles.size(); ++i) {
    const SymmetricTensor& s = bubbles[i].stress;
    stress->SetTuple6(static_cast<vtkIdType>(i), s.xx, s.yy, 0, s.xy, 0, 0);
  }
  data->AddArray(stress);
}

} // namespace foam::filters
