// SPDX-License-Identifier: GPL-3.0-or-later
#include "StatisticsTables.h"

#include <array>

#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkTable.h>

#include "Columns.h"
#include "statistics/stress.h"

namespace foam::filters {
namespace {

/// Adds a column of one row.
template <class Array, class Value> void add_cell(vtkTable* table, const char* name, Value value) {
  add_column<Array>(table->GetRowData(), name, std::array{value}, [](Value v) { return v; });
}

} // namespace

void write_summary(const Foam& foam, const FoamStatistics& figures, vtkTable* table) {
  add_cell<vtkDoubleArray>(table, "Time", foam.time);
  add_cell<vtkIntArray>(table, "Bubbles", figures.bubbles);
  add_cell<vtkDoubleArray>(table, "MeanSides", figures.mean_sides);
  add_cell<vtkDoubleArray>(table, "Mu2", figures.mu2);
  add_cell<vtkDoubleArray>(table, "MeanArea", figures.mean_area);
  add_cell<vtkDoubleArray>(table, "AreaSecondMoment", figures.area_second_moment);
  add_cell<vtkDoubleArray>(table, "Energy", figures.energy);
  add_cell<vtkDoubleArray>(table, "AboavA", figures.aboav);
  add_cell<vtkDoubleArray>(table, "StressXX", figures.stress.xx);
  add_cell<vtkDoubleArray>(table, "StressYY", figures.stress.yy);
  add_cell<vtkDoubleArray>(table, "StressXY", figures.stress.xy);
  add_cell<vtkDoubleArray>(table, "NormalStressDifference",
                           normal_stress_difference(figures.stress));
  add_cell<vtkDoubleArray>(table, "Strain", foam.strain);
  add_cell<vtkIdTypeArray>(table, "T1Count", foam.t1_count);
  add_cell<vtkIdTypeArray>(table, "T2Count", foam.t2_count);
  add_cell<vtkIdTypeArray>(table, "T3Count", foam.t3_count);
  add_cell<vtkIntArray>(table, "Iterations", foam.report.iterations);
  add_cell<vtkDoubleArray>(table, "MaxAngleError", foam.report.max_angle_error);
  add_cell<vtkDoubleArray>(table, "MaxAreaError", foam.report.max_area_error);
}

void write_shear_modulus(double modulus, vtkTable* table) {
  add_cell<vtkDoubleArray>(table, "ShearModulus", modulus);
}

void write_by_sides(const FoamStatistics& figures, vtkTable* table) {
  using Row = SideStatistics;
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

} // namespace foam::filters
