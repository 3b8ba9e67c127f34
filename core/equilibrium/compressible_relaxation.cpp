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

constexpr int kRounds = 400;
constexpr int kSweeps = 5;              // of a round, at the end of which pressures are updated
constexpr double kSoftest = 1;          // bulk modulus of a bubble's gas, in units of T/√A^τ,
constexpr double kHardest = 4;          // at first and in the end,
constexpr double kHardening = 2;        // what it grows by in a round
constexpr double kCalm = 0.3;           // that leaves junctions' forces below this, in units of T
constexpr double kEmptiest = 0.01;      // A/A^τ below which the gas gets no harder
constexpr double kSmallestLength = 0.1; // of a film, in units of what is short
constexpr double kLargestAngle = 0.47 * std::numbers::pi;

class Relaxation {
public:
  Relaxation(Foam& foam, double shortness)
      : foam_(foam), tension_(foam.reference_tension()), area_(foam.pressure.size()),
        shortness_(shortness) {}

  void measure_areas() {
    for (const Bubble b : foam_.bubble_slots()) {
      if (foam_.has_bubble(b)) {
        area_[b] = foam_.area(b);
      }
    }
  }

  /// Method of multipliers: the gas at its target area takes over a part of the pressure.
  /// \returns the largest |A − A^τ|/A^τ.
  double update_pressures() {
    double largest = 0;
    for (const Bubble b : foam_.bubble_slots()) {
      if (foam_.has_bubble(b)) {
        const double x = area_[b] / foam_.target_area[b];
        foam_.pressure[b] += bulk_modulus(b) * (1 - std::clamp(x, 0.0, 2.0));
        largest = std::max(largest, std::abs(x - 1));
      }
    }
    return largest;
  }

  void harden() { stiffness_ = std::min(kHardening * stiffness_, kHardest); }

  /// \returns the largest force on a junction, in units of T, as it was before its move.
  double sweep() {
    double largest = 0;
    for (const Junction j : foam_.junction_slots()) {
      if (foam_.moves(j)) {
        largest = std::max(largest, move(j));
      }
    }
    for (const Film f : foam_.film_slots()) {
      if (foam_.bends(f)) {
        if (is_short(f)) {
          turn(f);
          move_together(f);
        }
        bend(f);
      }
    }
    return largest;
  }

private:
  /// Whether a film is in the way of its ends: neither moves far without the other.
  bool is_short(Film film) const { return norm(foam_.chord(film.half())) < short_length(film); }

  double short_length(Film film) const { return shortness_ * size_beside(foam_, film); }

  /// A/A^τ, kept away from 0.
  double filling(Bubble b) const { return std::max(area_[b] / foam_.target_area[b], kEmptiest); }

  double bulk_modulus(Bubble b) const {
    return stiffness_ * tension_ / std::sqrt(foam_.target_area[b]);
  }

  double pressure(Bubble b) const {
    if (b.is_outside()) {
      return foam_.pressure_of(b);
    }
    const double x = filling(b);
    return foam_.pressure[b] + bulk_modulus(b) * (x < 1 ? 1 / x - 1 : 1 - x);
  }

  /// −Δp/ΔA on the way to the target area.
  double stiffness(Bubble b) const {
    if (b.is_outside()) {
      return 0;
    }
    const double x = area_[b] / foam_.target_area[b];
    const double filled = filling(b);
    return bulk_modulus(b) / foam_.target_area[b] * (x < 1 ? (1 - filled) / (filled * (1 - x)) : 1);
  }

  /// A junction and what surrounds it. What lies along a wall sweeps no area.
  struct Corner {
    std::array<Half, 3> halves{};
    std::array<Vec2, 3> chord{};
    std::array<double, 3> bulge{};  // segment area over d², on the left bubble's account
    std::array<Bubble, 3> bubble{}; // left of halves[k]: between it and the next

    /// ∂A/∂x of the bubble between the films k and k + 1.
    Vec2 area_slope(std::size_t k) const {
      const std::size_t next = (k + 1) % 3;
      const Vec2 across = chord[k] - chord[next];
      return Vec2{0.5 * across.y, -0.5 * across.x} - (2 * bulge[k]) * chord[k] +
             (2 * bulge[next]) * chord[next];
    }
  };

