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
#include "construct/dual_mesh.h"
#include "construct/triangulation.h"

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

void check_points(std::span<const Vec2> points) {
  if (points.size() < 3) {
    throw FoamError("a foam takes at least 3 points, but there are " + to_string(points.size()));
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

Box bounds(std::span<const Vec2> points) {
  Box box{points[0].x, points[0].x, points[0].y, points[0].y};
  for (const Vec2 p : points) {
    box = {std::min(box.xmin, p.x), std::max(box.xmax, p.x), std::min(box.ymin, p.y),
           std::max(box.ymax, p.y)};
  }
  return box;
}

/// The points' bounds grown by half a mean spacing m on every side, where m² is the area that the
/// grown box has per point: (N − 1)·m² − (w + h)·m − w·h = 0. A square grid gets its own period.
Box default_box(std::span<const Vec2> points) {
  const Box box = bounds(points);
  const double others = static_cast<double>(points.size() - 1);
  const double sum = box.width() + box.height();
  const double product = box.width() * box.height();
  const double half_spacing = (sum + std::sqrt(sum * sum + 4 * others * product)) / (4 * others);
  return {box.xmin - half_spacing, box.xmax + half_spacing, box.ymin - half_spacing,
          box.ymax + half_spacing};
}

void check_box(const Box& box) {
  if (!positive(box.width()) || !positive(box.height())) {
    throw FoamError("the periodic bounds enclose no area: " + number(box.xmin) + " " +
                    number(box.xmax) + " " + number(box.ymin) + " " + number(box.ymax));
  }
  constexpr double kMostSlender = 1e6; // for the digits that are left across
  const double aspect = std::max(box.width() / box.height(), box.height() / box.width());
  if (aspect > kMostSlender) {
    throw FoamError("the periodic bounds are " + number(aspect) + " times longer than wide");
  }
}

Vec2 place(const Corner& corner, const TorusPoints& points, const Box& box) {
  const Vec2 p = points.position[Foam::size(corner.point)];
  return {p.x + corner.copy.x * box.width(), p.y + corner.copy.y * box.height()};
}

/// Takes the copy of a triangle whose barycentre is in the box.
void move_into_box(Triangle& t, const TorusPoints& points, const Box& box) {
  const Vec2 b =
      (1.0 / 3) * (place(t[0], points, box) + place(t[1], points, box) + place(t[2], points, box));
  const Wrap out{static_cast<Index>(std::floor((b.x - box.xmin) / box.width())),
                 static_cast<Index>(std::floor((b.y - box.ymin) / box.height()))};
  for (Corner& corner : t) {
    corner.copy = corner.copy - out;
  }
}

Foam build_on_torus(std::span<const Vec2> points, const std::optional<Box>& periodic_box) {
  const Box box = periodic_box ? *periodic_box : default_box(points);
  check_box(box);
  const TorusPoints sites = torus_points(points, box);
  check_distinct(sites.snapped, points);
  check_not_on_a_line(points);
  auto triangles = triangulate_torus(sites);

  std::vector<Face> faces;
  for (Triangle& t : triangles) {
    move_into_box(t, sites, box);
    faces.push_back({place(t[0], sites, box), place(t[1], sites, box), place(t[2], sites, box)});
  }
  Foam foam = dual_mesh(triangles, points.size());
  foam.boundary = Boundary::Periodic;
  foam.box = box;
  place_junctions(foam, faces);
  return foam;
}

double covered_area(std::span<const Vec2> points, std::span<const Triangle> triangles) {
  double area = 0;
  for (const auto& [a, b, c] : triangles) {
    if (a.point != kWorld) {
      const Vec2 p = points[Foam::size(a.point)];
      area += 0.5 * cross(points[Foam::size(b.point)] - p, points[Foam::size(c.point)] - p);
    }
  }
  return area;
}

/// The tip of a fin (thesis 4.5.3, x_free) on the edge from q to r, which has the world on its
/// left. A fin longer than its edge is wide would run into its neighbours.
Vec2 fin_tip(Vec2 q, Vec2 r, double size) {
  const double edge = norm(r - q);
  return 0.5 * (q + r) + (std::min(size, 1.5 * edge) / edge) * left_normal(r - q);
}

Foam build_on_plane(std::span<const Vec2> points, double fin_size) {
  check_distinct(points, points);
  check_not_on_a_line(points);
  const auto triangles = triangulate_plane(points);
  const double area = covered_area(points, triangles);
  const double mean_spacing = std::sqrt(area / static_cast<double>(points.size()));
  const double fin = fin_size > 0 ? fin_size : 1.5 * mean_spacing;

  std::vector<Face> faces;
  for (const auto& [a, b, c] : triangles) {
    const Vec2 q = points[Foam::size(b.point)];
    const Vec2 r = points[Foam::size(c.point)];
    faces.push_back({a.point == kWorld ? fin_tip(q, r, fin) : points[Foam::size(a.point)], q, r});
  }
  Foam foam = dual_mesh(triangles, points.size());
  place_junctions(foam, faces);
  return foam;
}

/// Given areas, scaled to fill the space to the last digit.
std::vector<double> fitted(std::vector<double> areas, double space, const std::string& name) {
  const double sum = std::accumulate(areas.begin(), areas.end(), 0.0);
  if (!(std::abs(sum - space) <= 1e-6 * space)) {
    throw FoamError("the target areas add up to " + number(sum) + ", but the area of the " + name +
                    " is " + number(space));
  }
  for (double& area : areas) {
    area *= space / sum;
  }
  return areas;
}

std::vector<double> target_areas(const Foam& foam, const BuildOptions& options) {
  std::vector<double> initial(foam.bubble_half.size());
  for (std::size_t i = 0; i < initial.size(); ++i) {
    initial[i] = foam.area(static_cast<Index>(i));
    if (!positive(initial[i])) {
      throw FoamError("the initial area of bubble " + to_string(i) + " is " + number(initial[i]));
    }
  }
  const double total = std::accumulate(initial.begin(), initial.end(), 0.0);
  switch (options.target_areas) {
  case TargetAreas::Initial:
    return initial;
  case TargetAreas::Uniform:
    return std::vector<double>(initial.size(), total / static_cast<double>(initial.size()));
  case TargetAreas::Array:
    break;
  }
  switch (options.boundary) {
  case Boundary::Periodic:
    return fitted(options.target_area_array, foam.box.width() * foam.box.height(),
                  "periodic bounds");
  case Boundary::Fixed:
    return fitted(options.target_area_array, total, "container");
  case Boundary::Free:
    break;
  }
  return options.target_area_array;
}

} // namespace

Foam build_from_points(std::span<const Vec2> points, const BuildOptions& options) {
  check_points(points);
  check_options(options, points.size());
  Foam foam = options.boundary == Boundary::Periodic ? build_on_torus(points, options.periodic_box)
                                                     : build_on_plane(points, options.fin_size);
  foam.boundary = options.boundary;
  foam.surface_tension = options.surface_tension;
  foam.target_area = target_areas(foam, options);
  return foam;
}

} // namespace foam
