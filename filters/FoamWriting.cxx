// SPDX-License-Identifier: GPL-3.0-or-later
#include "FoamWriting.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <vector>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkIdTypeArray.h>
#include <vtkIntArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>

#include "Columns.h"
#include "coarsening/end.h"

namespace foam::filters {
namespace {

/// An array of these values.
template <class Array, class Value> vtkNew<Array> array_of(const std::vector<Value>& values) {
  vtkNew<Array> array;
  std::copy(values.begin(), values.end(),
            array->WritePointer(0, static_cast<vtkIdType>(values.size())));
  return array;
}

template <class Array, class Value>
void add_array(vtkFieldData* data, const char* name, const std::vector<Value>& values) {
  const auto array = array_of<Array>(values);
  array->SetName(name);
  data->AddArray(array);
}

template <class Array, class Value>
void add_value(vtkFieldData* data, const char* name, Value value) {
  add_array<Array>(data, name, std::vector{static_cast<typename Array::ValueType>(value)});
}

vtkNew<vtkPoints> points_of(const std::vector<Point3>& values) {
  vtkNew<vtkDoubleArray> coordinates;
  coordinates->SetNumberOfComponents(3);
  coordinates->SetNumberOfTuples(static_cast<vtkIdType>(values.size()));
  std::copy(values.begin(), values.end(), reinterpret_cast<Point3*>(coordinates->GetPointer(0)));
  vtkNew<vtkPoints> points;
  points->SetData(coordinates);
  return points;
}

vtkNew<vtkCellArray> cells_of(const std::vector<std::int64_t>& offsets,
                              const std::vector<std::int64_t>& connectivity) {
  vtkNew<vtkCellArray> cells;
  cells->SetData(array_of<vtkIdTypeArray>(offsets), array_of<vtkIdTypeArray>(connectivity));
  return cells;
}

void add_text(vtkFieldData* data, const char* name, const std::string& text) {
  vtkNew<vtkStringArray> array;
  array->SetName(name);
  array->InsertNextValue(text);
  data->AddArray(array);
}

void add_numbers(vtkFieldData* data, const char* name, const std::array<double, 4>& values) {
  vtkNew<vtkDoubleArray> array;
  array->SetName(name);
  array->SetNumberOfComponents(4);
  array->InsertNextTuple(values.data());
  data->AddArray(array);
}

/// The cell of a torus: the bounds of a rectangle. Of one that they do not say to the last digit,
/// or of no rectangle, also the periods.
void write_lattice(const Surroundings& surroundings, vtkFieldData* data) {
  const auto& [origin, first, second] = surroundings.lattice;
  const double xmax = origin.x + first.x;
  const double ymax = origin.y + second.y;
  add_numbers(data, "PeriodicBounds", {origin.x, xmax, origin.y, ymax});
  if (surroundings.has_images() &&
      surroundings.lattice != Lattice::rectangle(origin.x, xmax, origin.y, ymax)) {
    add_numbers(data, "PeriodVectors", {first.x, first.y, second.x, second.y});
  }
}

void write_outsides(const std::vector<Exterior>& exteriors, vtkFieldData* data) {
  if (std::ranges::any_of(exteriors, [](const Exterior& e) { return e.pressure != 0; })) {
    add_column<vtkDoubleArray>(data, "OutsidePressure", exteriors,
                               [](const Exterior& e) { return e.pressure; });
  }
}

/// Three junctions, and where they lie: walls are there as long as these are, and have been moved
/// with the films if these have.
void write_wall_frame(const FilmPolylines& films, vtkFieldData* data) {
  std::vector<Vec2> places; // of the junctions, which come first
  for (std::size_t i = 0; i < films.points.size(); ++i) {
    if (films.junction_id[i] == static_cast<std::int64_t>(i)) {
      places.push_back({films.points[i][0], films.points[i][1]});
    }
  }
  const auto farthest = [&](const auto& distance) {
    return static_cast<std::size_t>(std::ranges::max_element(places, {}, distance) -
                                    places.begin());
  };
  const std::size_t first = farthest([](Vec2 p) { return -p.x; });
  const Vec2 origin = places[first];
  const std::size_t second = farthest([&](Vec2 p) { return norm(p - origin); });
  const Vec2 along = places[second] - origin;
  const std::size_t third = farthest([&](Vec2 p) { return std::abs(cross(along, p - origin)); });
  vtkNew<vtkDoubleArray> frame;
  frame->SetName("WallFrame");
  frame->SetNumberOfComponents(3);
  for (const std::size_t junction : {first, second, third}) {
    const double tuple[] = {static_cast<double>(junction), places[junction].x, places[junction].y};
    frame->InsertNextTuple(tuple);
  }
  data->AddArray(frame);
}

/// The pieces of walls: where each starts, the way to its end, its half-angle, and whose outside's
/// it is. Of each wall, how films end there, and what they and the gas do to it.
void write_walls(const SampledFoam& foam, vtkFieldData* data) {
  if (foam.wall_pieces.empty()) {
    return;
  }
  vtkNew<vtkDoubleArray> pieces;
  pieces->SetName("WallPieces");
  pieces->SetNumberOfComponents(6);
  std::size_t piece = 0;
  for (std::size_t wall = 0; wall < foam.exteriors.size(); ++wall) {
    for (Index i = 0; i < foam.exteriors[wall].pieces; ++i, ++piece) {
      const WallPiece& p = foam.wall_pieces[piece];
      const double tuple[] = {
          static_cast<double>(wall), p.start.x, p.start.y, p.chord.x, p.chord.y, p.half_angle};
      pieces->InsertNextTuple(tuple);
    }
  }
  data->AddArray(pieces);
  write_wall_frame(foam.films, data);
  vtkNew<vtkDoubleArray> forces;
  forces->SetName("WallForce");
  forces->SetNumberOfComponents(4);
  for (const WallForce& force : foam.wall_forces) {
    const double tuple[] = {force.network.x, force.network.y, force.pressure.x, force.pressure.y};
    forces->InsertNextTuple(tuple);
  }
  data->AddArray(forces);
  add_column<vtkIntArray>(data, "WallContact", foam.exteriors,
                          [](const Exterior& e) { return static_cast<int>(e.contact); });
}

/// Of the last frame of a run that could not go on.
void write_end(const FoamRecord& record, vtkFieldData* data) {
  if (record.ended) {
    add_value<vtkIntArray>(data, "Ended", 1);
    add_text(data, "EndReason", reason(*record.ended));
  }
}

void write_state(const SampledFoam& foam, vtkFieldData* data) {
  const std::vector<BubbleStatistics>& bubbles = foam.bubbles.each;
  using Bubble = BubbleStatistics;
  add_column<vtkIdTypeArray>(data, "BubbleId", bubbles, [](const Bubble& b) { return b.id; });
  add_column<vtkDoubleArray>(data, "BubblePressure", bubbles,
                             [](const Bubble& b) { return b.pressure; });
  add_column<vtkDoubleArray>(data, "BubbleTargetArea", bubbles,
                             [](const Bubble& b) { return b.target_area; });
  const FoamRecord& record = foam.record;
  add_value<vtkDoubleArray>(data, "TimeValue", record.time);
  add_value<vtkDoubleArray>(data, "SurfaceTension", record.surface_tension);
  add_value<vtkIntArray>(data, "Boundary", record.surroundings.boundary);
  write_lattice(record.surroundings, data);
  write_outsides(foam.exteriors, data);
  write_walls(foam, data);
  add_value<vtkDoubleArray>(data, "Energy", foam.energy);
  add_value<vtkDoubleArray>(data, "MaxAngleError", record.report.max_angle_error);
  add_value<vtkDoubleArray>(data, "MaxAreaError", record.report.max_area_error);
  add_value<vtkDoubleArray>(data, "Residual", record.report.residual);
  add_value<vtkIntArray>(data, "Converged", record.report.converged);
  add_value<vtkIntArray>(data, "Iterations", record.report.iterations);
  add_value<vtkIdTypeArray>(data, "T1Count", record.t1_count);
  add_value<vtkIdTypeArray>(data, "T2Count", record.t2_count);
  add_value<vtkIdTypeArray>(data, "T3Count", record.t3_count);
  write_end(record, data);
  if (record.strain_direction != 0) {
    add_value<vtkDoubleArray>(data, "Strain", record.strain);
    add_value<vtkIntArray>(data, "StrainDirection", record.strain_direction);
  }
  if (record.time_step > 0) {
    add_value<vtkDoubleArray>(data, "TimeStep", record.time_step);
    add_value<vtkDoubleArray>(data, "GrowthConstant", record.growth_constant);
    add_value<vtkDoubleArray>(data, "T1Length", record.thresholds.t1_length);
    add_value<vtkDoubleArray>(data, "T2Area", record.thresholds.t2_area);
  }
  add_value<vtkIntArray>(data, "FormatVersion", kFormatVersion);
}

} // namespace

void write_films(const SampledFoam& foam, vtkPolyData* films) {
  const FilmPolylines& lines = foam.films;
  films->Initialize();
  films->SetPoints(points_of(lines.points));
  films->SetLines(cells_of(lines.offsets, lines.connectivity));
  add_array<vtkIdTypeArray>(films->GetPointData(), "JunctionId", lines.junction_id);
  auto* cells = films->GetCellData();
  add_array<vtkIdTypeArray>(cells, "LeftBubble", lines.left);
  add_array<vtkIdTypeArray>(cells, "RightBubble", lines.right);
  add_array<vtkDoubleArray>(cells, "Curvature", lines.curvature);
  add_array<vtkDoubleArray>(cells, "PressureDifference", lines.pressure_difference);
  add_array<vtkDoubleArray>(cells, "Length", lines.length);
  add_array<vtkDoubleArray>(cells, "HalfAngle", lines.half_angle);
  add_array<vtkIntArray>(cells, "OnBoundary", lines.on_boundary);
  if (!lines.tension.empty()) {
    add_array<vtkDoubleArray>(cells, "FilmTension", lines.tension);
  }
  if (!lines.kind.empty()) {
    add_array<vtkIntArray>(cells, "Kind", lines.kind);
  }
  write_state(foam, films->GetFieldData());
}

void write_bubbles(const SampledFoam& foam, vtkPolyData* bubbles) {
  const BubblePolygons& polygons = foam.bubbles;
  std::vector<std::int64_t> connectivity(polygons.points.size());
  std::iota(connectivity.begin(), connectivity.end(), std::int64_t{0});
  bubbles->Initialize();
  bubbles->SetPoints(points_of(polygons.points));
  bubbles->SetPolys(cells_of(polygons.offsets, connectivity));
  add_bubble_columns(bubbles->GetCellData(), polygons.each);
  add_value<vtkDoubleArray>(bubbles->GetFieldData(), "TimeValue", foam.record.time);
  write_end(foam.record, bubbles->GetFieldData());
}

void write_events(std::span<const TopologicalEvent> events, vtkPolyData* vertices) {
  using Event = TopologicalEvent;
  std::vector<Point3> places;
  places.reserve(events.size());
  for (const Event& event : events) {
    places.push_back({event.place.x, event.place.y, 0});
  }
  std::vector<std::int64_t> offsets(events.size() + 1);
  std::iota(offsets.begin(), offsets.end(), std::int64_t{0});
  vertices->Initialize();
  vertices->SetPoints(points_of(places));
  vertices->SetVerts(cells_of(offsets, {offsets.begin(), offsets.end() - 1}));
  auto* data = vertices->GetPointData();
  add_column<vtkIntArray>(data, "Kind", events, [](const Event& e) { return e.kind; });
  add_column<vtkDoubleArray>(data, "Time", events, [](const Event& e) { return e.time; });
  add_column<vtkDoubleArray>(data, "Strain", events, [](const Event& e) { return e.strain; });
  vtkNew<vtkIdTypeArray> bubbles;
  bubbles->SetName("Bubbles");
  bubbles->SetNumberOfComponents(4);
  bubbles->SetNumberOfTuples(static_cast<vtkIdType>(events.size()));
  for (std::size_t i = 0; i < events.size(); ++i) {
    for (int k = 0; k < 4; ++k) {
      bubbles->SetTypedComponent(static_cast<vtkIdType>(i), k,
                                 events[i].bubbles[static_cast<std::size_t>(k)]);
    }
  }
  data->AddArray(bubbles);
}

} // namespace foam::filters