  Corner corner(Junction junction) const {
    Corner c{.halves = foam_.junction_half[junction]};
    for (std::size_t k = 0; k < 3; ++k) {
      c.bubble[k] = foam_.left(c.halves[k]);
      if (!foam_.wall(c.halves[k])) {
        c.chord[k] = foam_.chord(c.halves[k]);
        c.bulge[k] = arc_shape(foam_.half_angle(c.halves[k])).g;
      }
    }
    return c;
  }

  /// What pulls at a point: films, and gas by the change of areas.
  struct Pull {
    Vec2 force;                                                // of films, N/cm
    double stretch = 0;                                        // their stiffness, N/cm²
    double shortest = std::numeric_limits<double>::infinity(); // of their chords, cm
    std::array<Bubble, 6> bubble{};
    std::array<Vec2, 6> slope{}; // ∂A/∂x, cm
    std::size_t bubbles = 0;

    void add(Bubble b, Vec2 area_slope) {
      const auto* const known = std::find(bubble.data(), bubble.data() + bubbles, b);
      const auto i = static_cast<std::size_t>(known - bubble.data());
      bubble[i] = b;
      slope[i] += area_slope;
      bubbles = std::max(bubbles, i + 1);
    }
  };

  /// Adds what pulls at a junction, but for one film.
  void add_pull(const Corner& c, Film except, Pull& pull) const {
    for (std::size_t k = 0; k < 3; ++k) {
      const Film film = c.halves[k].film();
      if (foam_.wall(c.halves[k])) {
        pull.shortest = std::min(pull.shortest, foam_.length(c.halves[k]));
      } else if (film != except) {
        const double d = norm(c.chord[k]);
        const double pull_over_d = foam_.tension(film) * arc_shape(foam_.film_angle[film]).f / d;
        pull.force += pull_over_d * c.chord[k];
        pull.stretch += pull_over_d;
        pull.shortest = std::min(pull.shortest, d);
      }
      pull.add(c.bubble[k], c.area_slope(k));
    }
  }

  /// One step of Newton's method in a position, and the force in it (N/cm). The matrix is that of
  /// the stretched films and of the gas, without what could make it indefinite.
  struct Step {
    Vec2 step, force;
  };
  Step newton_step(const Pull& pull, const Freedom& freedom = Freedom::free()) const {
    Vec2 force = pull.force;
    std::array<double, 3> matrix{pull.stretch, 0, pull.stretch}; // xx, xy, yy
    for (std::size_t i = 0; i < pull.bubbles; ++i) {
      const Vec2 slope = pull.slope[i];
      force += pressure(pull.bubble[i]) * slope;
      const double hardness = stiffness(pull.bubble[i]);
      matrix[0] += hardness * slope.x * slope.x;
      matrix[1] += hardness * slope.x * slope.y;
      matrix[2] += hardness * slope.y * slope.y;
    }
    if (!freedom.any()) {
      return {};
    }
    if (freedom.is_along()) {
      const auto [x, y] = freedom.tangent();
      const double stiffness = matrix[0] * x * x + 2 * matrix[1] * x * y + matrix[2] * y * y;
      const Vec2 along = freedom.of(force);
      return {(1 / stiffness) * along, along};
    }
    const double determinant = matrix[0] * matrix[2] - matrix[1] * matrix[1];
    return {{(matrix[2] * force.x - matrix[1] * force.y) / determinant,
             (matrix[0] * force.y - matrix[1] * force.x) / determinant},
            force};
  }

  /// \returns the force, in units of T
  double move(Junction junction) {
    const Corner c = corner(junction);
    Pull pull;
    add_pull(c, kNone, pull);
    const auto [step, force] = newton_step(pull, foam_.freedom(junction));
    displace(junction, c, limited(step, pull.shortest));
    return norm(force) / tension_;
  }

  /// Turns a film to where its ends are pulled apart the most, and keeps it from vanishing.
  void turn(Film film) {
    const Half h = film.half();
    const Junction start = foam_.start(h);
    const Junction end = foam_.end(h);
    const Vec2 chord = foam_.chord(h);
    const auto pull = [&](Half of) { // of the other two films at its start
      const Half next = foam_.next_around_junction(of);
      const Half last = foam_.previous_around_junction(of);
      return foam_.tension(next.film()) * foam_.tangent(next) +
             foam_.tension(last.film()) * foam_.tangent(last);
    };
    const bool turns = !foam_.on_wall(start) && !foam_.on_wall(end);
    const Vec2 along = turns ? pull(h.twin()) - pull(h) : chord;
    const double length = std::max(norm(chord), kSmallestLength * short_length(film));
    const double strength = norm(along);
    if (!(strength > 0)) {
      return;
    }
    const Vec2 change = (length / strength) * along - chord;
    if (foam_.moves(start)) {
      displace(start, corner(start), (turns ? -0.5 : -1.0) * change);
    }
    if (foam_.moves(end)) {
      displace(end, corner(end), (turns ? 0.5 : 1.0) * change);
    }
  }

