// SPDX-License-Identifier: GPL-3.0-or-later
#include "FilmBuffer.h"

#include <cmath>
#include <limits>
#include <numbers>
#include <sstream>

#include <vtkCellArray.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

namespace foam::rendering {
namespace {

constexpr int kFloatsPerTexel = 4;

template <class... Parts> std::string message(const Parts&... parts) {
  std::ostringstream out;
  out.precision(std::numeric_limits<double>::max_digits10);
  (out << ... << parts);
  return out.str();
}

/// Calls visit(film, first point, last point) for what is drawn as one arc: each polyline, in their
/// order, but of stretches of walls that are no arc the first segment; then the segments that are
/// left of these. A polyline of fewer than two points has −1 for both.
template <class Visit> void for_each_arc(vtkPolyData* polylines, const Visit& visit) {
  vtkCellArray* lines = polylines->GetLines();
  const vtkIdType count = lines->GetNumberOfCells();
  vtkCellData* data = polylines->GetCellData();
  vtkDataArray* kind = data->GetArray("Kind");
  vtkDataArray* half_angle = data->GetArray("HalfAngle");
  const bool has_walls = kind && kind->GetNumberOfTuples() == count && half_angle &&
                         half_angle->GetNumberOfTuples() == count;
  std::vector<vtkIdType> bent;
  vtkIdType size = 0;
  const vtkIdType* ids = nullptr;
  for (vtkIdType film = 0; film < count; ++film) {
    lines->GetCellAtId(film, size, ids);
    const bool no_arc = has_walls && size > 2 && kind->GetComponent(film, 0) == 1 &&
                        half_angle->GetComponent(film, 0) == 0;
    if (no_arc) {
      bent.push_back(film);
    }
    size < 2 ? visit(film, -1, -1) : visit(film, ids[0], ids[no_arc ? 1 : size - 1]);
  }
  for (const vtkIdType film : bent) {
    lines->GetCellAtId(film, size, ids);
    for (vtkIdType k = 2; k < size; ++k) {
      visit(film, ids[k - 1], ids[k]);
    }
  }
}

} // namespace

FilmReading read_drawn_films(vtkPolyData* polylines) {
  FilmReading reading;
  const auto problem = [&](const auto&... parts) {
    reading.problem = message(parts...);
    return reading;
  };
  vtkCellArray* lines = polylines->GetLines();
  const vtkIdType count = lines->GetNumberOfCells();
  if (polylines->GetNumberOfCells() != count) {
    return problem(polylines->GetNumberOfCells() - count, " of its cells are not polylines");
  }
  vtkCellData* data = polylines->GetCellData();
  vtkDataArray* half_angle = data->GetArray("HalfAngle");
  if (!half_angle) {
    return problem("cell array HalfAngle is ",
                   data->GetAbstractArray("HalfAngle") ? "not numeric" : "missing");
  }
  if (half_angle->GetNumberOfComponents() != 1 || half_angle->GetNumberOfTuples() != count) {
    return problem("cell array HalfAngle has ", half_angle->GetNumberOfTuples(), " values of ",
                   half_angle->GetNumberOfComponents(), " components for ", count, " films");
  }
  vtkDataArray* junction_id = polylines->GetPointData()->GetArray("JunctionId");
  const auto junction = [&](vtkIdType point) {
    const std::int64_t id =
        junction_id ? static_cast<std::int64_t>(junction_id->GetComponent(point, 0)) : point;
    return id >= 0 ? id : -1 - point; // an end in no junction is alone
  };

  reading.films.reserve(static_cast<std::size_t>(count));
  const auto take = [&](vtkIdType film, vtkIdType first, vtkIdType last) {
    if (!reading.problem.empty()) {
      return;
    }
    if (first < 0) {
      problem("film ", film, " has fewer than two points");
      return;
    }
    double a[3], b[3];
    polylines->GetPoint(first, a);
    polylines->GetPoint(last, b);
    const double alpha = half_angle->GetComponent(film, 0);
    if (!(std::abs(alpha) < std::numbers::pi)) {
      problem("HalfAngle of film ", film, " is ", alpha);
      return;
    }
    if (reading.films.empty()) {
      reading.z = a[2];
    }
    for (const double* p : {a, b}) {
      if (!std::isfinite(p[0] + p[1]) || p[2] != reading.z) {
        problem("film ", film, " ends in (", p[0], ", ", p[1], ", ", p[2],
                "), which is not in the plane z = ", reading.z);
        return;
      }
    }
    reading.films.push_back(
        {{a[0], a[1]}, {b[0], b[1]}, std::tan(alpha / 2), junction(first), junction(last)});
  };
  for_each_arc(polylines, take);
  return reading;
}

vtkSmartPointer<vtkPolyData> chords_of(vtkPolyData* polylines) {
  vtkNew<vtkPoints> points;
  points->SetDataTypeToDouble();
  vtkNew<vtkCellArray> lines;
  vtkSmartPointer<vtkPolyData> chords = vtkSmartPointer<vtkPolyData>::New();
  vtkPointData* of_points = chords->GetPointData();
  vtkCellData* of_films = chords->GetCellData();
  const vtkIdType count = polylines->GetNumberOfLines();
  points->Allocate(2 * count);
  lines->AllocateEstimate(count, 2);
  of_points->CopyAllocate(polylines->GetPointData(), 2 * count);
  of_films->CopyAllocate(polylines->GetCellData(), count);
  for_each_arc(polylines, [&](vtkIdType film, vtkIdType first, vtkIdType last) {
    const vtkIdType ids[] = {points->InsertNextPoint(polylines->GetPoint(first)),
                             points->InsertNextPoint(polylines->GetPoint(last))};
    of_points->CopyData(polylines->GetPointData(), first, ids[0]);
    of_points->CopyData(polylines->GetPointData(), last, ids[1]);
    of_films->CopyData(polylines->GetCellData(), film, lines->InsertNextCell(2, ids));
  });
  chords->SetPoints(points);
  chords->SetLines(lines);
  chords->GetFieldData()->ShallowCopy(polylines->GetFieldData());
  return chords;
}

int texels_per_film(double border_radius) {
  return border_radius > 0 ? 7 : 3;
}

void append_films(const std::vector<DrawnFilm>& films, Vec2 origin, double border_radius,
                  std::vector<float>& buffer) {
  const auto per_film = static_cast<std::size_t>(kFloatsPerTexel * texels_per_film(border_radius));
  const auto before = static_cast<std::int64_t>(buffer.size() / per_film);
  const auto append = [&](double x, double y, double z, double w) {
    for (const double value : {x, y, z, w}) {
      buffer.push_back(static_cast<float>(value));
    }
  };
  const auto number = [&](std::int64_t end) {
    return end < 0 ? -1.0 : static_cast<double>(2 * before + end);
  };

  const auto ends = film_ends(films, border_radius);
  buffer.reserve(buffer.size() + per_film * films.size());
  for (std::size_t i = 0; i < films.size(); ++i) {
    const Vec2 start = films[i].start - origin;
    const Vec2 end = films[i].end - origin;
    const FilmEnd& at_start = ends[2 * i];
    const FilmEnd& at_end = ends[2 * i + 1];
    append(start.x, start.y, end.x, end.y);
    append(films[i].bulge, std::max(border_margin(at_start), border_margin(at_end)), 0, 0);
    append(number(at_start.left.end), number(at_start.right.end), number(at_end.left.end),
           number(at_end.right.end));
    if (border_radius > 0) {
      const auto append_side = [&](Vec2 junction, const BorderSide& side) {
        append(junction.x + side.centre.x, junction.y + side.centre.y, side.radius, 0);
      };
      append_side(start, at_start.left.side);
      append_side(start, at_start.right.side);
      append_side(end, at_end.left.side);
      append_side(end, at_end.right.side);
    }
  }
}

} // namespace foam::rendering
