// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamStatistics.h"

#include <algorithm>
#include <exception>
#include <limits>
#include <numeric>
#include <vector>

#include "vtkDataSetAttributes.h"
#include "vtkDoubleArray.h"
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
#include "StatisticsTables.h"
#include "base/error.h"
#include "deformation/moduli.h"
#include "physics/equilibrium_measures.h"

vtkStandardNewMacro(vtkFoamStatistics);

namespace {

using foam::filters::add_column;

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
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject"); // what it is, is told once
  return 1;
}

int vtkFoamStatistics::RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputs,
                                           vtkInformationVector* outputs) {
  if (foam::filters::is_first_piece(request, outputs)) {
    foam::filters::request_whole(inputs[0]->GetInformationObject(0));
  }
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
    vtkPolyData* const films = foam::filters::films_in(vtkDataObject::GetData(inputs[0]));
    auto foam = foam::filters::read_foam(films);
    const foam::EquilibriumReport given = foam.report;
    foam.report = foam::confirmed(given, foam, foam::filters::coordinate_rounding(films));
    if (const auto doubt = foam::filters::doubt(given, foam.report); !doubt.empty()) {
      vtkWarningMacro(<< doubt);
    }
    const auto figures = foam::statistics(foam, this->IncludeBoundary);
    foam::filters::write_summary(foam, figures, vtkTable::GetData(outputs, 0));
    if (this->ShearModulus) {
      foam::filters::write_shear_modulus(this->MeasureShearModulus(foam),
                                         vtkTable::GetData(outputs, 0));
    }
    foam::filters::write_by_sides(figures, vtkTable::GetData(outputs, 1));
    foam::filters::add_bubble_columns(vtkTable::GetData(outputs, 2)->GetRowData(), figures.each);
    WriteDistribution(figures, vtkTable::GetData(outputs, 3));
  } catch (const std::exception& error) {
    vtkErrorMacro(<< error.what());
  }
  return 1;
}

/// Not a number if it has none.
double vtkFoamStatistics::MeasureShearModulus(const foam::Foam& foam) {
  try {
    return foam::shear_modulus(foam, foam::DeformationKind::SimpleShear);
  } catch (const foam::FoamError& error) {
    vtkWarningMacro("There is no ShearModulus: " << error.what());
    return std::numeric_limits<double>::quiet_NaN();
  }
}

void vtkFoamStatistics::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "IncludeBoundary: " << this->IncludeBoundary << "\n"
     << indent << "ShearModulus: " << this->ShearModulus << "\n";
}
