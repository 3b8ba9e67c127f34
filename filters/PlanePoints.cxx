// SPDX-License-Identifier: GPL-3.0-or-later
#include "PlanePoints.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include <vtkPointSet.h>

#include "Message.h"

namespace foam::filters {
namespace {

/// Largest difference in z, relative to the extents in x and y.
constexpr double kPlaneTolerance = 1e-9;

} // namespace

std::vector<Vec2> plane_points(vtkPointSet* input) {
  const vtkIdType count = input->GetNumberOfPoints();
  std::vector<Vec2> points(static_cast<std::size_t>(count));
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
  const double tolerance = kPlaneTolerance * std::max(xmax - xmin, ymax - ymin);
  for (std::size_t i = 0; i < heights.size(); ++i) {
    if (!std::isfinite(heights[i]) || std::abs(heights[i] - heights[0]) > tolerance) {
      fail("the points must lie in a plane of constant z: z of point ", i, " is ", heights[i],
           ", of point 0 ", heights[0]);
    }
  }
  return points;
}

} // namespace foam::filters
