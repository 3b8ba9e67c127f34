// SPDX-License-Identifier: GPL-3.0-or-later
#include "FoamWriting.h"

#include <algorithm>
#include <cmath>
#include <numeric>
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

#include "Columns.h"
#include "mesh/film_set.h"
#include "sampling/arcs.h"
#include "statistics/statistics.h"

namespace foam::filters {
namespace {

constexpr std::size_t kFansTried = 512;

/// Adds an empty array with room for `count` values.
template <class Array> Array* add_array(vtkFieldData* data, const char* name, std::size_t count) {
  vtkNew<Array> array;
  array->SetName(name);
  array->Allocate(static_cast<vtkIdType>(count));
  data->AddArray(array);
  return array;
}

template <class Array, class Value>
void add_value(vtkFieldData* data, const char* name, Value value) {
  using Stored = typename Array::ValueType;
  add_array<Array>(data, name, 1)->InsertNextValue(static_cast<Stored>(value));
}

void write_state(const Foam& foam, const FilmSet& set, vtkFieldData* data) {
  auto* id = add_array<vtkIdTypeArray>(data, "BubbleId", set.bubbles.size());
  auto* pressure = add_array<vtkDoubleArray>(data, "BubblePressure", set.bubbles.size());
  auto* target_area = add_array<vtkDoubleArray>(data, "BubbleTargetArea", set.bubbles.size());
  for (const auto& bubble : set.bubbles) {
    id->InsertNextValue(bubble.id);
    pressure->InsertNextValue(bubble.pressure);
    target_area->InsertNextValue(bubble.target_area);
  }
  add_value<vtkDoubleArray>(data, "TimeValue", set.time);
  add_value<vtkDoubleArray>(data, "SurfaceTension", set.surface_tension);
  add_value<vtkIntArray>(data, "Boundary", set.boundary);
  auto* bounds = add_array<vtkDoubleArray>(data, "PeriodicBounds", 4);
  bounds->SetNumberOfComponents(4);
  bounds->InsertNextTuple4(set.box.xmin, set.box.xmax, set.box.ymin, set.box.ymax);
  add_value<vtkDoubleArray>(data, "Energy", foam.energy());
  add_value<vtkDoubleArray>(data, "MaxAngleError", set.report.max_angle_error);
  add_value<vtkDoubleArray>(data, "MaxAreaError", set.report.max_area_error);
  add_value<vtkDoubleArray>(data, "Residual", set.report.residual);
  add_value<vtkIntArray>(data, "Converged", set.report.converged);
  add_value<vtkIntArray>(data, "Iterations", set.report.iterations);
  add_value<vtkIdTypeArray>(data, "T1Count", set.t1_count);
  add_value<vtkIdTypeArray>(data, "T2Count", set.t2_count);
  add_value<vtkIdTypeArray>(data, "T3Count", set.t3_count);
  add_value<vtkIntArray>(data, "FormatVersion", kFormatVersion);
}

/// Centroid of a polygon; its mean vertex if it has no area.
Vec2 centroid(const std::vector<Vec2>& polygon) {
  const Vec2 origin = polygon.front();
  double area = 0;
  Vec2 moment, sum;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2 a = polygon[i] - origin;
    const Vec2 b = polygon[(i + 1) % polygon.size()] - origin;
    const double w = cross(a, b) / 2;
    area += w;
    moment += (w / 3) * (a + b);
    sum += a;
  }
  const Vec2 mean = (1 / static_cast<double>(polygon.size())) * sum;
  return origin + (area > 0 ? (1 / area) * moment : mean);
}

/// The area by which a fan of triangles around a vertex overlaps itself or leaves the polygon.
double fan_error(const std::vector<Vec2>& polygon, std::size_t vertex) {
  double error = 0;
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    const Vec2 a = polygon[(vertex + i) % polygon.size()] - polygon[vertex];
    const Vec2 b = polygon[(vertex + i + 1) % polygon.size()] - polygon[vertex];
    error += std::max(0.0, -cross(a, b));
  }
  return error;
}

/// Lets a polygon begin with the vertex around which a fan of triangles covers it best: ParaView
/// draws polygons as fans, which leaves slivers along sides that are bent inwards. Of a polygon
/// with very many vertices not all are tried.
void begin_with_best_fan(std::vector<Vec2>& polygon) {
  const std::size_t stride = 1 + polygon.size() / kFansTried;
  std::size_t best = 0;
  double least = fan_error(polygon, 0);
  for (std::size_t i = stride; i < polygon.size() && least > 0; i += stride) {
    const double error = fan_error(polygon, i);
    if (error < least) {
      best = i;
      least = error;
    }
  }
  std::rotate(polygon.begin(), polygon.begin() + static_cast<std::ptrdiff_t>(best), polygon.end());
}

