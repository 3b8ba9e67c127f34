// SPDX-License-Identifier: GPL-3.0-or-later
#include "EnsembleSample.h"

#include <algorithm>
#include <cmath>

#include <vtkDataArray.h>
#include <vtkDataSetAttributes.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkTable.h>

#include "Columns.h"
#include "FilmReading.h"
#include "Message.h"
#include "StatisticsTables.h"
#include "physics/equilibrium_measures.h"
#include "statistics/ensemble.h"
#include "statistics/statistics.h"

namespace foam::filters {
namespace {

/// The numeric columns of a table.
std::vector<vtkDataArray*> numbers(vtkTable* table) {
  std::vector<vtkDataArray*> columns;
  for (int i = 0; i < table->GetRowData()->GetNumberOfArrays(); ++i) {
    vtkDataArray* column = table->GetRowData()->GetArray(i);
    if (column && column->GetName() && column->GetNumberOfComponents() == 1) {
      columns.push_back(column);
    }
  }
  return columns;
}

/// Of bubbles with n sides that a foam does not have there are none, while what they would be like
/// is unknown.
bool is_zero_without_bubbles(const std::string& name) {
  return name == "Count" || name == "Fraction";
}

} // namespace

void EnsembleSample::add_member(vtkDataObject* member, bool include_boundary) {
  if (auto* table = vtkTable::SafeDownCast(member)) {
    add_table(table);
  } else if (auto* films = vtkPolyData::SafeDownCast(member)) {
    if (films->GetNumberOfCells() == 0) {
      return;
    }
    Foam foam = read_foam(films);
    foam.report = confirmed(foam.report, foam, coordinate_rounding(films));
    const auto figures = statistics(foam, include_boundary);
    vtkNew<vtkTable> summary;
    vtkNew<vtkTable> by_sides;
    write_summary(foam, figures, summary);
    write_by_sides(figures, by_sides);
    add_table(summary);
    add_table(by_sides);
  } else if (member) {
    fail("a member must be films or a table, not a ", member->GetClassName());
  }
}

void EnsembleSample::add_table(vtkTable* table) {
  const auto columns = numbers(table);
  const vtkIdType rows = columns.empty() ? 0 : table->GetNumberOfRows();
  vtkDataArray* sides = vtkDataArray::SafeDownCast(table->GetColumnByName("Sides"));
  if (rows > 1 && !sides) {
    fail("a member's table has ", rows, " rows and no column Sides; without it, give one row");
  }
  members_by_sides_ += rows > 0 && sides;
  for (vtkDataArray* column : columns) {
    for (vtkIdType row = 0; column != sides && row < rows; ++row) {
      add(column->GetName(), sides ? static_cast<int>(sides->GetComponent(row, 0)) : 0,
          column->GetComponent(row, 0));
    }
  }
}

void EnsembleSample::add(const std::string& name, int sides, double value) {
  if (!std::isfinite(value)) {
    return;
  }
  const auto found = std::find(names_.begin(), names_.end(), name);
  const auto place = static_cast<std::size_t>(found - names_.begin());
  if (found == names_.end()) {
    names_.push_back(name);
  }
  values_[{sides != 0, place, sides}].push_back(value);
}

vtkSmartPointer<vtkTable> EnsembleSample::packed() const {
  vtkNew<vtkStringArray> names;
  vtkNew<vtkIntArray> sides;
  vtkNew<vtkDoubleArray> values;
  names->SetName("Quantity");
  sides->SetName("Sides");
  values->SetName("Value");
  for (const auto& [quantity, sample] : values_) {
    for (const double value : sample) {
      names->InsertNextValue(names_[std::get<1>(quantity)]);
      sides->InsertNextValue(std::get<2>(quantity));
      values->InsertNextValue(value);
    }
  }
  auto table = vtkSmartPointer<vtkTable>::New();
  for (vtkAbstractArray* column :
       {static_cast<vtkAbstractArray*>(names), static_cast<vtkAbstractArray*>(sides),
        static_cast<vtkAbstractArray*>(values)}) {
    table->AddColumn(column);
  }
  vtkNew<vtkIntArray> members;
  members->SetName("MembersBySides");
  members->InsertNextValue(members_by_sides_);
  table->GetFieldData()->AddArray(members);
  return table;
}

void EnsembleSample::add_packed(vtkTable* packed) {
  auto* names = vtkStringArray::SafeDownCast(packed->GetColumnByName("Quantity"));
  auto* sides = vtkDataArray::SafeDownCast(packed->GetColumnByName("Sides"));
  auto* values = vtkDataArray::SafeDownCast(packed->GetColumnByName("Value"));
  for (vtkIdType row = 0; row < packed->GetNumberOfRows(); ++row) {
    add(names->GetValue(row), static_cast<int>(sides->GetComponent(row, 0)),
        values->GetComponent(row, 0));
  }
  members_by_sides_ +=
      static_cast<int>(packed->GetFieldData()->GetArray("MembersBySides")->GetComponent(0, 0));
}

void EnsembleSample::write_estimates(vtkTable* table) const {
  struct Row {
    int sides;
    std::size_t members;
    MeanEstimate estimate;
  };
  vtkNew<vtkStringArray> names;
  names->SetName("Quantity");
  std::vector<Row> rows;
  for (const auto& [quantity, sample] : values_) {
    const auto& [of_sides, place, sides] = quantity;
    std::vector<double> values = sample;
    if (of_sides && is_zero_without_bubbles(names_[place])) {
      values.resize(static_cast<std::size_t>(members_by_sides_), 0.0);
    }
    std::sort(values.begin(), values.end()); // so that the last digits know nothing of processes
    names->InsertNextValue(names_[place]);
    rows.push_back({sides, values.size(), estimate_mean(values)});
  }
  vtkFieldData* data = table->GetRowData();
  data->AddArray(names);
  add_column<vtkIntArray>(data, "Sides", rows, [](const Row& r) { return r.sides; });
  add_column<vtkIntArray>(data, "Members", rows, [](const Row& r) { return r.members; });
  add_column<vtkDoubleArray>(data, "Mean", rows, [](const Row& r) { return r.estimate.mean; });
  add_column<vtkDoubleArray>(data, "StandardError", rows,
                             [](const Row& r) { return r.estimate.standard_error; });
  add_column<vtkDoubleArray>(data, "Lower95", rows,
                             [](const Row& r) { return r.estimate.mean - r.estimate.half_width; });
  add_column<vtkDoubleArray>(data, "Upper95", rows,
                             [](const Row& r) { return r.estimate.mean + r.estimate.half_width; });
}

} // namespace foam::filters
