// SPDX-License-Identifier: GPL-3.0-or-later
#include "construct/from_polygons.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <string>
#include <unordered_map>

#include "base/error.h"
#include "geometry/bounds.h"

namespace foam {
namespace {

using std::to_string;

/// Part of the square of the foam's extent that is as good as no area.
constexpr double kNoArea = 1e-12;

/// Part of the foam's extent by which points in the same place may differ, by rounding.
constexpr double kSamePlace = 1e-9;

class PolygonSides {
public:
  PolygonSides(std::span<const Vec2> points, std::span<const Polygon> polygons)
      : polygons_(polygons) {
    join_points(points);
    for (std::size_t cell = 0; cell < polygons.size(); ++cell) {
      add(static_cast<Index>(cell));
    }
  }

  Division run() {
    if (polygons_.empty()) {
      throw FoamError("there are no polygons");
    }
    for (const Polygon& polygon : polygons_) {
      division_.ids.push_back(polygon.cell);
    }
    for (const auto& [key, cell] : left_) {
      const auto [from, to] = ends(key);
      const auto other = left_.find(key_of(to, from));
      const bool outside = other == left_.end();
      if (outside || from < to) {
        division_.sides.push_back({from, to, cell, outside ? Index{kNone} : other->second, {}});
      }
    }
    // In an order of their own, whatever that of the map.
    std::ranges::sort(division_.sides, {}, [](const Side& s) { return std::pair(s.from, s.to); });
    check_outline();
    return std::move(division_);
  }

private:
  static std::uint64_t key_of(Index from, Index to) {
    return (static_cast<std::uint64_t>(from) << 32) | static_cast<std::uint64_t>(to);
  }
  static std::pair<Index, Index> ends(std::uint64_t key) {
    return {static_cast<Index>(key >> 32), static_cast<Index>(key & 0xffffffff)};
  }
  std::string number_of(Index cell) const { return to_string(polygons_[place_of(cell)].cell); }
  std::string name(Index cell) const { return "cell " + number_of(cell); }

  /// Points in the same place are one, but for rounding.
  void join_points(std::span<const Vec2> points) {
    for (std::size_t i = 0; i < points.size(); ++i) {
      if (!std::isfinite(points[i].x + points[i].y)) {
        throw FoamError("point " + to_string(i) + " is at " + number(points[i]));
      }
    }
    const Bounds bounds = bounds_of(points);
    const double extent = points.empty() ? 0 : norm(bounds.extent());
    no_area_ = kNoArea * extent * extent;
    const double near = kSamePlace * extent;
    std::unordered_map<std::uint64_t, std::vector<Index>> cells; // of a grid, a few `near` wide
    const auto cell_of = [&](Vec2 q) {
      const auto count = [&](double x) {
        return near > 0 ? static_cast<std::uint64_t>(std::max(0.0, x / (4 * near))) : 0;
      };
      return (count(q.x) << 32) ^ count(q.y);
    };
    const auto joined = [&](Vec2 p) {
      for (const double x : {-near, near}) {
        for (const double y : {-near, near}) {
          for (const Index other : cells[cell_of(p - bounds.low + Vec2{x, y})]) {
            if (norm(point(other) - p) <= near) {
              return other;
            }
          }
        }
      }
      return Index{kNone};
    };
    for (const Vec2 p : points) {
      Index found = joined(p);
      if (found == kNone) {
        found = static_cast<Index>(division_.points.size());
        division_.points.push_back(p);
        cells[cell_of(p - bounds.low)].push_back(found);
      }
      joined_.push_back(found);
    }
  }

  Vec2 point(Index p) const { return division_.points[place_of(p)]; }

  double area(const std::vector<Index>& loop) const {
    double twice = 0;
    for (std::size_t k = 1; k + 1 < loop.size(); ++k) {
      twice += cross(point(loop[k]) - point(loop[0]), point(loop[k + 1]) - point(loop[0]));
    }
    return 0.5 * twice;
  }

