// SPDX-License-Identifier: GPL-3.0-or-later
#include "construct/containers.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>

#include "base/error.h"
#include "geometry/bounds.h"
#include "geometry/winding.h"

namespace foam {
namespace {

using std::to_string;

void check_bounds(const ContainerBounds& bounds) {
  const auto& [xmin, xmax, ymin, ymax] = bounds;
  if (!(xmin < xmax && ymin < ymax) || !std::isfinite(xmax - xmin + ymax - ymin)) {
    throw FoamError("the container's bounds from " + number(Vec2{xmin, ymin}) + " to " +
                    number(Vec2{xmax, ymax}) + " enclose nothing");
  }
}

Wall straight_wall(std::span<const Vec2> corners, WallContact contact) {
  Wall wall{{}, contact};
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec2 next = corners[(i + 1) % corners.size()];
    wall.pieces.push_back({corners[i], next - corners[i], 0});
  }
  return wall;
}

/// \param turn 1 counter-clockwise, with the foam inside; −1 round an obstacle
Wall circle(Vec2 centre, double radius, double turn, WallContact contact) {
  const auto pieces = whole_circle(centre, radius, turn);
  return {{pieces.begin(), pieces.end()}, contact};
}

double twice_area(std::span<const Vec2> polygon) {
  double sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sum += cross(polygon[i] - polygon[0], polygon[(i + 1) % polygon.size()] - polygon[0]);
  }
  return sum;
}

bool cross_each_other(Vec2 a, Vec2 b, Vec2 c, Vec2 d) {
  const auto side = [](Vec2 p, Vec2 q, Vec2 r) {
    const double s = cross(q - p, r - p);
    return s > 0 ? 1 : (s < 0 ? -1 : 0);
  };
  return side(a, b, c) * side(a, b, d) <= 0 && side(c, d, a) * side(c, d, b) <= 0 &&
         std::max(std::min(a.x, b.x), std::min(c.x, d.x)) <=
             std::min(std::max(a.x, b.x), std::max(c.x, d.x)) &&
         std::max(std::min(a.y, b.y), std::min(c.y, d.y)) <=
             std::min(std::max(a.y, b.y), std::max(c.y, d.y));
}

/// \throws FoamError if two edges of polygons touch that are no neighbours.
void check_crossings(std::span<const std::vector<Vec2>> polygons) {
  struct Edge {
    std::size_t polygon, place;
    Vec2 a, b;
  };
  std::vector<Edge> edges;
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    const auto& polygon = polygons[p];
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      edges.push_back({p, i, polygon[i], polygon[(i + 1) % polygon.size()]});
    }
  }
  std::ranges::sort(edges, {}, [](const Edge& e) { return std::min(e.a.x, e.b.x); });
  for (std::size_t i = 0; i < edges.size(); ++i) {
    const Edge& e = edges[i];
    const double end = std::max(e.a.x, e.b.x);
    for (std::size_t k = i + 1; k < edges.size(); ++k) {
      const Edge& f = edges[k];
      if (std::min(f.a.x, f.b.x) > end) {
        break;
      }
      const std::size_t size = polygons[e.polygon].size();
      const std::size_t apart = (e.place + size - f.place) % size;
      const bool neighbours = e.polygon == f.polygon && (apart == 1 || apart == size - 1);
      if (!neighbours && cross_each_other(e.a, e.b, f.a, f.b)) {
        throw FoamError("outline " + to_string(e.polygon) + " crosses " +
                        (e.polygon == f.polygon ? "itself" : "outline " + to_string(f.polygon)) +
                        " between " + number(e.a) + " and " + number(e.b));
      }
    }
  }
}

/// Of points and half of their mean spacing beside them. \param round whether a disc in the bounds
/// is to hold them
ContainerBounds bounds_round(std::span<const Vec2> points, bool round) {
  const Bounds bounds = bounds_of(points);
  const auto [width, height] = bounds.extent();
  const double margin = 0.5 * std::sqrt(width * height / static_cast<double>(points.size()));
  if (!round) {
    return {bounds.low.x - margin, bounds.high.x + margin, bounds.low.y - margin,
            bounds.high.y + margin};
  }
  const Vec2 middle = bounds.low + 0.5 * bounds.extent();
  double radius = 0;
  for (const Vec2 p : points) {
    radius = std::max(radius, norm(p - middle));
  }
  radius += margin;
  return {middle.x - radius, middle.x + radius, middle.y - radius, middle.y + radius};
}

} // namespace

