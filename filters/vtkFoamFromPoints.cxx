// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamFromPoints.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <string>
#include <vector>

#include "vtkCellData.h"
#include "vtkDataArray.h"
#include "vtkFieldData.h"
#include "vtkIdList.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkNew.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include "Message.h"
#include "PipelineRequest.h"
#include "PlanePoints.h"
#include "construct/containers.h"
#include "construct/from_points.h"
#include "physics/equilibrium_measures.h"
#include "sampling/sampled_foam.h"

vtkStandardNewMacro(vtkFoamFromPoints);

namespace {

using foam::filters::fail;

std::vector<double> ReadTargetAreas(vtkPointSet* input, const std::string& name) {
  if (name.empty()) {
    fail("TargetAreas are to come from an array, but TargetAreaArray names none");
  }
  vtkPointData* data = input->GetPointData();
  vtkDataArray* array = data->GetArray(name.c_str());
  if (!array) {
    fail("TargetAreaArray '", name, "' is ",
         data->GetAbstractArray(name.c_str()) ? "not numeric" : "no point array of the input");
  }
  if (array->GetNumberOfComponents() != 1) {
    fail("TargetAreaArray '", name, "' has ", array->GetNumberOfComponents(), " components, not 1");
  }
  if (array->GetNumberOfTuples() != input->GetNumberOfPoints()) {
    fail("TargetAreaArray '", name, "' has ", array->GetNumberOfTuples(), " values for ",
         input->GetNumberOfPoints(), " points");
  }
  std::vector<double> areas(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (std::size_t i = 0; i < areas.size(); ++i) {
    areas[i] = array->GetComponent(static_cast<vtkIdType>(i), 0);
  }
  return areas;
}

void CheckFinite(const char* name, const double values[4]) {
  if (!std::all_of(values, values + 4, [](double v) { return std::isfinite(v); })) {
    fail(name, " must be finite, but are ", values[0], " ", values[1], " ", values[2], " ",
         values[3]);
  }
}

foam::Vec2 LowerLeft(const std::vector<foam::Vec2>& points) {
  foam::Vec2 corner;
  if (!points.empty()) {
    corner.x = std::ranges::min(points, {}, &foam::Vec2::x).x;
    corner.y = std::ranges::min(points, {}, &foam::Vec2::y).y;
  }
  return corner;
}

bool AnyOf(const double values[4]) {
  return std::any_of(values, values + 4, [](double v) { return v != 0; });
}

/// The rectangle that the cells of vtkFoamPoints fill, if the input is such points still: not
/// moved, nor some of them alone.
std::optional<foam::Lattice> ReadGrid(vtkPointSet* input) {
  const auto read = [&](const char* name, double values[4]) {
    vtkDataArray* array = input->GetFieldData()->GetArray(name);
    const bool found =
        array && array->GetNumberOfComponents() == 4 && array->GetNumberOfTuples() == 1;
    if (found) {
      array->GetTuple(0, values);
    }
    return found;
  };
  double grid[4], of[4], bounds[6];
  input->GetBounds(bounds);
  if (!read("PeriodicBounds", grid) || !read("PeriodicBoundsOf", of) ||
      !std::equal(of, of + 4, bounds)) {
    return std::nullopt;
  }
  return foam::Lattice::rectangle(grid[0], grid[1], grid[2], grid[3]);
}

/// None where it shall follow from the points.
std::optional<foam::Lattice> ReadTorus(vtkPointSet* input, const double bounds[4],
                                       const double periods[4],
                                       const std::vector<foam::Vec2>& points) {
  CheckFinite("PeriodicBounds", bounds);
  CheckFinite("PeriodVectors", periods);
  const bool bounded = AnyOf(bounds);
  if (bounded && !(bounds[0] < bounds[1] && bounds[2] < bounds[3])) {
    fail("PeriodicBounds must be xmin < xmax and ymin < ymax, or four zeros, but are ", bounds[0],
         " ", bounds[1], " ", bounds[2], " ", bounds[3]);
  }
  if (AnyOf(periods)) {
    return foam::Lattice{bounded ? foam::Vec2{bounds[0], bounds[2]} : LowerLeft(points),
                         {periods[0], periods[1]},
                         {periods[2], periods[3]}};
  }
  if (!bounded) {
    return ReadGrid(input);
  }
  return foam::Lattice::rectangle(bounds[0], bounds[1], bounds[2], bounds[3]);
}

/// None where they shall follow from the points.
std::optional<foam::ContainerBounds> ReadContainerBounds(vtkPointSet* input, const double bounds[4],
                                                         foam::ContainerShape shape) {
  CheckFinite("ContainerBounds", bounds);
  if (AnyOf(bounds)) {
    return foam::ContainerBounds{bounds[0], bounds[1], bounds[2], bounds[3]};
  }
  const bool round = shape == foam::ContainerShape::Disc || shape == foam::ContainerShape::Annulus;
  if (const auto grid = ReadGrid(input); grid && !round) {
    const auto& [corner, first, second] = *grid;
    return foam::ContainerBounds{corner.x, corner.x + first.x, corner.y, corner.y + second.y};
  }
  return std::nullopt;
}

/// The closed polylines and polygons of the second input, each without its first point again.
std::vector<std::vector<foam::Vec2>> ReadOutlines(vtkInformationVector* walls) {
  vtkPolyData* input = vtkPolyData::GetData(walls);
  if (!input) {
    fail("the container Outline takes closed polylines as its Walls, ",
         walls->GetNumberOfInformationObjects() > 0
             ? "but these are a " + std::string(vtkDataObject::GetData(walls)->GetClassName())
             : "but there are none");
  }
  std::vector<std::vector<foam::Vec2>> outlines;
  for (vtkIdType cell = 0; cell < input->GetNumberOfCells(); ++cell) {
    const int type = input->GetCellType(cell);
    if (type == VTK_VERTEX || type == VTK_POLY_VERTEX) {
      continue;
    }
    vtkNew<vtkIdList> ids;
    input->GetCellPoints(cell, ids);
    std::vector<foam::Vec2>& outline = outlines.emplace_back();
    for (const vtkIdType id : *ids) {
      double p[3];
      input->GetPoint(id, p);
      outline.push_back({p[0], p[1]});
    }
    const bool closed = outline.size() > 1 && outline.front() == outline.back();
    if (closed) {
      outline.pop_back();
    } else if (type == VTK_LINE || type == VTK_POLY_LINE) {
      fail("outline ", cell, " of the Walls is open: it begins at (", outline.front().x, ", ",
           outline.front().y, ") and ends at (", outline.back().x, ", ", outline.back().y, ")");
    }
  }
  return outlines;
}

} // namespace

using ThisClass = vtkFoamFromPoints;

// clang-format off
#define FOAM_OPTIONS(option, choice) \
  choice(Boundary, this->Options->boundary) \
  option(FoldPoints, bool, this->Options->fold) \
  choice(TargetAreas, this->Options->target_areas) \
  option(FitAreas, bool, this->Options->fit_areas) \
  option(SurfaceTension, double, this->Options->surface_tension) \
  option(FinSize, double, this->Options->fin_size) \
  choice(Container, this->Walls->shape) \
  option(InnerRadius, double, this->Walls->inner_radius) \
  choice(WallContact, this->Walls->contact)
// clang-format on

FOAM_OPTIONS(foamDefineOption, foamDefineChoice)

vtkFoamFromPoints::vtkFoamFromPoints()
    : Options(std::make_unique<foam::BuildOptions>()),
      Walls(std::make_unique<foam::ContainerOptions>()) {
  this->SetNumberOfInputPorts(2);
}
vtkFoamFromPoints::~vtkFoamFromPoints() = default;

int vtkFoamFromPoints::FillInputPortInformation(int port, vtkInformation* info) {
  if (port == 1) {
    info->Set(vtkAlgorithm::INPUT_IS_OPTIONAL(), 1);
  }
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkDataObject"); // what it is, is told once
  return 1;
}

int vtkFoamFromPoints::RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputs,
                                           vtkInformationVector* outputs) {
  if (foam::filters::is_first_piece(request, outputs)) {
    foam::filters::request_whole(inputs[0]->GetInformationObject(0));
    if (inputs[1]->GetNumberOfInformationObjects() > 0) {
      foam::filters::request_whole(inputs[1]->GetInformationObject(0));
    }
  }
  return 1;
}

