// SPDX-License-Identifier: GPL-3.0-or-later
//
// The arc that stands for a chain of lines and arcs.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "geometry/arc.h"

namespace foam {

/// The half-angle of the arc over a chord (cm) with a given area between the two (cm²), signed as
/// segment_area() is; −π < α < π. \pre the chord is not 0
inline double half_angle_of(double chord, double area) {
  const double wanted = area / (chord * chord);
  const auto excess = [&](double alpha) { return arc_shape(alpha).g - wanted; };
  // g grows with α from −∞ to ∞: Newton's steps, halved intervals where those lead out.
  double low = -std::numbers::pi;
  double high = std::numbers::pi;
  double alpha = std::clamp(6 * wanted, -1.0, 1.0);
  for (int i = 0; i < 200; ++i) {
    const double off = excess(alpha);
    (off > 0 ? high : low) = alpha;
    const double step = alpha - off / arc_shape(alpha).g1;
    const double next = low < step && step < high ? step : 0.5 * (low + high);
    if (off == 0 || next == alpha || !(low < next && next < high)) {
      break;
    }
    alpha = next;
  }
  return alpha;
}

/// How far a point lies from the circle of an arc (cm), > 0 on its right. \param point from the
/// arc's start, cm
inline double distance_from_arc(Vec2 chord, double alpha, Vec2 point) {
  const double d = norm(chord);
  const double curvature = arc_curvature(d, alpha);
  // The circle about a + n/κ: |p − c|² − 1/κ² = (2/κ)·F, where nothing is divided by κ in the end.
  const double f =
      0.5 * curvature * dot(point, point) - dot(point, left_normal(start_tangent(chord, alpha)));
  return 2 * f / (1 + std::sqrt(std::max(0.0, 1 + 2 * curvature * f)));
}

/// A film as a chain of points, which one arc is to stand for.
class PathOfFilm {
public:
  /// Goes on by a straight line.
  void add(Vec2 line) {
    twice_polygon_ += cross(chord_, line);
    chord_ += line;
    points_.push_back(chord_);
  }
  /// Goes on by the arc through a point, both seen from where the path ends so far.
  void add_arc(Vec2 through, Vec2 to) {
    const double alpha = angle_from_to(through, to - through); // by the inscribed angle
    arcs_ += segment_area(norm(to), alpha);
    ++bent_;
    last_alpha_ = alpha;
    points_.push_back(chord_ + through);
    add(to);
  }

  Vec2 chord() const { return chord_; }
  /// Of the arc with the path's ends and the area that the path has beside it. \pre the ends differ
  double half_angle() const {
    const bool single_arc = bent_ == 1 && points_.size() == 2;
    return single_arc ? last_alpha_ : half_angle_of(norm(chord_), 0.5 * twice_polygon_ + arcs_);
  }
  /// How far the path's points lie from the arc, cm.
  double misfit(double alpha) const {
    double largest = 0;
    for (const Vec2 p : points_) {
      largest = std::max(largest, std::abs(distance_from_arc(chord_, alpha, p)));
    }
    return largest;
  }

private:
  Vec2 chord_;
  double twice_polygon_ = 0;
  double arcs_ = 0;
  double last_alpha_ = 0;
  int bent_ = 0;
  std::vector<Vec2> points_;
};

} // namespace foam