  /// Moves both ends of a film.
  void move_together(Film film) {
    const Junction start = foam_.start(film.half());
    const Junction end = foam_.end(film.half());
    if (foam_.on_wall(start) || foam_.on_wall(end)) {
      return;
    }
    Pull pull;
    add_pull(corner(start), film, pull);
    add_pull(corner(end), film, pull);
    const Vec2 step = limited(newton_step(pull).step, pull.shortest);
    displace(start, corner(start), step);
    displace(end, corner(end), step);
  }

  static Vec2 limited(Vec2 step, double shortest) {
    const double length = norm(step);
    return length > kLargestMove * shortest ? (kLargestMove * shortest / length) * step : step;
  }

  void displace(Junction junction, const Corner& c, Vec2 step) {
    foam_.displace(junction, foam_.position[junction], step);
    if (foam_.on_wall(junction)) {
      for (const Bubble b : c.bubble) {
        if (!b.is_outside()) {
          area_[b] = foam_.area(b);
        }
      }
      return;
    }
    std::array<double, 3> bulge_change{}; // of the segments' areas
    for (std::size_t k = 0; k < 3; ++k) {
      bulge_change[k] = c.bulge[k] * dot(step, step - 2 * c.chord[k]);
    }
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t next = (k + 1) % 3;
      if (!c.bubble[k].is_outside()) {
        area_[c.bubble[k]] +=
            0.5 * cross(step, c.chord[k] - c.chord[next]) + bulge_change[k] - bulge_change[next];
      }
    }
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

  Foam& foam_;
  double tension_; ///< that forces are measured in
  Field<Bubble, double> area_;
  double shortness_;            ///< of films that are short, in units of size_beside()
  double stiffness_ = kSoftest; ///< bulk modulus, in units of T/√A^τ
};

/// Whether a film that is short opens more when it is swapped. Where four films with the forces f
/// meet in a point, two of them are parted from the other two by a film of tension T and length l
/// at an energy of T·l − ½·|f₁ + f₂ − f₃ − f₄|·l. This is unstable_to_t1() for a point that is
/// not balanced.
bool opens_across(const Foam& foam, Film film) {
  if (foam.on_wall(foam.start(film.half())) || foam.on_wall(foam.end(film.half()))) {
    return unstable_to_t1(foam, film);
  }
  const auto force = [&](Half h) { return foam.tension(h.film()) * foam.tangent(h); };
  const Half h = film.half();
  const Vec2 f1 = force(foam.next_around_junction(h));
  const Vec2 f2 = force(foam.previous_around_junction(h));
  const Vec2 f3 = force(foam.next_around_junction(h.twin()));
  const Vec2 f4 = force(foam.previous_around_junction(h.twin()));
  const double across = 0.5 * norm(f1 + f4 - f2 - f3);
  const double along = 0.5 * norm(f1 + f2 - f3 - f4);
  return across > std::max(foam.tension(film), along);
}

void swap_short_films(Foam& foam, double shortness) {
  for (const Film f : foam.film_slots()) {
    if (foam.has_film(f) && foam.length(f.half()) <= shortness * size_beside(foam, f) &&
        spares_sides(foam, f) && can_perform_t1(foam, f) && opens_across(foam, f)) {
      perform_t1(foam, f);
    }
  }
}

} // namespace

bool relax_compressible(Foam& foam, double shortness, double closeness, const AbortCheck& aborted) {
  Relaxation relaxation(foam, shortness);
  for (int round = 0; round < kRounds; ++round) {
    double force = 0;
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      if (aborted && aborted()) {
        throw Aborted();
      }
      swap_short_films(foam, shortness);
      relaxation.measure_areas();
      force = relaxation.sweep();
    }
    const double area_error = relaxation.update_pressures();
    if (force < closeness && area_error < closeness) {
      return true;
    }
    if (force < kCalm) {
      relaxation.harden();
    }
  }
  return false;
}

} // namespace foam
