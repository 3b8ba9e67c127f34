// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolver/curve.h"

#include <algorithm>
#include <cmath>

#include "geometry/arc.h"

namespace foam::evolver {
namespace {

/// Of a length that belongs to the curve.
constexpr double kSame = 1e-9;
constexpr int kMostSteps = 60;

template <class Holds> bool holds_along(const Curve& curve, const Holds& holds) {
  return std::ranges::all_of(std::initializer_list<double>{-3, -2, -1, -0.5, 0.5, 1, 2, 3},
                             [&](double way) { return holds(curve.at(way * curve.scale())); });
}

} // namespace

double Curve::scale() const {
  return curvature != 0 ? 1 / std::abs(curvature) : 1 + norm(point);
}

double Curve::distance(Vec2 from) const {
  const Vec2 r = from - point;
  const double f = dot(left_normal(tangent), r) - 0.5 * curvature * dot(r, r);
  return 2 * f / (1 + std::sqrt(std::max(0.0, 1 - 2 * curvature * f)));
}

Vec2 Curve::normal(Vec2 near) const {
  const Vec2 gradient = left_normal(tangent) - curvature * (near - point);
  return (1 / norm(gradient)) * gradient;
}

Vec2 Curve::at(double way) const {
  const double half_turn = 0.5 * curvature * way;
  const double chord = half_turn == 0 ? way : way * std::sin(half_turn) / half_turn;
  return point + chord * rotated(tangent, half_turn);
}

std::optional<Curve> curve_of_formula(const std::function<Jet(Vec2)>& formula, Vec2 near) {
  Vec2 p = near;
  for (int i = 0; i < kMostSteps; ++i) {
    const Jet f = formula(p);
    const Vec2 step = (f.value / dot(f.gradient, f.gradient)) * f.gradient;
    p -= step;
    if (!(norm(step) > 1e-15 * (1 + norm(p)))) {
      break;
    }
  }
  const Jet f = formula(p);
  const double slope = norm(f.gradient);
  const Vec2 normal = (1 / slope) * f.gradient;
  const Vec2 tangent{normal.y, -normal.x};
  const double bend = f.xx * tangent.x * tangent.x + 2 * f.xy * tangent.x * tangent.y +
                      f.yy * tangent.y * tangent.y;
  const Curve curve{p, tangent, -bend / slope};
  const auto vanishes = [&](Vec2 at) {
    return std::abs(formula(at).value) <= kSame * slope * curve.scale();
  };
  if (!std::isfinite(curve.curvature) || !vanishes(p) || !holds_along(curve, vanishes)) {
    return std::nullopt;
  }
  return curve;
}

std::optional<Curve> curve_of_parameter(const std::function<Jet(double)>& x,
                                        const std::function<Jet(double)>& y, double parameter) {
  const Jet jx = x(parameter);
  const Jet jy = y(parameter);
  const Vec2 velocity{jx.gradient.x, jy.gradient.x};
  const double speed = norm(velocity);
  const Curve curve{{jx.value, jy.value},
                    (1 / speed) * velocity,
                    cross(velocity, Vec2{jx.xx, jy.xx}) / (speed * speed * speed)};
  if (!std::isfinite(curve.curvature)) {
    return std::nullopt;
  }
  const double scale = curve.scale();
  for (const double way : {-3.0, -2.0, -1.0, -0.5, 0.5, 1.0, 2.0, 3.0}) {
    const double there = parameter + way * scale / speed;
    if (!(std::abs(curve.distance({x(there).value, y(there).value})) <= kSame * scale)) {
      return std::nullopt;
    }
  }
  return curve;
}

std::vector<Vec2> crossings(const Curve& a, const Curve& b) {
  if (a.curvature == 0 && b.curvature == 0) {
    const double sine = cross(a.tangent, b.tangent);
    if (std::abs(sine) < kSame) {
      return {};
    }
    return {a.point + (cross(b.point - a.point, b.tangent) / sine) * a.tangent};
  }
  // A circle's crossings with a line, which is that of equal powers if the other is a circle too.
  const Curve& circle = a.curvature != 0 ? a : b;
  const Curve& other = a.curvature != 0 ? b : a;
  const Vec2 centre = circle.centre();
  const double radius = 1 / std::abs(circle.curvature);
  Vec2 foot;
  Vec2 along;
  if (other.curvature == 0) {
    foot = other.nearest(centre);
    along = other.tangent;
  } else {
    const Vec2 d = other.centre() - centre;
    const double between = norm(d);
    const double r = 1 / other.curvature;
    foot = centre + (0.5 * (1 + (radius * radius - r * r) / (between * between))) * d;
    along = (1 / between) * left_normal(d);
  }
  const double half = radius * radius - dot(foot - centre, foot - centre);
  if (!(half > kSame * radius * radius)) {
    return {};
  }
  return {foot + std::sqrt(half) * along, foot - std::sqrt(half) * along};
}

} // namespace foam::evolver
