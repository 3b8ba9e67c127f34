// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamStatistics.h"

#include <algorithm>
#include <array>
#include <exception>
#include <numeric>
#include <vector>

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include "Columns.h"
#include "FilmReading.h"
#include "MeasuredSides.h"
#include "PipelineRequest.h"

vtkStandardNewMacro(vtkFoamStatistics);

namespace {

using foam::filters::add_column;

/// Adds a column of one row.
template <class Array, class Value> void AddCell(vtkTable* table, const char* name, Value value) {
  add_column<Array>(table->GetRowData(), name, std::array{value}, [](Value v) { return v; });
}

void WriteSummary(const foam::Foam& foam, const foam::FoamStatistics& figures, vtkTable* table) {
  AddCell<vtkDoubleArray>(table, "Time", foam.time);
  AddCell<vtkIntArray>(table, "Bubbles", figures.bubbles);
  AddCell<vtkDoubleArray>(table, "MeanSides", figures.mean_sides);
  AddCell<vtkDoubleArray>(table, "Mu2", figures.mu2);
  AddCell<vtkDoubleArray>(table, "MeanArea", figures.mean_area);
  AddCell<vtkDoubleArray>(table, "AreaSecondMoment", figures.area_second_moment);
  AddCell<vtkDoubleArray>(table, "Energy", figures.energy);
  AddCell<vtkDoubleArray>(table, "AboavA", figures.aboav);
  AddCell<vtkIdTypeArray>(table, "T1Count", foam.t1_count);
  AddCell<vtkIdTypeArray>(table, "T2Count", foam.t2_count);
  AddCell<vtkIdTypeArray>(table, "T3Count", foam.t3_count);
  AddCell<vtkIntArray>(table, "Iterations", foam.report.iterations);
  AddCell<vtkDoubleArray>(table, "MaxAngleError", foam.report.max_angle_error);
  AddCell<vtkDoubleArray>(table, "MaxAreaError", foam.report.max_area_error);
}

void WriteBySides(const foam::FoamStatistics& figures, vtkTable* table) {
  using Row = foam::SideStatistics;
  const auto& rows = figures.by_sides;
  vtkFieldData* data = table->GetRowData();
  add_column<vtkIntArray>(data, "Sides", rows, [](const Row& r) { return r.sides; });
  add_column<vtkIntArray>(data, "Count", rows, [](const Row& r) { return r.count; });
  add_column<vtkDoubleArray>(data, "Fraction", rows, [](const Row& r) { return r.fraction; });
  add_column<vtkDoubleArray>(data, "MeanNeighbourSides", rows,
                             [](const Row& r) { return r.mean_neighbour_sides; });
  add_column<vtkDoubleArray>(data, "AboavProduct", rows,
                             [](const Row& r) { return r.sides * r.mean_neighbour_sides; });
  add_column<vtkDoubleArray>(data, "AboavIdeal", rows,
                             [](const Row& r) { return 5 * r.sides + 7.4; });
  add_column<vtkDoubleArray>(data, "MeanArea", rows,
                             [](const Row& r) { return r.mean_relative_area; });
}

/// A row for every number of sides from the fewest to the most that occur here or were measured.
void WriteDistribution(const foam::FoamStatistics& figures, vtkTable* table) {
  using foam::filters::kFewestMeasuredSides, foam::filters::kMeasuredSides;
  const auto& by_sides = figures.by_sides;
  int first = kFewestMeasuredSides;
  int last = first + static_cast<int>(kMeasuredSides.size()) - 1;
  if (!by_sides.empty()) {
    first = std::min<int>(first, by_sides.front().sides);
    last = std::max<int>(last, by_sides.back().sides);
  }
  std::vector<int> rows(static_cast<std::size_t>(last - first + 1));
  std::iota(rows.begin(), rows.end(), first);

  vtkFieldData* data = table->GetRowData();
  add_column<vtkIntArray>(data, "Sides", rows, [](int n) { return n; });
  add_column<vtkDoubleArray>(data, "Fraction", rows, [&](int n) {
    const auto found = std::find_if(by_sides.begin(), by_sides.end(),
                                    [n](const auto& row) { return row.sides == n; });
    return found == by_sides.end() ? 0.0 : found->fraction;
  });
  add_column<vtkDoubleArray>(data, "MeasuredFraction", rows, [](int n) {
    const auto i = static_cast<std::size_t>(n - kFewestMeasuredSides);
    return i < kMeasuredSides.size() ? kMeasuredSides[i] : 0.0;
  });
}

} // namespace

vtkFoamStatistics::vtkFoamStatistics() {
  this->SetNumberOfOutputPorts(4);
}

int vtkFoamStatistics::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPolyData");
  return 1;
}

int vtkFoamStatistics::RequestData(vtkInformation* request, vtkInformationVector** inputs,
                                   vtkInformationVector* outputs) {
  // The pipeline has given the outputs the films' field data, which are no part of the tables.
  for (int port = 0; port < this->GetNumberOfOutputPorts(); ++port) {
    vtkTable::GetData(outputs, port)->Initialize();
  }
  if (!foam::filters::is_first_piece(request, outputs)) {
    return 1;
  }
  try {
    const auto foam = foam::filters::read_foam(vtkPolyData::GetData(inputs[0]));
    const auto figures = foam::statistics(foam, this->IncludeBoundary);
    WriteSummary(foam, figures, vtkTable::GetData(outputs, 0));
    WriteBySides(figures, vtkTable::GetData(outputs, 1));
    foam::filters::add_bubble_columns(vtkTable::GetData(outputs, 2)->GetRowData(), figures.each);
    WriteDistribution(figures, vtkTable::GetData(outputs, 3));
  } catch (const std::exception& error) {
    vtkErrorMacro(<< error.what());
  }
  return 1;
}

void vtkFoamStatistics::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IncludeBoundary: " << this->IncludeBoundary << "\n";
}
