// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamStatistics.h"

#include <array>
#include <exception>

#include "vtkDoubleArray.h"
#include "vtkIdTypeArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkIntArray.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPolyData.h"
#include "vtkTable.h"

#include "FilmReading.h"
#include "PipelineRequest.h"
#include "statistics/statistics.h"

vtkStandardNewMacro(vtkFoamStatistics);

namespace {

/// Adds a column with the value of each element.
template <class Array, class Elements, class Value>
void AddColumn(vtkTable* table, const char* name, const Elements& elements, Value value) {
  vtkNew<Array> column;
  column->SetName(name);
  for (const auto& element : elements) {
    column->InsertNextValue(static_cast<typename Array::ValueType>(value(element)));
  }
  table->AddColumn(column);
}

/// Adds a column of one row.
template <class Array, class Value> void AddCell(vtkTable* table, const char* name, Value value) {
  AddColumn<Array>(table, name, std::array{value}, [](Value v) { return v; });
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
  AddColumn<vtkIntArray>(table, "Sides", rows, [](const Row& r) { return r.sides; });
  AddColumn<vtkIntArray>(table, "Count", rows, [](const Row& r) { return r.count; });
  AddColumn<vtkDoubleArray>(table, "Fraction", rows, [](const Row& r) { return r.fraction; });
  AddColumn<vtkDoubleArray>(table, "MeanNeighbourSides", rows,
                            [](const Row& r) { return r.mean_neighbour_sides; });
  AddColumn<vtkDoubleArray>(table, "AboavProduct", rows,
                            [](const Row& r) { return r.sides * r.mean_neighbour_sides; });
  AddColumn<vtkDoubleArray>(table, "AboavIdeal", rows,
                            [](const Row& r) { return 5 * r.sides + 7.4; });
  AddColumn<vtkDoubleArray>(table, "MeanArea", rows,
                            [](const Row& r) { return r.mean_relative_area; });
}

void WriteBubbles(const foam::FoamStatistics& figures, vtkTable* table) {
  using Row = foam::BubbleStatistics;
  const auto& rows = figures.each;
  AddColumn<vtkIdTypeArray>(table, "BubbleId", rows, [](const Row& r) { return r.id; });
  AddColumn<vtkDoubleArray>(table, "Area", rows, [](const Row& r) { return r.area; });
  AddColumn<vtkDoubleArray>(table, "TargetArea", rows, [](const Row& r) { return r.target_area; });
  AddColumn<vtkDoubleArray>(table, "Pressure", rows, [](const Row& r) { return r.pressure; });
  AddColumn<vtkIntArray>(table, "Sides", rows, [](const Row& r) { return r.sides; });
  AddColumn<vtkDoubleArray>(table, "Perimeter", rows, [](const Row& r) { return r.perimeter; });
  AddColumn<vtkIntArray>(table, "OnBoundary", rows, [](const Row& r) { return r.on_boundary; });
}

} // namespace

vtkFoamStatistics::vtkFoamStatistics() {
  this->SetNumberOfOutputPorts(3);
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
    WriteBubbles(figures, vtkTable::GetData(outputs, 2));
  } catch (const std::exception& error) {
    vtkErrorMacro(<< error.what());
  }
  return 1;
}

void vtkFoamStatistics::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IncludeBoundary: " << this->IncludeBoundary << "\n";
}