  void add(Index cell) {
    std::vector<Index> loop;
    for (const Index p : polygons_[place_of(cell)].points) {
      if (p < 0 || place_of(p) >= joined_.size()) {
        throw FoamError(name(cell) + " has point " + to_string(p) + ", which does not exist");
      }
      if (loop.empty() || loop.back() != joined_[place_of(p)]) {
        loop.push_back(joined_[place_of(p)]);
      }
    }
    while (loop.size() > 1 && loop.back() == loop.front()) {
      loop.pop_back();
    }
    const double signed_area = area(loop);
    if (!(std::abs(signed_area) > no_area_)) {
      throw FoamError(name(cell) + " encloses no area: it has " + to_string(loop.size()) +
                      " different points, and an area of " + number(signed_area));
    }
    if (signed_area < 0) {
      std::ranges::reverse(loop);
    }
    for (std::size_t k = 0; k < loop.size(); ++k) {
      const Index from = loop[k];
      const Index to = loop[(k + 1) % loop.size()];
      const auto [other, is_first] = left_.emplace(key_of(from, to), cell);
      if (!is_first) {
        throw FoamError(name(other->second) + " and " + name(cell) +
                        " overlap: both lie on the same side of the line from " +
                        number(point(from)) + " to " + number(point(to)));
      }
    }
  }

  /// The outline's next side: the first one, counter-clockwise, from the way back. So the outside
  /// stays on the right where the outline comes to a point more than once.
  std::size_t next_in_outline(const Side& side, const std::vector<std::size_t>& leaving) const {
    const Vec2 back = point(side.from) - point(side.to);
    return *std::ranges::min_element(leaving, {}, [&](std::size_t s) {
      const double turn = angle_from_to(back, point(division_.sides[s].to) - point(side.to));
      return turn < 0 ? turn + 2 * std::numbers::pi : turn;
    });
  }

  /// The sides that one polygon alone has are one loop, round all of them.
  void check_outline() const {
    std::unordered_map<Index, std::vector<std::size_t>> leaving; // the outline's sides, by point
    for (std::size_t s = 0; s < division_.sides.size(); ++s) {
      if (division_.sides[s].right == kNone) {
        leaving[division_.sides[s].from].push_back(s);
      }
    }
    std::vector<bool> seen(division_.sides.size(), false);
    std::vector<std::vector<Index>> loops;
    std::vector<std::set<Index>> cells;
    for (std::size_t first = 0; first < division_.sides.size(); ++first) {
      if (division_.sides[first].right != kNone || seen[first]) {
        continue;
      }
      std::vector<Index>& loop = loops.emplace_back();
      std::set<Index>& beside = cells.emplace_back();
      for (std::size_t s = first; !seen[s];
           s = next_in_outline(division_.sides[s], leaving.at(division_.sides[s].to))) {
        seen[s] = true;
        loop.push_back(division_.sides[s].from);
        beside.insert(division_.sides[s].left);
      }
    }
    if (loops.empty()) {
      throw FoamError("the polygons have no outline: they overlap");
    }
    const auto largest = static_cast<std::size_t>(
        std::ranges::max_element(loops, {}, [&](const auto& loop) { return area(loop); }) -
        loops.begin());
    for (std::size_t k = 0; k < loops.size(); ++k) {
      if (k != largest) {
        const double enclosed = area(loops[k]);
        throw FoamError(
            names(cells[k]) +
            (enclosed > no_area_ ? " do not hang together with the others"
             : enclosed < -no_area_
                 ? " leave a gap or a hole between them"
                 : " do not meet side by side: a corner of one lies on a side of another"));
      }
    }
  }

  std::string names(const std::set<Index>& cells) const {
    constexpr std::size_t kMost = 6;
    std::string text = cells.size() == 1 ? "cell " : "cells ";
    std::size_t told = 0;
    for (const Index cell : cells) {
      if (told == kMost) {
        return text + " and " + to_string(cells.size() - kMost) + " more";
      }
      text += (told++ == 0 ? "" : ", ") + number_of(cell);
    }
    return text;
  }

  std::span<const Polygon> polygons_;
  Division division_;
  std::vector<Index> joined_; ///< of each point of the input, its number among the different ones
  double no_area_ = 0;
  std::unordered_map<std::uint64_t, Index>
      left_; ///< cell on the left of the way between two points
};

} // namespace

DivisionFoam build_from_polygons(std::span<const Vec2> points, std::span<const Polygon> polygons,
                                 DivisionOutline outline, double surface_tension) {
  return foam_of_division(PolygonSides(points, polygons).run(), outline, surface_tension);
}

} // namespace foam
