// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <stdexcept>
#include <string>
#include <vector>

#include "geometry/arc.h"
#include "geometry/vec2.h"

namespace foam {

using Index = std::int32_t;

/// The outside, in every place where a bubble's index or id may stand.
inline constexpr Index kWorld = -1;
/// No element.
inline constexpr Index kNone = -1;

/// Bad input. The message names the cause and the offending value.
class FoamError : public std::runtime_error {
public:
  using std::runtime_error::runtime_error;
};

enum class Boundary {
  Free,     ///< the foam floats in the world, whose pressure is 0
  Periodic, ///< the foam fills a torus
  Fixed     ///< a sealed container: junctions on its wall are pinned, wall films straight and tight
};

/// The rectangle of a torus, cm.
struct Box {
  double xmin = 0, xmax = 0, ymin = 0, ymax = 0;

  double width() const { return xmax - xmin; }
  double height() const { return ymax - ymin; }
  friend bool operator==(const Box& a, const Box& b) = default;
};

/// How many periods lie between a film's start and its end on a torus.
struct Wrap {
  Index x = 0;
  Index y = 0;

  friend Wrap operator+(Wrap a, Wrap b) { return {a.x + b.x, a.y + b.y}; }
  friend Wrap operator-(Wrap a) { return {-a.x, -a.y}; }
  friend Wrap operator-(Wrap a, Wrap b) { return a + (-b); }
  friend bool operator==(Wrap a, Wrap b) = default;
};

/// What is known about a foam's equilibrium.
struct EquilibriumReport {
  bool converged = false;
  int iterations = 0;
  double max_angle_error = 0; ///< rad, largest deviation from 120° at a junction that may move
  double max_area_error = 0;  ///< largest |A − A^τ|/A^τ
  double residual = 0;        ///< largest dimensionless residual of the equilibrium's equations
};

/// A two-dimensional dry foam: the dual mesh of the thesis (3.2, 4.5.2), as a structure of arrays
/// that is allocated once; vanished elements are masked.
///
/// A film f is a pair of half-films 2f and 2f + 1, each other's twins. A half-film starts in a
/// junction and has a bubble on its left. A junction knows its three outgoing half-films in
/// counter-clockwise order, which makes "three films to a junction" a property of the type. A
/// bubble knows one half-film that has it on its left; its films are visited counter-clockwise by
/// next_in_bubble. The world is kWorld; it has no entry in the bubbles' arrays, and pressure 0.
struct Foam {
  // Bubbles.
  std::vector<Index> bubble_half;      ///< one half-film with the bubble on its left; kNone if gone
  std::vector<Index> sides;            ///< number of films
  std::vector<double> pressure;        ///< N/cm
  std::vector<double> target_area;     ///< A^τ, cm²
  std::vector<std::int64_t> bubble_id; ///< persistent name of a bubble

  // Half-films.
  std::vector<Index> half_junction; ///< where it starts; kNone if gone
  std::vector<Index> half_bubble;   ///< on its left

  // Films; values as seen from half-film 2f.
  std::vector<double> film_angle; ///< half-angle α, rad
  std::vector<Wrap> film_wrap;    ///< periods from start to end

  // Junctions.
  std::vector<Vec2> position;                      ///< cm
  std::vector<std::array<Index, 3>> junction_half; ///< outgoing, counter-clockwise; kNone if gone

  Boundary boundary = Boundary::Free;
  Box box;                    ///< the torus; unused otherwise
  double surface_tension = 0; ///< γ, N/cm
  double time = 0;            ///< s
  std::int64_t t1_count = 0;  ///< T1s so far
  std::int64_t t2_count = 0;  ///< T2s so far
  std::int64_t t3_count = 0;  ///< T3s so far
  EquilibriumReport report;   ///< of the last equilibration
  std::uint64_t topology = 0; ///< grows with every topological change

  Index bubble_capacity() const { return static_cast<Index>(bubble_half.size()); }
  Index film_capacity() const { return static_cast<Index>(film_angle.size()); }
  Index junction_capacity() const { return static_cast<Index>(position.size()); }

