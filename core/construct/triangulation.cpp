// SPDX-License-Identifier: GPL-3.0-or-later
#include "construct/triangulation.h"

#include "base/error.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <string>
#include <tuple>

namespace foam {
namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<Corner, Kernel>;
/// Whether a face lies outside.
using Face = CGAL::Triangulation_face_base_with_info_2<bool, Kernel>;
using Structure = CGAL::Triangulation_data_structure_2<Vertex, Face>;
using Delaunay = CGAL::Delaunay_triangulation_2<Kernel, Structure>;
using Site = std::pair<Kernel::Point_2, Corner>;

bool less(const Triangle& s, const Triangle& t) {
  const auto key = [](const Triangle& u) {
    return std::tuple(u[0].point, u[1].point, u[2].point, u[1].copy.x, u[1].copy.y, u[2].copy.x,
                      u[2].copy.y);
  };
  return key(s) < key(t);
}

/// The triangle that begins with corner k and lies where that is in the cell.
Triangle seen_from(const Triangle& t, std::size_t k) {
  Triangle seen{t[k], t[(k + 1) % 3], t[(k + 2) % 3]};
  for (Corner& corner : seen) {
    corner.copy = corner.copy - t[k].copy;
  }
  return seen;
}

/// The corner that comes first in the triangle's name, which all its copies share.
std::size_t first_corner(const Triangle& t) {
  std::size_t first = 0;
  for (std::size_t k = 1; k < 3; ++k) {
    if (less(seen_from(t, k), seen_from(t, first))) {
      first = k;
    }
  }
  return first;
}

Triangle corners(Delaunay::Face_handle face) {
  return {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()};
}

/// The outline of a triangulation in the plane: its hull, from which flat triangles are carved off.
///
/// A jittered grid's hull has edges many spacings long, behind them slivers. A triangle on the
/// outline that sees its outer edge under an angle whose cosine is below kFlat is given to the
/// outside, the flattest first, as long as no bubble is pinched off.
class Outline {
public:
  Outline(Delaunay& delaunay, std::size_t points) : delaunay_(delaunay), on_outline_(points) {
    for (const auto face : delaunay.all_face_handles()) {
      face->info() = delaunay.is_infinite(face);
    }
    const auto infinite = delaunay.infinite_vertex();
    const auto first = delaunay.incident_faces(infinite);
    auto face = first;
    do {
      const int k = face->index(infinite);
      on_outline_[point(face, Delaunay::cw(k))] = true;
      consider(face, k);
    } while (++face != first);
  }

  /// Marks all faces outside.
  void carve() {
    while (!flat_.empty()) {
      const auto [face, apex] = flat_.begin()->second;
      flat_.erase(flat_.begin());
      if (on_outline_[point(face, apex)]) {
        continue;
      }
      on_outline_[point(face, apex)] = true;
      face->info() = true;
      consider(face, Delaunay::cw(apex));
      consider(face, Delaunay::ccw(apex));
    }
  }

private:
  static constexpr double kFlat = -2.0 / 3;

  static std::size_t point(Delaunay::Face_handle face, int k) {
    return face->vertex(k)->info().point.place();
  }

  static Vec2 position(Delaunay::Face_handle face, int k) {
    const auto& p = face->vertex(k)->point();
    return {p.x(), p.y()};
  }

  /// Notes the triangle across edge k of a face outside if it is flat.
  void consider(Delaunay::Face_handle outside, int k) {
    const auto face = outside->neighbor(k);
    const int apex = delaunay_.mirror_index(outside, k);
    const int from = Delaunay::ccw(apex);
    const int to = Delaunay::cw(apex);
    const Vec2 a = position(face, from) - position(face, apex);
    const Vec2 b = position(face, to) - position(face, apex);
    const double cosine = dot(a, b) / (norm(a) * norm(b));
    if (cosine < kFlat) {
      flat_.emplace(std::tuple(cosine, point(face, from), point(face, to)), std::pair(face, apex));
    }
  }

  Delaunay& delaunay_;
  std::vector<bool> on_outline_;
  std::map<std::tuple<double, std::size_t, std::size_t>, std::pair<Delaunay::Face_handle, int>>
      flat_;
};

/// CGAL breaks ties between cocircular points by their lexicographic order (O. Devillers,
/// M. Teillaud, SODA 2003), which a translation without rounding does not change.
class Periodic {
public:
  explicit Periodic(const TorusPoints& points) : points_(points) {}

  /// The points in the cell and those copies that lie within `rim` of it.
  std::vector<Site> sites(double rim) const {
    const Lattice& lattice = points_.snapped_lattice;
    // In coordinates, of which one counts a cell's height.
    const Vec2 pad{rim * norm(lattice.second) / lattice.area(),
                   rim * norm(lattice.first) / lattice.area()};
    const auto nx = static_cast<Index>(std::ceil(pad.x));
    const auto ny = static_cast<Index>(std::ceil(pad.y));
    std::vector<Site> result;
    for (Index y = -ny; y <= ny; ++y) {
      for (Index x = -nx; x <= nx; ++x) {
        for (const Bubble b : Slots<Bubble>(static_cast<Index>(points_.snapped.size()))) {
          const Corner corner{b, {x, y}};
          const Vec2 p = place(corner);
          const Vec2 c = lattice.coordinates(p);
          if (within(c.x, pad.x) && within(c.y, pad.y)) {
            result.emplace_back(Kernel::Point_2(p.x, p.y), corner);
          }
        }
      }
    }
    return result;
  }

