// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "geometry/arc.h"
#include "geometry/lattice.h"
#include "geometry/vec2.h"
#include "mesh/ids.h"
#include "mesh/surroundings.h"

namespace foam {

/// Calls visit(h) for every half-film of the bubble, counter-clockwise.
template <class Mesh, class Visit>
FOAM_HOST_DEVICE void for_each_half(const Mesh& mesh, Bubble bubble, Visit&& visit) {
  const Half first = mesh.bubble_half[bubble];
  Half h = first;
  do {
    visit(h);
    h = mesh.next_in_bubble(h);
  } while (h != first);
}

/// What can be asked of the dual mesh, whoever holds its arrays: a Foam, or a view of arrays that
/// lie elsewhere. Mesh derives from this and has FoamArrays, Foam's surroundings and surface
/// tension.
template <class Mesh> struct MeshAccess {
  FOAM_HOST_DEVICE bool has_bubble(Bubble b) const { return mesh().bubble_half[b] != kNone; }
  FOAM_HOST_DEVICE bool has_film(Film f) const { return mesh().half_junction[f.half()] != kNone; }
  FOAM_HOST_DEVICE bool has_junction(Junction j) const {
    return mesh().junction_half[j][0] != kNone;
  }

  FOAM_HOST_DEVICE Junction start(Half h) const { return mesh().half_junction[h]; }
  FOAM_HOST_DEVICE Junction end(Half h) const { return mesh().half_junction[h.twin()]; }
  FOAM_HOST_DEVICE Bubble left(Half h) const { return mesh().half_bubble[h]; }
  FOAM_HOST_DEVICE Bubble right(Half h) const { return mesh().half_bubble[h.twin()]; }

  /// The next outgoing half-film of the same junction, counter-clockwise.
  FOAM_HOST_DEVICE Half next_around_junction(Half h) const { return around_junction(h, 1); }
  /// The next outgoing half-film of the same junction, clockwise.
  FOAM_HOST_DEVICE Half previous_around_junction(Half h) const { return around_junction(h, 2); }
  /// The next half-film of the bubble on the left of h, counter-clockwise.
  FOAM_HOST_DEVICE Half next_in_bubble(Half h) const { return previous_around_junction(h.twin()); }
  /// The one before h in the bubble on its left.
  FOAM_HOST_DEVICE Half previous_in_bubble(Half h) const { return next_around_junction(h).twin(); }

  FOAM_HOST_DEVICE double half_angle(Half h) const {
    const double alpha = mesh().film_angle[h.film()];
    return h.reversed() ? -alpha : alpha;
  }
  FOAM_HOST_DEVICE void set_half_angle(Half h, double alpha) {
    mesh().film_angle[h.film()] = h.reversed() ? -alpha : alpha;
  }
  FOAM_HOST_DEVICE Wrap wrap(Half h) const {
    const Wrap w = mesh().film_wrap[h.film()];
    return h.reversed() ? -w : w;
  }
  FOAM_HOST_DEVICE void set_wrap(Half h, Wrap w) {
    mesh().film_wrap[h.film()] = h.reversed() ? -w : w;
  }

  /// From the start of h to its end, cm.
  FOAM_HOST_DEVICE Vec2 chord(Half h) const {
    const Vec2 d = mesh().position[end(h)] - mesh().position[start(h)];
    return mesh().surroundings.periodic() ? d + mesh().surroundings.lattice.period(wrap(h)) : d;
  }
  /// Unit tangent of h at its start, pointing into the film.
  FOAM_HOST_DEVICE Vec2 tangent(Half h) const { return start_tangent(chord(h), half_angle(h)); }
  FOAM_HOST_DEVICE double length(Half h) const { return arc_length(norm(chord(h)), half_angle(h)); }

  /// What forces are measured in, the tension of a film that has none of its own: 2γ, N/cm.
  FOAM_HOST_DEVICE double reference_tension() const { return 2 * mesh().surface_tension; }
  /// Whether all films have the same tension, 2γ.
  FOAM_HOST_DEVICE bool has_uniform_tension() const { return mesh().film_tension.empty(); }
  /// What a film pulls with, N/cm.
  FOAM_HOST_DEVICE double tension(Film f) const {
    return has_uniform_tension() ? reference_tension() : mesh().film_tension[f];
  }
  /// The same, in units of 2γ.
  FOAM_HOST_DEVICE double relative_tension(Film f) const {
    return has_uniform_tension() ? 1 : mesh().film_tension[f] / reference_tension();
  }

  /// Pressure of a bubble or an outside, N/cm².
  FOAM_HOST_DEVICE double pressure_of(Bubble b) const {
    return b.is_outside() ? mesh().exterior[b.outside()].pressure : mesh().pressure[b];
  }
  /// By how much the pressure on the left of h is the higher one, N/cm².
  FOAM_HOST_DEVICE double pressure_difference(Half h) const {
    return pressure_of(left(h)) - pressure_of(right(h));
  }

  /// Whether the film has an outside beside it.
  FOAM_HOST_DEVICE bool on_outside(Half h) const {
    return left(h).is_outside() || right(h).is_outside();
  }
  /// Whether the film is a piece of a wall.
  FOAM_HOST_DEVICE bool wall(Half h) const {
    return mesh().surroundings.has_walls() && (solid(left(h)) || solid(right(h)));
  }
  /// How the junction may move: one on a wall is pinned to it.
  FOAM_HOST_DEVICE Freedom freedom(Junction j) const {
    if (mesh().surroundings.has_walls()) {
      const std::array<Half, 3>& halves = mesh().junction_half[j];
      if (solid(left(halves[0])) || solid(left(halves[1])) || solid(left(halves[2]))) {
        return Freedom::none();
      }
    }
    return Freedom::free();
  }
  /// Whether there is the junction and it moves.
  FOAM_HOST_DEVICE bool moves(Junction j) const { return has_junction(j) && freedom(j).any(); }
  /// Whether there is the film and it bends: it is no wall.
  FOAM_HOST_DEVICE bool bends(Film f) const { return has_film(f) && !wall(f.half()); }

  /// Whether a bubble has an outside beside it.
  FOAM_HOST_DEVICE bool bubble_on_outside(Bubble b) const {
    bool found = false;
    for_each_half(mesh(), b, [&](Half h) { found = found || right(h).is_outside(); });
    return found;
  }

  /// Area of a bubble: its polygon and the segments of its arcs (thesis 3.3.12), cm².
  FOAM_HOST_DEVICE double area(Bubble b) const {
    return area(
        b, [this](Film f) { return segment_area(norm(chord(f.half())), half_angle(f.half())); });
  }
  /// The same. \param segment segment(f) is the area between f's half() and its chord, cm²
  template <class Segment> FOAM_HOST_DEVICE double area(Bubble b, const Segment& segment) const {
    double twice_polygon = 0;
    double segments = 0;
    // Relative to the first junction: a torus has no origin, and no digits are lost far out.
    Vec2 at;
    for_each_half(mesh(), b, [&](Half h) {
      const Vec2 d = chord(h);
      twice_polygon += cross(at, d);
      segments += h.reversed() ? -segment(h.film()) : segment(h.film());
      at += d;
    });
    return 0.5 * twice_polygon + segments;
  }

private:
  FOAM_HOST_DEVICE const Mesh& mesh() const { return static_cast<const Mesh&>(*this); }
  FOAM_HOST_DEVICE Mesh& mesh() { return static_cast<Mesh&>(*this); }

  FOAM_HOST_DEVICE bool solid(Bubble b) const {
    return b.is_outside() && mesh().exterior[b.outside()].kind == Exterior::Kind::Solid;
  }

  FOAM_HOST_DEVICE Half around_junction(Half h, int step) const {
    const std::array<Half, 3>& halves = mesh().junction_half[start(h)];
    const int k = halves[0] == h ? 0 : (halves[1] == h ? 1 : 2);
    return halves[static_cast<std::size_t>((k + step) % 3)];
  }
};

} // namespace foam