Container rectangle(const ContainerBounds& bounds, WallContact contact) {
  check_bounds(bounds);
  const auto& [xmin, xmax, ymin, ymax] = bounds;
  const std::array<Vec2, 4> corners{Vec2{xmin, ymin}, Vec2{xmax, ymin}, Vec2{xmax, ymax},
                                    Vec2{xmin, ymax}};
  return {{straight_wall(corners, contact)}, 0};
}

Container disc(const ContainerBounds& bounds, WallContact contact) {
  check_bounds(bounds);
  const auto& [xmin, xmax, ymin, ymax] = bounds;
  const double radius = 0.5 * std::min(xmax - xmin, ymax - ymin);
  return {{circle({0.5 * (xmin + xmax), 0.5 * (ymin + ymax)}, radius, 1, contact)}, 0};
}

Container annulus(const ContainerBounds& bounds, double inner_radius, WallContact contact) {
  Container container = disc(bounds, contact);
  const auto& [xmin, xmax, ymin, ymax] = bounds;
  const double radius = 0.5 * std::min(xmax - xmin, ymax - ymin);
  if (!(inner_radius > 0 && inner_radius < radius)) {
    throw FoamError("the inner radius of an annulus must lie between 0 and the outer one, " +
                    number(radius) + ", but is " + number(inner_radius));
  }
  container.walls.push_back(
      circle({0.5 * (xmin + xmax), 0.5 * (ymin + ymax)}, inner_radius, -1, contact));
  return container;
}

Container channel(const ContainerBounds& bounds, WallContact contact) {
  check_bounds(bounds);
  const auto& [xmin, xmax, ymin, ymax] = bounds;
  const double period = xmax - xmin;
  return {{Wall{{{{xmin, ymin}, {period, 0}, 0}}, contact},
           Wall{{{{xmax, ymax}, {-period, 0}, 0}}, contact}},
          period};
}

Container outline(std::span<const std::vector<Vec2>> polygons, WallContact contact) {
  if (polygons.empty()) {
    throw FoamError("a container's outline takes a closed polyline, but there is none");
  }
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    if (polygons[p].size() < 3) {
      throw FoamError("outline " + to_string(p) + " has " + to_string(polygons[p].size()) +
                      " corners, and takes at least 3");
    }
    for (const Vec2 corner : polygons[p]) {
      if (!std::isfinite(corner.x) || !std::isfinite(corner.y)) {
        throw FoamError("outline " + to_string(p) + " has a corner at " + number(corner));
      }
    }
  }
  check_crossings(polygons);
  const auto area = [&](const std::vector<Vec2>& polygon) { return std::abs(twice_area(polygon)); };
  const auto largest = std::ranges::max_element(polygons, {}, area) - polygons.begin();
  Container container;
  const auto add = [&](const std::vector<Vec2>& polygon, bool container_itself) {
    std::vector<Vec2> corners = polygon;
    if ((twice_area(corners) > 0) != container_itself) {
      std::ranges::reverse(corners);
    }
    container.walls.push_back(straight_wall(corners, contact));
  };
  add(polygons[static_cast<std::size_t>(largest)], true);
  for (std::size_t p = 0; p < polygons.size(); ++p) {
    if (static_cast<std::ptrdiff_t>(p) != largest) {
      if (!is_inside(container, polygons[p][0])) {
        throw FoamError("outline " + to_string(p) + ", an obstacle, lies at " +
                        number(polygons[p][0]) +
                        (winding(container.walls[0].pieces, polygons[p][0]) == 0
                             ? ", outside of the container"
                             : ", inside of another obstacle"));
      }
      add(polygons[p], false);
    }
  }
  return container;
}

Container make_container(const ContainerOptions& options, std::span<const Vec2> points) {
  if (options.shape == ContainerShape::Outline) {
    return outline(options.outlines, options.contact);
  }
  const bool round =
      options.shape == ContainerShape::Disc || options.shape == ContainerShape::Annulus;
  const ContainerBounds bounds = options.bounds ? *options.bounds : bounds_round(points, round);
  switch (options.shape) {
  case ContainerShape::Disc:
    return disc(bounds, options.contact);
  case ContainerShape::Annulus:
    return annulus(bounds, options.inner_radius, options.contact);
  case ContainerShape::Channel:
    return channel(bounds, options.contact);
  default:
    return rectangle(bounds, options.contact);
  }
}

bool is_inside(const Container& container, Vec2 point) {
  if (container.period > 0) {
    return std::ranges::all_of(container.walls, [&](const Wall& wall) {
      return cross(wall.pieces[0].chord, point - wall.pieces[0].start) > 0;
    });
  }
  int turns = 0;
  for (const Wall& wall : container.walls) {
    turns += winding(wall.pieces, point);
  }
  return turns == 1;
}

} // namespace foam