/// The translation by whole periods that brings a point into the box.
Vec2 into_box(const Foam& foam, Vec2 p) {
  if (foam.boundary != Boundary::Periodic) {
    return {};
  }
  return {-std::floor((p.x - foam.box.xmin) / foam.box.width()) * foam.box.width(),
          -std::floor((p.y - foam.box.ymin) / foam.box.height()) * foam.box.height()};
}

} // namespace

void write_foam(const Foam& foam, double chord_error, vtkPolyData* films, vtkPolyData* bubbles) {
  const double error = chord_error > 0 ? chord_error : foam.mean_spacing() / 200;
  write_films(foam, error, films);
  write_bubbles(foam, error, bubbles);
}

void write_films(const Foam& foam, double chord_error, vtkPolyData* films) {
  const FilmSet set = film_set(foam);
  const std::size_t count = set.films.size();

  films->Initialize();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  auto* junction_id = add_array<vtkIdTypeArray>(films->GetPointData(), "JunctionId", count);
  const auto add_point = [&](Vec2 p, Index junction) {
    junction_id->InsertNextValue(junction);
    return points->InsertNextPoint(p.x, p.y, 0);
  };
  for (std::size_t j = 0; j < set.junctions.size(); ++j) {
    add_point(set.junctions[j], static_cast<Index>(j));
  }

  auto* cells = films->GetCellData();
  auto* left = add_array<vtkIdTypeArray>(cells, "LeftBubble", count);
  auto* right = add_array<vtkIdTypeArray>(cells, "RightBubble", count);
  auto* curvature = add_array<vtkDoubleArray>(cells, "Curvature", count);
  auto* difference = add_array<vtkDoubleArray>(cells, "PressureDifference", count);
  auto* length = add_array<vtkDoubleArray>(cells, "Length", count);
  auto* half_angle = add_array<vtkDoubleArray>(cells, "HalfAngle", count);
  auto* on_boundary = add_array<vtkIntArray>(cells, "OnBoundary", count);

  std::vector<Vec2> arc;
  std::size_t i = 0;
  for (Index f = 0; f < foam.film_capacity(); ++f) {
    if (!foam.has_film(f)) {
      continue;
    }
    const Index h = 2 * f;
    const auto& film = set.films[i++];
    const Vec2 start = set.junctions[Foam::size(film.start)];
    arc.clear();
    sample_arc(foam, h, start, chord_error, arc);
    lines->InsertNextCell(static_cast<int>(arc.size()));
    lines->InsertCellPoint(film.start);
    for (std::size_t k = 1; k + 1 < arc.size(); ++k) {
      lines->InsertCellPoint(add_point(arc[k], -1));
    }
    const bool wrapped = film.wrap != Wrap{};
    const Vec2 end = set.junctions[Foam::size(film.end)];
    lines->InsertCellPoint(wrapped ? add_point(end + foam.period(film.wrap), film.end) : film.end);

    left->InsertNextValue(film.left);
    right->InsertNextValue(film.right);
    curvature->InsertNextValue(arc_curvature(norm(foam.chord(h)), film.half_angle));
    difference->InsertNextValue(foam.pressure_of(foam.left(h)) - foam.pressure_of(foam.right(h)));
    length->InsertNextValue(foam.length(h));
    half_angle->InsertNextValue(film.half_angle);
    on_boundary->InsertNextValue(foam.on_world(h) ? 1 : 0);
  }
  films->SetPoints(points);
  films->SetLines(lines);
  write_state(foam, set, films->GetFieldData());
}

void write_bubbles(const Foam& foam, double chord_error, vtkPolyData* bubbles) {
  std::vector<Index> order;
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    if (foam.has_bubble(b)) {
      order.push_back(b);
    }
  }
  std::sort(order.begin(), order.end(), [&](Index a, Index b) {
    return foam.bubble_id[Foam::size(a)] < foam.bubble_id[Foam::size(b)];
  });

  bubbles->Initialize();
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> polygons;
  for (const Index b : order) {
    auto outline = sample_bubble(foam, b, chord_error);
    begin_with_best_fan(outline);
    const Vec2 shift = into_box(foam, centroid(outline));
    polygons->InsertNextCell(static_cast<int>(outline.size()));
    for (const Vec2 p : outline) {
      polygons->InsertCellPoint(points->InsertNextPoint(p.x + shift.x, p.y + shift.y, 0));
    }
  }
  bubbles->SetPoints(points);
  bubbles->SetPolys(polygons);

  add_bubble_columns(bubbles->GetCellData(), statistics(foam, true).each);
  add_value<vtkDoubleArray>(bubbles->GetFieldData(), "TimeValue", foam.time);
}

} // namespace foam::filters