  bool has_bubble(Index b) const { return bubble_half[size(b)] != kNone; }
  bool has_film(Index f) const { return half_junction[size(2 * f)] != kNone; }
  bool has_junction(Index j) const { return junction_half[size(j)][0] != kNone; }

  Index bubble_count() const;
  Index film_count() const;
  Index junction_count() const;

  static Index twin(Index h) { return h ^ 1; }
  static Index film_of(Index h) { return h >> 1; }

  Index start(Index h) const { return half_junction[size(h)]; }
  Index end(Index h) const { return half_junction[size(twin(h))]; }
  Index left(Index h) const { return half_bubble[size(h)]; }
  Index right(Index h) const { return half_bubble[size(twin(h))]; }

  /// The next outgoing half-film of the same junction, counter-clockwise.
  Index next_around_junction(Index h) const { return around_junction(h, 1); }
  /// The next outgoing half-film of the same junction, clockwise.
  Index previous_around_junction(Index h) const { return around_junction(h, 2); }
  /// The next half-film of the bubble on the left of h, counter-clockwise.
  Index next_in_bubble(Index h) const { return previous_around_junction(twin(h)); }
  /// The one before h in the bubble on its left.
  Index previous_in_bubble(Index h) const { return twin(next_around_junction(h)); }

  double half_angle(Index h) const {
    return (h & 1) ? -film_angle[size(h >> 1)] : film_angle[size(h >> 1)];
  }
  void set_half_angle(Index h, double alpha) {
    film_angle[size(h >> 1)] = (h & 1) ? -alpha : alpha;
  }
  Wrap wrap(Index h) const { return (h & 1) ? -film_wrap[size(h >> 1)] : film_wrap[size(h >> 1)]; }
  void set_wrap(Index h, Wrap w) { film_wrap[size(h >> 1)] = (h & 1) ? -w : w; }

  /// A wrap as a vector, cm.
  Vec2 period(Wrap w) const { return {w.x * box.width(), w.y * box.height()}; }
  /// From the start of h to its end, cm.
  Vec2 chord(Index h) const {
    const Vec2 d = position[size(end(h))] - position[size(start(h))];
    return boundary == Boundary::Periodic ? d + period(wrap(h)) : d;
  }
  /// Unit tangent of h at its start, pointing into the film.
  Vec2 tangent(Index h) const { return start_tangent(chord(h), half_angle(h)); }
  double length(Index h) const { return arc_length(norm(chord(h)), half_angle(h)); }
  /// Pressure of a bubble or of the world, N/cm.
  double pressure_of(Index b) const { return b == kWorld ? 0.0 : pressure[size(b)]; }

  bool on_world(Index h) const { return left(h) == kWorld || right(h) == kWorld; }
  /// Whether the junction touches the world.
  bool junction_on_world(Index j) const;
  /// Whether the junction sits on the wall of a sealed container.
  bool pinned(Index j) const { return boundary == Boundary::Fixed && junction_on_world(j); }
  /// Whether the film is a piece of the wall of a sealed container.
  bool wall(Index h) const { return boundary == Boundary::Fixed && on_world(h); }

  /// Area of a bubble: its polygon and the segments of its arcs (thesis 3.3.12), cm².
  double area(Index b) const;
  /// Film energy 2γ·Σl, N; the wall of a sealed container is no film.
  double energy() const;
  /// √(mean target area), the foam's own unit of length, cm.
  double mean_spacing() const;
  /// Whether a bubble touches the world.
  bool bubble_on_world(Index b) const;

  void resize(Index bubbles, Index films, Index junctions);

  static std::size_t size(Index i) { return static_cast<std::size_t>(i); }

private:
  Index around_junction(Index h, int step) const {
    const auto& halves = junction_half[size(start(h))];
    const int k = halves[0] == h ? 0 : (halves[1] == h ? 1 : 2);
    return halves[static_cast<std::size_t>((k + step) % 3)];
  }
};

/// Calls visit(h) for every half-film of the bubble, counter-clockwise.
template <class Visit> void for_each_half(const Foam& foam, Index bubble, Visit&& visit) {
  const Index first = foam.bubble_half[Foam::size(bubble)];
  Index h = first;
  do {
    visit(h);
    h = foam.next_in_bubble(h);
  } while (h != first);
}

} // namespace foam
