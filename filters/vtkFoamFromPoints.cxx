// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkFoamFromPoints.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "vtkDataArray.h"
#include "vtkInformation.h"
#include "vtkInformationVector.h"
#include "vtkObjectFactory.h"
#include "vtkPointData.h"
#include "vtkPointSet.h"
#include "vtkPolyData.h"

#include "Message.h"
#include "PipelineRequest.h"
#include "construct/from_points.h"
#include "engines/engines.h"
#include "sampling/sampled_foam.h"

vtkStandardNewMacro(vtkFoamFromPoints);

namespace {

using foam::filters::fail;

/// Largest difference in z, relative to the extents in x and y.
constexpr double PLANE_TOLERANCE = 1e-9;

/// T1 threshold of the first equilibration, in mean spacings.
constexpr double T1_LENGTH = 0.05;

std::vector<foam::Vec2> ReadPoints(vtkPointSet* input) {
  const vtkIdType count = input->GetNumberOfPoints();
  std::vector<foam::Vec2> points(static_cast<std::size_t>(count));
  std::vector<double> heights(points.size());
  const double limit = std::numeric_limits<double>::max();
  double xmin = limit, xmax = -limit, ymin = limit, ymax = -limit;
  for (vtkIdType i = 0; i < count; ++i) {
    double p[3];
    input->GetPoint(i, p);
    points[static_cast<std::size_t>(i)] = {p[0], p[1]};
    heights[static_cast<std::size_t>(i)] = p[2];
    xmin = std::min(xmin, p[0]);
    xmax = std::max(xmax, p[0]);
    ymin = std::min(ymin, p[1]);
    ymax = std::max(ymax, p[1]);
  }
  const double tolerance = PLANE_TOLERANCE * std::max(xmax - xmin, ymax - ymin);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (!std::isfinite(heights[i]) || std::abs(heights[i] - heights[0]) > tolerance) {
      fail("the points must lie in a plane of constant z: z of point ", i, " is ", heights[i],
           ", of point 0 ", heights[0]);
    }
  }
  return points;
}

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

std::optional<foam::Box> ReadBox(const double bounds[4]) {
  if (!std::all_of(bounds, bounds + 4, [](double b) { return std::isfinite(b); })) {
    fail("PeriodicBounds must be finite, but are ", bounds[0], " ", bounds[1], " ", bounds[2], " ",
         bounds[3]);
  }
  if (bounds[0] >= bounds[1] || bounds[2] >= bounds[3]) {
    return std::nullopt;
  }
  return foam::Box{bounds[0], bounds[1], bounds[2], bounds[3]};
}

/// How far a foam is from equilibrium: angles (rad) and areas (relative).
double Residual(const foam::Foam& foam) {
  return std::max(foam::max_angle_error(foam), foam::max_area_error(foam));
}

/// What is known of a foam that has not been brought to equilibrium.
foam::EquilibriumReport MeasuredReport(const foam::Foam& foam) {
  return {.max_angle_error = foam::max_angle_error(foam),
          .max_area_error = foam::max_area_error(foam),
          .residual = Residual(foam)};
}

} // namespace

int vtkFoamFromPoints::FillInputPortInformation(int, vtkInformation* info) {
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPointSet");
  return 1;
}

int vtkFoamFromPoints::RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputs,
                                           vtkInformationVector* outputs) {
  if (foam::filters::is_first_piece(request, outputs)) {
    foam::filters::request_whole(inputs[0]->GetInformationObject(0));
  }
  return 1;
}

void vtkFoamFromPoints::MakeFoam(vtkInformation*, vtkInformationVector** inputs,
                                 vtkInformationVector* outputs) {
  vtkPointSet* input = vtkPointSet::GetData(inputs[0]);
  foam::BuildOptions options;
  options.boundary = static_cast<foam::Boundary>(this->Boundary);
  options.target_areas = static_cast<foam::TargetAreas>(this->TargetAreas);
  options.surface_tension = this->SurfaceTension;
  options.fin_size = this->FinSize;
  if (options.boundary == foam::Boundary::Periodic) {
    options.periodic_box = ReadBox(this->PeriodicBounds);
  }
  if (options.target_areas == foam::TargetAreas::Array) {
    options.target_area_array = ReadTargetAreas(input, this->TargetAreaArray);
  }
  foam::Foam foam = foam::build_from_points(ReadPoints(input), options);
  foam.report = MeasuredReport(foam);
  this->BringToEquilibrium(foam);
  this->WriteOutputs(foam::sample(foam, this->GetChordError()), outputs);
}

void vtkFoamFromPoints::BringToEquilibrium(foam::Foam& foam) {
  const auto equilibrator = foam::make_equilibrator(this->GetEquilibratorOptions());
  if (!this->Equilibrate) {
    return;
  }
  // The part of the way that the residual has fallen, on a logarithmic scale.
  const double first = Residual(foam);
  const double way = std::log(first / this->GetTolerance());
  double progress = 0;
  const auto aborted = [&] {
    progress = std::max(progress, std::min(1.0, std::log(first / Residual(foam)) / way));
    return this->PollAbort(progress);
  };
  try {
    equilibrator->equilibrate(foam, T1_LENGTH * foam.mean_spacing(), aborted);
    if (!foam.report.converged) {
      vtkWarningMacro("The foam did not reach equilibrium: residual "
                      << foam.report.residual << " after " << foam.report.iterations
                      << " iterations.");
    }
  } catch (const foam::Aborted&) {
    foam.report = MeasuredReport(foam); // what there is of the foam is shown
  }
}

void vtkFoamFromPoints::PrintSelf(ostream& os, vtkIndent indent) {
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Boundary: " << this->Boundary << "\n"
     << indent << "PeriodicBounds: " << this->PeriodicBounds[0] << " " << this->PeriodicBounds[1]
     << " " << this->PeriodicBounds[2] << " " << this->PeriodicBounds[3] << "\n"
     << indent << "TargetAreas: " << this->TargetAreas << "\n"
     << indent << "TargetAreaArray: " << this->TargetAreaArray << "\n"
     << indent << "SurfaceTension: " << this->SurfaceTension << "\n"
     << indent << "FinSize: " << this->FinSize << "\n"
     << indent << "Equilibrate: " << this->Equilibrate << "\n";
}
