// SPDX-License-Identifier: GPL-3.0-or-later
//
// The geometry of one film: a circular arc from a to b with chord vector D = b − a, chord d = |D|
// and half-angle α, the angle between chord and tangent. α > 0 where the arc bulges to the right of
// the walk from a to b, so that it adds area to the bubble on its left.
//
//   length        l = d·f(α),   f = α/sin α
//   segment area  S = d²·g(α),  g = (α − sin α cos α)/(4 sin²α)
//
// with −π < α < π. Both functions and their derivatives are removable at α = 0, where their Taylor
// series (Abramowitz & Stegun 4.3.68 and 4.3.70; g = ¼ d(−α cot α)/dα) take over.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <numbers>

#include "geometry/host_device.h"
#include "geometry/tensor.h"
#include "geometry/vec2.h"

namespace foam {

/// f, g and their first two derivatives by α (all dimensionless).
struct ArcShape {
  double f, f1, f2;
  double g, g1, g2;
};

namespace detail {

/// Below this |α| the closed forms lose digits to cancellation and the series do not.
inline constexpr double kSeriesLimit = 0.5;

/// f and g with their derivatives by their series.
[[gnu::always_inline]] FOAM_HOST_DEVICE inline ArcShape arc_shape_by_series(double alpha) {
  // Of α^{2k}, k = 0, 1, …, in α/sin α.
  static constexpr std::array<double, 13> kLengthSeries = {1.0,
                                                           0.16666666666666666,
                                                           0.019444444444444445,
                                                           0.00205026455026455,
                                                           0.0002099867724867725,
                                                           2.1336045641601196e-05,
                                                           2.1633474427786596e-06,
                                                           2.192327134456764e-07,
                                                           2.2213930853920414e-08,
                                                           2.2507674795567867e-09,
                                                           2.280510770721821e-10,
                                                           2.3106421580996967e-11,
                                                           2.3411704028931947e-12};
  // Of α^{2k+1}, k = 0, 1, …, in ¼ d(−α cot α)/dα.
  static constexpr std::array<double, 13> kAreaSeries = {
      0.16666666666666666,    0.022222222222222223,  0.0031746031746031746,  0.0004232804232804233,
      5.344449788894233e-05,  6.493212842419191e-06, 7.674081748155823e-07,  8.885843515991871e-08,
      1.0128530932564046e-08, 1.140257560229609e-09, 1.2708537929451442e-10, 1.4047024091894931e-11,
      1.5418661310151875e-12};
  ArcShape a{};
  const double x = alpha * alpha;
  for (std::size_t i = kLengthSeries.size(); i-- > 0;) {
    const double n = 2.0 * static_cast<double>(i);
    const double cf = kLengthSeries[i];
    const double cg = kAreaSeries[i];
    a.f = a.f * x + cf;
    a.g = a.g * x + cg;
    a.g1 = a.g1 * x + (n + 1) * cg;
    if (i > 0) {
      a.f1 = a.f1 * x + n * cf;
      a.f2 = a.f2 * x + n * (n - 1) * cf;
      a.g2 = a.g2 * x + (n + 1) * n * cg;
    }
  }
  a.f1 *= alpha;
  a.g *= alpha;
  a.g2 *= alpha;
  return a;
}

} // namespace detail

/// f and g with their derivatives; −π < alpha < π (rad). Inlined, so that nobody computes those
/// that are not asked for.
[[gnu::always_inline]] FOAM_HOST_DEVICE inline ArcShape arc_shape(double alpha) {
  if (std::abs(alpha) < detail::kSeriesLimit) {
    return detail::arc_shape_by_series(alpha);
  }
  ArcShape a{};
  const double s = std::sin(alpha);
  const double c = std::cos(alpha);
  const double s2 = s * s;
  a.f = alpha / s;
  a.f1 = (s - alpha * c) / s2;
  a.f2 = (alpha * (1 + c * c) - 2 * s * c) / (s2 * s);
  a.g = (alpha - s * c) / (4 * s2);
  a.g1 = (s - alpha * c) / (2 * s2 * s);
  a.g2 = (alpha * (1 + 2 * c * c) - 3 * s * c) / (2 * s2 * s2);
  return a;
}

/// Length of the arc (cm) over a chord d (cm).
FOAM_HOST_DEVICE inline double arc_length(double chord, double alpha) {
  return chord * arc_shape(alpha).f;
}

/// Signed area (cm²) between the arc and its chord, > 0 on the left bubble's account.
FOAM_HOST_DEVICE inline double segment_area(double chord, double alpha) {
  return chord * chord * arc_shape(alpha).g;
}

/// ∫t⊗t ds along the arc with its tangent t, cm: with the unit vector u along the chord
/// d·[cos α·u⊗u + ½(f − cos α)·I].
FOAM_HOST_DEVICE inline SymmetricTensor arc_tangents(Vec2 chord, double alpha) {
  const double d = norm(chord);
  const double c = std::cos(alpha);
  return (c / d) * square(chord) + isotropic(0.5 * d * (arc_shape(alpha).f - c));
}

/// How that changes, cm. \param change of the chord, cm \param turn of α, rad
FOAM_HOST_DEVICE inline SymmetricTensor arc_tangents_change(Vec2 chord, Vec2 change, double alpha,
                                                            double turn) {
  const double d = norm(chord);
  const double growth = dot(chord, change) / d;
  const double c = std::cos(alpha);
  const double s = std::sin(alpha);
  const ArcShape shape = arc_shape(alpha);
  return (c / d) * twice_product(chord, change) -
         ((s * turn + c * growth / d) / d) * square(chord) +
         isotropic(0.5 * (growth * (shape.f - c) + d * (shape.f1 + s) * turn));
}

/// Curvature (1/cm) of the arc, with the sign of α.
FOAM_HOST_DEVICE inline double arc_curvature(double chord, double alpha) {
  return 2 * std::sin(alpha) / chord;
}

/// Unit tangent at the start of the arc, pointing into it.
FOAM_HOST_DEVICE inline Vec2 start_tangent(Vec2 chord, double alpha) {
  return rotated((1 / norm(chord)) * chord, -alpha);
}

/// The point at the fraction s ∈ [0, 1] of the arc length from its start.
FOAM_HOST_DEVICE inline Vec2 arc_point(Vec2 start, Vec2 chord, double alpha, double s) {
  const auto sinc = [](double x) { return std::abs(x) < 1e-8 ? 1.0 : std::sin(x) / x; };
  const double scale = s * sinc(alpha * s) / sinc(alpha);
  return start + scale * rotated(chord, alpha * (s - 1));
}

/// Number of straight segments that keep an arc within chord_error (cm) of its samples; at least 1.
FOAM_HOST_DEVICE inline int arc_segments(double chord, double alpha, double chord_error) {
  const double curvature = std::abs(arc_curvature(chord, alpha));
  const double ratio = 1 - chord_error * curvature;
  if (ratio >= 1) {
    return 1;
  }
  const double step = 2 * std::acos(std::max(ratio, -1.0));
  return std::max(1, static_cast<int>(std::ceil(2 * std::abs(alpha) / step)));
}

} // namespace foam
