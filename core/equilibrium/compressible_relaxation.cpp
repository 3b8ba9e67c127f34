// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/compressible_relaxation.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>

#include "physics/step_limits.h"
#include "physics/swap_rule.h"
#include "topology/operations.h"

namespace foam {
namespace {

constexpr int kSweeps = 160;
constexpr int kSweepsBetweenSwaps = 3;
constexpr int kSweepsBetweenPressures = 5;
constexpr double kStiffness = 16;       // bulk modulus of a bubble's gas, in units of T/√A^τ
constexpr double kEmptiest = 0.05;      // A/A^τ below which the gas gets no harder
constexpr double kSmallestLength = 0.1; // of a film, of the T1 length
constexpr double kLargestAngle = std::numbers::pi / 3;
constexpr double kAtRest =
    1e-3; // largest move of a foam that is at rest, of a junction's shortest film

class Relaxation {
public:
  Relaxation(Foam& foam, double smallest_length)
      : foam_(foam), tension_(foam.reference_tension()), area_(foam.pressure.size()),
        smallest_length_(smallest_length) {}

  void measure_areas() {
    for (const Bubble b : foam_.bubble_slots()) {
      if (foam_.has_bubble(b)) {
        area_[b] = foam_.area(b);
      }
    }
  }

  /// Method of multipliers: the gas at its target area takes over a part of the pressure.
  void update_pressures() {
    for (const Bubble b : foam_.bubble_slots()) {
      if (foam_.has_bubble(b)) {
        const double x = area_[b] / foam_.target_area[b];
        foam_.pressure[b] += bulk_modulus(b) * (1 - std::clamp(x, 0.0, 2.0));
      }
    }
  }

  /// \returns the largest move of a junction, relative to its shortest film.
  double sweep() {
    double largest = 0;
    for (const Junction j : foam_.junction_slots()) {
      if (foam_.moves(j)) {
        largest = std::max(largest, move(j));
      }
    }
    for (const Film f : foam_.film_slots()) {
      if (foam_.bends(f)) {
        bend(f);
      }
    }
    return largest;
  }

private:
  /// A/A^τ, kept away from 0.
  double filling(Bubble b) const { return std::max(area_[b] / foam_.target_area[b], kEmptiest); }

  double bulk_modulus(Bubble b) const {
    return kStiffness * tension_ / std::sqrt(foam_.target_area[b]);
  }

  double pressure(Bubble b) const {
    if (b.is_outside()) {
      return foam_.pressure_of(b);
    }
    const double x = filling(b);
    return foam_.pressure[b] + bulk_modulus(b) * (x < 1 ? 1 / x - 1 : 1 - x);
  }

  /// −dp/dA
  double stiffness(Bubble b) const {
    if (b.is_outside()) {
      return 0;
    }
    const double x = filling(b);
    return bulk_modulus(b) / foam_.target_area[b] * (x < 1 ? 1 / (x * x) : 1);
  }

