// SPDX-License-Identifier: GPL-3.0-or-later
#include "construct/from_points.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <ranges>
#include <string>
#include <tuple>

#include "base/error.h"
#include "construct/default_torus.h"
#include "construct/dual_mesh.h"
#include "construct/fill_container.h"
#include "construct/triangulation.h"
#include "geometry/bounds.h"
#include "mesh/filling.h"

namespace foam {
namespace {

using std::to_string;

bool positive(double value) {
  return value > 0 && std::isfinite(value);
}

void check_options(const BuildOptions& options, std::size_t points) {
  if (!positive(options.surface_tension)) {
    throw FoamError("the surface tension must be positive, but is " +
                    number(options.surface_tension));
  }
  if (!(options.fin_size >= 0) || !std::isfinite(options.fin_size)) {
    throw FoamError("the fin size must not be negative, but is " + number(options.fin_size));
  }
  if (options.target_areas != TargetAreas::Array) {
    return;
  }
  const auto& areas = options.target_area_array;
  if (areas.size() != points) {
    throw FoamError("there are " + to_string(areas.size()) + " target areas for " +
                    to_string(points) + " points");
  }
  for (std::size_t i = 0; i < areas.size(); ++i) {
    if (!positive(areas[i])) {
      throw FoamError("the target area of point " + to_string(i) + " must be positive, but is " +
                      number(areas[i]));
    }
  }
}

void check_points(std::span<const Vec2> points, std::size_t least) {
  if (points.size() < least) {
    throw FoamError("a foam takes at least " + to_string(least) + " points, but there are " +
                    to_string(points.size()));
  }
  // Two half-films to each of three films to a bubble.
  constexpr auto kMostPoints = static_cast<std::size_t>(std::numeric_limits<Index>::max() / 6);
  if (points.size() > kMostPoints) {
    throw FoamError("there are " + to_string(points.size()) + " points, but at most " +
                    to_string(kMostPoints) + " can be numbered");
  }
  for (std::size_t i = 0; i < points.size(); ++i) {
    if (!std::isfinite(points[i].x) || !std::isfinite(points[i].y)) {
      throw FoamError("point " + to_string(i) + " is at " + number(points[i]));
    }
  }
}

/// Two points in the same place, the pair with the lowest indices in the lowest such place.
void check_distinct(std::span<const Vec2> places, std::span<const Vec2> points) {
  std::vector<std::size_t> order(places.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    return std::tuple(places[i].x, places[i].y, i) < std::tuple(places[j].x, places[j].y, j);
  });
  const auto pair =
      std::adjacent_find(order.begin(), order.end(),
                         [&](std::size_t i, std::size_t j) { return places[i] == places[j]; });
  if (pair == order.end()) {
    return;
  }
  const std::size_t i = pair[0];
  const std::size_t j = pair[1];
  if (points[i] == points[j]) {
    throw FoamError("points " + to_string(i) + " and " + to_string(j) + " are both at " +
                    number(points[i]));
  }
  throw FoamError("points " + to_string(i) + " at " + number(points[i]) + " and " + to_string(j) +
                  " at " + number(points[j]) + " are the same point of the torus");
}

void check_not_on_a_line(std::span<const Vec2> points) {
  const Vec2 a = points[0];
  const Vec2 b = *std::ranges::max_element(points, {}, [&](Vec2 p) { return norm(p - a); });
  const double widest = std::ranges::max(
      points | std::views::transform([&](Vec2 p) { return std::abs(cross(b - a, p - a)); }));
  if (!(widest > 1e-12 * dot(b - a, b - a))) { // on a line but for rounding
    throw FoamError("all " + to_string(points.size()) + " points lie on the line through " +
                    number(points[0]) + " and " + number(points[1]));
  }
}

void check_torus(const Lattice& torus) {
  const auto& [origin, first, second] = torus;
  const std::string periods = "the periods " + number(first) + " and " + number(second);
  const double area = torus.area();
  if (area == 0 || !std::isfinite(area + origin.x + origin.y)) {
    throw FoamError(periods + " at " + number(origin) + " enclose no area");
  }
  if (area < 0) {
    throw FoamError(periods + " are clockwise");
  }
  constexpr double kMostSlender = 1e6; // for the digits that are left across
  const double aspect = std::max(dot(first, first), dot(second, second)) / area;
  if (aspect > kMostSlender) {
    throw FoamError(periods + " enclose a cell " + number(aspect) + " times longer than wide");
  }
}

double covered_area(std::span<const Vec2> points, std::span<const Triangle> triangles) {
  double area = 0;
  for (const auto& [a, b, c] : triangles) {
    if (!a.point.is_outside()) {
      const Vec2 p = points[a.point.place()];
      area += 0.5 * cross(points[b.point.place()] - p, points[c.point.place()] - p);
    }
  }
  return area;
}

/// Whether points lie in one period, and would not come to lie among each other on the torus.
void check_extent(std::span<const Vec2> points, const Lattice& torus) {
  constexpr double kRounding = 1 + 1e-9;
  if (torus.is_rectangle()) {
    const Vec2 extent = bounds_of(points).extent();
    if (extent.x > kRounding * torus.first.x || extent.y > kRounding * torus.second.y) {
      throw FoamError("the points extend over " + number(extent) + ", but the torus is only " +
                      number(Vec2{torus.first.x, torus.second.y}));
    }
    return;
  }
  const double area = covered_area(points, triangulate_plane(points));
  if (area > kRounding * torus.area()) {
    throw FoamError("the points cover an area of " + number(area) + ", but that of the torus is " +
                    number(torus.area()));
  }
}

Vec2 place(const Corner& corner, const TorusPoints& points, const Lattice& torus) {
  return points.position[corner.point] + torus.period(corner.copy);
}

/// Takes the copy of a triangle whose barycentre is in the cell.
void move_into_cell(Triangle& t, const TorusPoints& points, const Lattice& torus) {
  const Vec2 barycentre = (1.0 / 3) * (place(t[0], points, torus) + place(t[1], points, torus) +
                                       place(t[2], points, torus));
  const Wrap out = torus.cell_of(barycentre);
  for (Corner& corner : t) {
    corner.copy = corner.copy - out;
  }
}

Foam build_on_torus(std::span<const Vec2> points, const BuildOptions& options) {
  check_not_on_a_line(points);
  const Lattice torus = options.torus ? *options.torus : default_torus(points);
  check_torus(torus);
  if (!options.fold) {
    check_extent(points, torus);
  }
  const TorusPoints sites = torus_points(points, torus);
  check_distinct(sites.snapped, points);
  auto triangles = triangulate_torus(sites);

  std::vector<Face> faces;
  for (Triangle& t : triangles) {
    move_into_cell(t, sites, torus);
    faces.push_back(
        {place(t[0], sites, torus), place(t[1], sites, torus), place(t[2], sites, torus)});
  }
  Foam foam = dual_mesh(triangles, points.size());
  foam.surround({Boundary::Periodic, torus});
  place_junctions(foam, faces);
  return foam;
}

/// The tip of a fin (thesis 4.5.3, x_free) on the edge from q to r, which has the outside on its
/// left. A fin longer than its edge is wide would run into its neighbours.
Vec2 fin_tip(Vec2 q, Vec2 r, double size) {
  const double edge = norm(r - q);
  return 0.5 * (q + r) + (std::min(size, 1.5 * edge) / edge) * left_normal(r - q);
}

Foam build_on_plane(std::span<const Vec2> points, Boundary boundary, double fin_size) {
  check_distinct(points, points);
  check_not_on_a_line(points);
  const auto triangles = triangulate_plane(points);
  const double area = covered_area(points, triangles);
  const double mean_spacing = std::sqrt(area / static_cast<double>(points.size()));
  const double fin = fin_size > 0 ? fin_size : 1.5 * mean_spacing;

  std::vector<Face> faces;
  for (const auto& [a, b, c] : triangles) {
    const Vec2 q = points[b.point.place()];
    const Vec2 r = points[c.point.place()];
    faces.push_back({a.point.is_outside() ? fin_tip(q, r, fin) : points[a.point.place()], q, r});
  }
  Foam foam = dual_mesh(triangles, points.size());
  foam.surround({});
  place_junctions(foam, faces);
  if (boundary == Boundary::Fixed) {
    foam.seal_outline();
  }
  return foam;
}

void take_target_areas(Foam& foam, const BuildOptions& options) {
  foam.target_area.resize(foam.bubble_half.size());
  for (const Bubble b : foam.bubble_slots()) {
    foam.target_area[b] = foam.area(b);
    if (!positive(foam.target_area[b])) {
      throw FoamError("the initial area of bubble " + to_string(b.index()) + " is " +
                      number(foam.target_area[b]));
    }
  }
  switch (options.target_areas) {
  case TargetAreas::Initial:
    break;
  case TargetAreas::Uniform:
    std::ranges::fill(foam.target_area, foam.mean_area());
    break;
  case TargetAreas::Array:
    std::ranges::copy(options.target_area_array, foam.target_area.begin());
    fill_space(foam, options.fit_areas ? std::numeric_limits<double>::infinity() : kMeasuredAreas,
               "FitAreas scales them, whatever they add up to");
    break;
  }
}

Foam build_in_container(std::span<const Vec2> points, const Container& container) {
  check_distinct(points, points);
  return fill_container(points, container);
}

Foam build(std::span<const Vec2> points, const BuildOptions& options) {
  switch (options.boundary) {
  case Boundary::Periodic:
    return build_on_torus(points, options);
  case Boundary::Container:
    return build_in_container(points, options.container);
  default:
    return build_on_plane(points, options.boundary, options.fin_size);
  }
}

} // namespace

Foam build_from_points(std::span<const Vec2> points, const BuildOptions& options) {
  check_points(points, options.boundary == Boundary::Container ? 2 : 3);
  check_options(options, points.size());
  Foam foam = build(points, options);
  foam.surface_tension = options.surface_tension;
  take_target_areas(foam, options);
  return foam;
}

} // namespace foam