void vtkFoamFromPoints::MakeFoam(vtkInformation*, vtkInformationVector** inputs,
                                 vtkInformationVector* outputs) {
  vtkPointSet* input = vtkPointSet::GetData(inputs[0]);
  if (!input) {
    fail("the input is a ", vtkDataObject::GetData(inputs[0])->GetClassName(),
         "; what is wanted is one data set with points of its own");
  }
  if (input->GetPointData()->HasArray("JunctionId") &&
      input->GetCellData()->HasArray("LeftBubble")) {
    fail("the input is the films of a foam, not points: FoamCoarsen and FoamStatistics take films");
  }
  const std::vector<foam::Vec2> points = foam::filters::plane_points(input);
  foam::BuildOptions options = *this->Options;
  if (options.boundary == foam::Boundary::Periodic) {
    options.torus = ReadTorus(input, this->PeriodicBounds, this->PeriodVectors, points);
  }
  if (options.boundary == foam::Boundary::Container) {
    foam::ContainerOptions walls = *this->Walls;
    walls.bounds = ReadContainerBounds(input, this->ContainerBounds, walls.shape);
    if (walls.shape == foam::ContainerShape::Outline) {
      walls.outlines = ReadOutlines(inputs[1]);
    }
    options.container = foam::make_container(walls, points);
  }
  if (options.target_areas == foam::TargetAreas::Array) {
    options.target_area_array = ReadTargetAreas(input, this->TargetAreaArray);
  }
  foam::Foam foam = foam::build_from_points(points, options);
  this->WarnIfScaled(foam, options);
  foam.report = foam::measured_report(foam);
  this->BringToEquilibrium(foam, this->Equilibrate);
  this->WriteOutputs(foam::sample(foam, this->GetChordError()), outputs);
}

void vtkFoamFromPoints::WarnIfScaled(const foam::Foam& foam, const foam::BuildOptions& options) {
  const auto& given = options.target_area_array;
  if (given.empty() || options.fit_areas) {
    return;
  }
  const double sum = std::accumulate(given.begin(), given.end(), 0.0);
  const double filled = std::accumulate(foam.target_area.begin(), foam.target_area.end(), 0.0);
  if (const auto told = foam::filters::told_scaling(sum, filled / sum); !told.empty()) {
    vtkWarningMacro(<< told);
  }
}

void vtkFoamFromPoints::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  FOAM_OPTIONS(foamPrintOption, foamPrintOption)
  const auto print = [&](const char* name, const double values[4]) {
    os << indent << name << ": " << values[0] << " " << values[1] << " " << values[2] << " "
       << values[3] << "\n";
  };
  print("PeriodicBounds", this->PeriodicBounds);
  print("PeriodVectors", this->PeriodVectors);
  print("ContainerBounds", this->ContainerBounds);
  os << indent << "TargetAreaArray: " << this->TargetAreaArray << "\n"
     << indent << "Equilibrate: " << this->Equilibrate << "\n";
}