  /// One copy of every triangle; nothing if the rim is too narrow to be sure of all.
  std::optional<std::vector<Triangle>> triangulate(double rim) const {
    const auto padded = sites(rim);
    const Delaunay delaunay(padded.begin(), padded.end());
    std::vector<Triangle> triangles;
    for (const auto face : delaunay.finite_face_handles()) {
      const Triangle t = corners(face);
      const std::size_t first = first_corner(t);
      if (t[first].copy == Wrap{}) {
        if (rim < widest_circle() && !(circumdiameter(t) < rim)) {
          return std::nullopt;
        }
        triangles.push_back(seen_from(t, first));
      }
    }
    if (triangles.size() != 2 * points_.snapped.size()) {
      return std::nullopt;
    }
    return triangles;
  }

  /// No circle without a point of a lattice in it is wider than the longer diagonal of the cell of
  /// its shortest periods; in a rectangle it may be as wide. A hundredth more, for rounding.
  double widest_circle() const {
    const auto& [origin, first, second] = points_.snapped_lattice;
    return 1.01 * std::max(norm(first + second), norm(first - second));
  }

private:
  static bool within(double coordinate, double pad) {
    return coordinate >= -pad && coordinate <= 1 + pad;
  }

  Vec2 place(const Corner& corner) const {
    return points_.snapped[corner.point] + points_.snapped_lattice.period(corner.copy);
  }

  double circumdiameter(const Triangle& t) const {
    const Vec2 a = place(t[1]) - place(t[0]);
    const Vec2 b = place(t[2]) - place(t[0]);
    return norm(a) * norm(b) * norm(b - a) / cross(a, b);
  }

  const TorusPoints& points_;
};

/// The cell of a lattice at 0 in which a place at most one cell away lies, without rounding.
Wrap exact_cell_of(Vec2 place, const Lattice& lattice) {
  const auto left_of = [&](Vec2 from, Vec2 along) {
    const auto point = [](Vec2 p) { return Kernel::Point_2(p.x, p.y); };
    return CGAL::left_turn(point(from), point(from + along), point(place));
  };
  const auto& [origin, first, second] = lattice;
  const auto cell = [](bool before, bool after) { return before ? -1 : (after ? 1 : 0); };
  return {cell(left_of(origin, second), !left_of(first, second)),
          cell(left_of(first, -first), !left_of(second + first, -first))};
}

} // namespace

std::vector<Triangle> triangulate_plane(std::span<const Vec2> points) {
  std::vector<Site> sites;
  sites.reserve(points.size());
  for (const Vec2 p : points) {
    const Bubble b(static_cast<Index>(sites.size()));
    sites.emplace_back(Kernel::Point_2(p.x, p.y), Corner{b, {}});
  }
  Delaunay delaunay(sites.begin(), sites.end());
  std::vector<Triangle> triangles;
  if (delaunay.dimension() < 2) {
    return triangles;
  }
  Outline(delaunay, points.size()).carve();
  for (const auto face : delaunay.finite_face_handles()) {
    if (face->info()) {
      continue;
    }
    const Triangle t = corners(face);
    triangles.push_back(seen_from(t, first_corner(t)));
    for (std::size_t k = 0; k < 3; ++k) {
      if (face->neighbor(static_cast<int>(k))->info()) {
        triangles.push_back({Corner{kWorld, {}}, t[(k + 2) % 3], t[(k + 1) % 3]});
      }
    }
  }
  std::sort(triangles.begin(), triangles.end(), less);
  return triangles;
}

TorusPoints torus_points(std::span<const Vec2> points, const Lattice& lattice) {
  TorusPoints result;
  result.reduced = reduced(lattice);
  const Lattice& cell = result.reduced.lattice;
  const double longest = std::max({std::abs(cell.first.x), std::abs(cell.first.y),
                                   std::abs(cell.second.x), std::abs(cell.second.y)});
  const double unit = std::ldexp(1.0, std::ilogb(longest) - 47);
  const auto snap = [&](Vec2 v) { return Vec2{std::round(v.x / unit), std::round(v.y / unit)}; };
  result.snapped_lattice = {{}, snap(cell.first), snap(cell.second)};
  for (const Vec2 point : points) {
    constexpr double kFarthest = 1e9; // periods: a Wrap counts few more
    const Vec2 away = cell.coordinates(point);
    if (!(std::max(std::abs(away.x), std::abs(away.y)) < kFarthest)) {
      throw FoamError("point " + std::to_string(result.position.size()) + " at " + number(point) +
                      " lies too many periods from the torus's cell");
    }
    const Vec2 position = point - cell.period(cell.cell_of(point));
    const Vec2 snapped = snap(position - cell.origin);
    const Wrap beyond = exact_cell_of(snapped, result.snapped_lattice); // by rounding
    result.position.push_back(position - cell.period(beyond));
    result.snapped.push_back(snapped - result.snapped_lattice.period(beyond));
  }
  return result;
}

std::vector<Triangle> triangulate_torus(const TorusPoints& points) {
  const Periodic periodic(points);
  const double count = static_cast<double>(points.snapped.size());
  const double spacing = std::sqrt(points.snapped_lattice.area() / count);
  const double enough = periodic.widest_circle();
  for (double rim = std::min(5 * spacing, enough);; rim = std::min(2 * rim, enough)) {
    if (auto triangles = periodic.triangulate(rim)) {
      for (Triangle& t : *triangles) {
        for (Corner& corner : t) {
          corner.copy = points.reduced.original(corner.copy);
        }
      }
      std::sort(triangles->begin(), triangles->end(), less);
      return *std::move(triangles);
    }
    if (rim == enough) {
      throw FoamError("the points cannot be triangulated on the torus");
    }
  }
}

} // namespace foam