  /// One step of Newton's method in the position. The matrix is that of the stretched films and of
  /// the gas, without what could make it indefinite.
  double move(Junction junction) {
    const auto& halves = foam_.junction_half[junction];
    std::array<Vec2, 3> chord;
    std::array<double, 3> bulge{};  // segment area over d², on the left bubble's account
    std::array<Bubble, 3> bubble{}; // left of halves[k]: between it and the next
    Vec2 force;
    double stretch = 0;
    double shortest = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      chord[k] = foam_.chord(halves[k]);
      bubble[k] = foam_.left(halves[k]);
      const ArcShape shape = arc_shape(foam_.half_angle(halves[k]));
      const double tension = foam_.tension(halves[k].film());
      bulge[k] = shape.g;
      const double d = norm(chord[k]);
      shortest = std::min(shortest, d);
      force += (tension * shape.f / d) * chord[k];
      stretch += tension * shape.f / d;
    }
    std::array<double, 3> matrix{stretch, 0, stretch}; // xx, xy, yy
    for (std::size_t k = 0; k < 3; ++k) {
      const Vec2 slope = area_slope(chord, bulge, k);
      force += pressure(bubble[k]) * slope;
      const double hardness = stiffness(bubble[k]);
      matrix[0] += hardness * slope.x * slope.x;
      matrix[1] += hardness * slope.x * slope.y;
      matrix[2] += hardness * slope.y * slope.y;
    }
    const double determinant = matrix[0] * matrix[2] - matrix[1] * matrix[1];
    Vec2 step{(matrix[2] * force.x - matrix[1] * force.y) / determinant,
              (matrix[0] * force.y - matrix[1] * force.x) / determinant};
    for (std::size_t k = 0; k < 3; ++k) { // a film that is not swapped turns rather than vanishes
      const double d = norm(chord[k]);
      const double closing = dot(step, chord[k]);
      if (d < smallest_length_ && closing > 0) {
        step -= (closing / (d * d)) * chord[k];
      }
    }
    const double length = norm(step);
    if (length > kLargestMove * shortest) {
      step = (kLargestMove * shortest / length) * step;
    }
    foam_.position[junction] += step;
    std::array<double, 3> bulge_change{}; // of the segments' areas
    for (std::size_t k = 0; k < 3; ++k) {
      bulge_change[k] = bulge[k] * dot(step, step - 2 * chord[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (!bubble[k].is_outside()) {
        area_[bubble[k]] +=
            0.5 * cross(step, chord[k] - chord[next]) + bulge_change[k] - bulge_change[next];
      }
    }
    return std::min(length / shortest, kLargestMove);
  }

  /// One step of Newton's method in the half-angle.
  void bend(Film film) {
    double& alpha = foam_.film_angle[film];
    const Bubble left = foam_.left(film.half());
    const Bubble right = foam_.right(film.half());
    const double tension = foam_.tension(film);
    const double d = norm(foam_.chord(film.half()));
    const ArcShape shape = arc_shape(alpha);
    const double area_slope = d * d * shape.g1;
    const double torque = (pressure(left) - pressure(right)) * area_slope - tension * d * shape.f1;
    const double curvature =
        tension * d / 3 + (stiffness(left) + stiffness(right)) * area_slope * area_slope;
    const double bent = std::clamp(alpha + torque / curvature, -kLargestAngle, kLargestAngle);
    const double gain = d * d * (arc_shape(bent).g - shape.g);
    if (!left.is_outside()) {
      area_[left] += gain;
    }
    if (!right.is_outside()) {
      area_[right] -= gain;
    }
    alpha = bent;
  }

  /// ∂A/∂x of the bubble between the films k and k + 1 of a junction.
  static Vec2 area_slope(const std::array<Vec2, 3>& chord, const std::array<double, 3>& bulge,
                         std::size_t k) {
    const std::size_t next = (k + 1) % 3;
    const Vec2 across = chord[k] - chord[next];
    return Vec2{0.5 * across.y, -0.5 * across.x} - (2 * bulge[k]) * chord[k] +
           (2 * bulge[next]) * chord[next];
  }

  Foam& foam_;
  double tension_; ///< that forces are measured in
  Field<Bubble, double> area_;
  double smallest_length_;
};

void swap_short_films(Foam& foam, double t1_length) {
  for (const Film f : foam.film_slots()) {
    if (foam.has_film(f) && foam.length(f.half()) <= t1_length && spares_sides(foam, f) &&
        can_perform_t1(foam, f) && unstable_to_t1(foam, f)) {
      perform_t1(foam, f);
    }
  }
}

} // namespace

void relax_compressible(Foam& foam, double t1_length, const AbortCheck& aborted) {
  Relaxation relaxation(foam, kSmallestLength * t1_length);
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    if (aborted && aborted()) {
      throw Aborted();
    }
    if (sweep % kSweepsBetweenSwaps == 0) {
      swap_short_films(foam, t1_length);
    }
    relaxation.measure_areas();
    if (sweep > 0 && sweep % kSweepsBetweenPressures == 0) {
      relaxation.update_pressures();
    }
    if (relaxation.sweep() < kAtRest) {
      return;
    }
  }
}

} // namespace foam
