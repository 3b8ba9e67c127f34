// SPDX-License-Identifier: GPL-3.0-or-later
#include "geometry/arc.h"

#include <gtest/gtest.h>

#include <complex>
#include <limits>
#include <vector>

namespace foam {
namespace {

constexpr double kPi = std::numbers::pi;
using Complex = std::complex<long double>;

Complex f(Complex z) {
  return z / std::sin(z);
}
Complex f1(Complex z) {
  return (std::sin(z) - z * std::cos(z)) / (std::sin(z) * std::sin(z));
}
Complex g(Complex z) {
  return (z - std::sin(z) * std::cos(z)) / (4.0L * std::sin(z) * std::sin(z));
}
Complex g1(Complex z) {
  return (std::sin(z) - z * std::cos(z)) / (2.0L * std::sin(z) * std::sin(z) * std::sin(z));
}

/// The derivative by a complex step, free of cancellation (W. Squire, G. Trapp, SIAM Rev. 1998).
template <class Function> double derivative(Function function, double x) {
  constexpr long double kStep = 1e-30L;
  return static_cast<double>(function(Complex(x, kStep)).imag() / kStep);
}

template <class Function> double value(Function function, double x) {
  return static_cast<double>(function(Complex(x, 0)).real());
}

void expect_relative(double actual, double expected, double tolerance, double alpha) {
  EXPECT_NEAR(actual, expected, tolerance * std::max(1.0, std::abs(expected)))
      << "at alpha = " << alpha;
}

TEST(Arc, ShapeAgreesWithClosedFormsAndTheirDerivatives) {
  for (double alpha = 0.1; alpha < 3.0; alpha += 0.0371) {
    for (const double x : {alpha, -alpha}) {
      const ArcShape shape = arc_shape(x);
      expect_relative(shape.f, value(f, x), 1e-14, x);
      expect_relative(shape.f1, derivative(f, x), 1e-13, x);
      expect_relative(shape.f2, derivative(f1, x), 1e-12, x);
      expect_relative(shape.g, value(g, x), 1e-14, x);
      expect_relative(shape.g1, derivative(g, x), 1e-13, x);
      expect_relative(shape.g2, derivative(g1, x), 1e-12, x);
    }
  }
}

TEST(Arc, ShapeAgreesWithTaylorSeriesNearZero) {
  for (const double x : {-1e-3, 0.0, 1e-9, 2e-3}) {
    const double x2 = x * x;
    const ArcShape shape = arc_shape(x);
    EXPECT_DOUBLE_EQ(shape.f, 1 + x2 / 6 + 7 * x2 * x2 / 360);
    EXPECT_DOUBLE_EQ(shape.f1, x * (1.0 / 3 + 7 * x2 / 90 + 31 * x2 * x2 / 2520));
    EXPECT_DOUBLE_EQ(shape.f2, 1.0 / 3 + 7 * x2 / 30 + 31 * x2 * x2 / 504);
    EXPECT_DOUBLE_EQ(shape.g, x * (1.0 / 6 + x2 / 45 + x2 * x2 / 315));
    EXPECT_DOUBLE_EQ(shape.g1, 1.0 / 6 + x2 / 15 + x2 * x2 / 63);
    EXPECT_DOUBLE_EQ(shape.g2, x * (2.0 / 15 + 4 * x2 / 63 + 4 * x2 * x2 / 225));
  }
}

TEST(Arc, SeriesAndClosedFormsMeet) {
  const double above = detail::kSeriesLimit;
  const double below = std::nextafter(above, 0.0);
  const ArcShape closed = arc_shape(above);
  const ArcShape series = arc_shape(below);
  EXPECT_NEAR(series.f, closed.f, 1e-15);
  EXPECT_NEAR(series.f1, closed.f1, 1e-14);
  EXPECT_NEAR(series.f2, closed.f2, 1e-13);
  EXPECT_NEAR(series.g, closed.g, 1e-15);
  EXPECT_NEAR(series.g1, closed.g1, 1e-14);
  EXPECT_NEAR(series.g2, closed.g2, 1e-13);
}

TEST(Arc, CircularArcsOfUnitRadius) {
  // A straight chord, a quarter circle, a semicircle, three quarters of a circle.
  EXPECT_DOUBLE_EQ(arc_length(2, 0), 2);
  EXPECT_DOUBLE_EQ(segment_area(2, 0), 0);
  EXPECT_DOUBLE_EQ(arc_length(std::sqrt(2.0), kPi / 4), kPi / 2);
  EXPECT_NEAR(segment_area(std::sqrt(2.0), kPi / 4), kPi / 4 - 0.5, 1e-15);
  EXPECT_DOUBLE_EQ(arc_length(2, kPi / 2), kPi);
  EXPECT_DOUBLE_EQ(segment_area(2, kPi / 2), kPi / 2);
  EXPECT_DOUBLE_EQ(arc_length(std::sqrt(2.0), 3 * kPi / 4), 3 * kPi / 2);
  EXPECT_DOUBLE_EQ(segment_area(std::sqrt(2.0), 3 * kPi / 4), 3 * kPi / 4 + 0.5);
  for (const double alpha : {0.3, 1.0, 2.5}) {
    const double chord = 2 * std::sin(alpha);
    EXPECT_NEAR(arc_curvature(chord, alpha), 1, 1e-15);
    EXPECT_NEAR(arc_length(chord, alpha), 2 * alpha, 1e-14);
    EXPECT_NEAR(arc_length(chord, -alpha), 2 * alpha, 1e-14);
    EXPECT_NEAR(segment_area(chord, -alpha), -(alpha - 0.5 * std::sin(2 * alpha)), 1e-14);
  }
}

TEST(Arc, PositiveHalfAngleBulgesToTheRight) {
  const Vec2 middle = arc_point({0, 0}, {2, 0}, kPi / 2, 0.5);
  EXPECT_NEAR(middle.x, 1, 1e-15);
  EXPECT_NEAR(middle.y, -1, 1e-15);
  const Vec2 tangent = start_tangent({2, 0}, kPi / 2);
  EXPECT_NEAR(tangent.x, 0, 1e-15);
  EXPECT_NEAR(tangent.y, -1, 1e-15);
}

TEST(Arc, PointsLieOnTheCircleInStepWithLength) {
  const Vec2 start{3, -2};
  const Vec2 chord{0.8, 0.6};
  for (const double alpha : {-2.8, -kPi / 2, -1e-3, 1e-9, 0.4, 1.7, 3.0}) {
    const double radius = 1 / arc_curvature(1, alpha);
    const Vec2 tangent = start_tangent(chord, alpha);
    const Vec2 centre = start + radius * left_normal(tangent);
    for (int i = 0; i <= 8; ++i) {
      const double s = i / 8.0;
      const Vec2 point = arc_point(start, chord, alpha, s);
      if (std::abs(alpha) > 0.1) {
        EXPECT_NEAR(norm(point - centre), std::abs(radius), 1e-14 * std::abs(radius));
      }
      // From the inscribed angle: a chord over the fraction s has half-angle s·α.
      EXPECT_NEAR(arc_length(norm(point - start), s * alpha), s * arc_length(1, alpha), 1e-13);
    }
    EXPECT_NEAR(norm(arc_point(start, chord, alpha, 0) - start), 0, 1e-15);
    EXPECT_NEAR(norm(arc_point(start, chord, alpha, 1) - (start + chord)), 0, 1e-15);
  }
}

TEST(Arc, SegmentsAreAsFewAsTheChordErrorAllows) {
  for (const double alpha : {0.2, -1.0, 2.0, 3.1}) {
    const double radius = 1 / std::abs(arc_curvature(1, alpha));
    for (const double error : {1e-1, 1e-3, 1e-5}) {
      const int n = arc_segments(1, alpha, error);
      const auto sagitta = [&](int k) { return radius * (1 - std::cos(std::abs(alpha) / k)); };
      EXPECT_LE(sagitta(n), error * (1 + 1e-9)) << alpha;
      if (n > 1) {
        EXPECT_GT(sagitta(n - 1), error) << alpha;
      }
    }
  }
  EXPECT_EQ(arc_segments(1, 0, 1e-6), 1);
}

} // namespace
} // namespace foam
