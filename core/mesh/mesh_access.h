// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "geometry/arc.h"
#include "geometry/vec2.h"
#include "mesh/elements.h"

namespace foam {

/// Calls visit(h) for every half-film of the bubble, counter-clockwise.
template <class Mesh, class Visit>
FOAM_HOST_DEVICE void for_each_half(const Mesh& mesh, Index bubble, Visit&& visit) {
  const Index first = mesh.bubble_half[Mesh::size(bubble)];
  Index h = first;
  do {
    visit(h);
    h = mesh.next_in_bubble(h);
  } while (h != first);
}

/// What can be asked of the dual mesh, whoever holds its arrays: a Foam, or a FoamView of arrays
/// that lie elsewhere. Mesh derives from this and has Foam's arrays under Foam's names, as vectors
/// or as pointers.
template <class Mesh> struct MeshAccess {
  FOAM_HOST_DEVICE static constexpr std::size_t size(Index i) {
    return static_cast<std::size_t>(i);
  }

  FOAM_HOST_DEVICE bool has_bubble(Index b) const { return mesh().bubble_half[size(b)] != kNone; }
  FOAM_HOST_DEVICE bool has_film(Index f) const {
    return mesh().half_junction[size(2 * f)] != kNone;
  }
  FOAM_HOST_DEVICE bool has_junction(Index j) const {
    return mesh().junction_half[size(j)][0] != kNone;
  }

  FOAM_HOST_DEVICE static Index twin(Index h) { return h ^ 1; }
  FOAM_HOST_DEVICE static Index film_of(Index h) { return h >> 1; }

  FOAM_HOST_DEVICE Index start(Index h) const { return mesh().half_junction[size(h)]; }
  FOAM_HOST_DEVICE Index end(Index h) const { return mesh().half_junction[size(twin(h))]; }
  FOAM_HOST_DEVICE Index left(Index h) const { return mesh().half_bubble[size(h)]; }
  FOAM_HOST_DEVICE Index right(Index h) const { return mesh().half_bubble[size(twin(h))]; }

  /// The next outgoing half-film of the same junction, counter-clockwise.
  FOAM_HOST_DEVICE Index next_around_junction(Index h) const { return around_junction(h, 1); }
  /// The next outgoing half-film of the same junction, clockwise.
  FOAM_HOST_DEVICE Index previous_around_junction(Index h) const { return around_junction(h, 2); }
  /// The next half-film of the bubble on the left of h, counter-clockwise.
  FOAM_HOST_DEVICE Index next_in_bubble(Index h) const { return previous_around_junction(twin(h)); }
  /// The one before h in the bubble on its left.
  FOAM_HOST_DEVICE Index previous_in_bubble(Index h) const { return twin(next_around_junction(h)); }

  FOAM_HOST_DEVICE double half_angle(Index h) const {
    const double alpha = mesh().film_angle[size(film_of(h))];
    return (h & 1) ? -alpha : alpha;
  }
  FOAM_HOST_DEVICE void set_half_angle(Index h, double alpha) {
    mesh().film_angle[size(film_of(h))] = (h & 1) ? -alpha : alpha;
  }
  FOAM_HOST_DEVICE Wrap wrap(Index h) const {
    const Wrap w = mesh().film_wrap[size(film_of(h))];
    return (h & 1) ? -w : w;
  }
  FOAM_HOST_DEVICE void set_wrap(Index h, Wrap w) {
    mesh().film_wrap[size(film_of(h))] = (h & 1) ? -w : w;
  }

  /// A wrap as a vector, cm.
  FOAM_HOST_DEVICE Vec2 period(Wrap w) const {
    return {w.x * mesh().box.width(), w.y * mesh().box.height()};
  }
  /// From the start of h to its end, cm.
  FOAM_HOST_DEVICE Vec2 chord(Index h) const {
    const Vec2 d = mesh().position[size(end(h))] - mesh().position[size(start(h))];
    return mesh().boundary == Boundary::Periodic ? d + period(wrap(h)) : d;
  }
  /// Unit tangent of h at its start, pointing into the film.
  FOAM_HOST_DEVICE Vec2 tangent(Index h) const { return start_tangent(chord(h), half_angle(h)); }
  FOAM_HOST_DEVICE double length(Index h) const {
    return arc_length(norm(chord(h)), half_angle(h));
  }
  /// Pressure of a bubble or of the world, N/cm².
  FOAM_HOST_DEVICE double pressure_of(Index b) const {
    return b == kWorld ? 0.0 : mesh().pressure[size(b)];
  }

  FOAM_HOST_DEVICE bool on_world(Index h) const { return left(h) == kWorld || right(h) == kWorld; }
  /// Whether the junction touches the world.
  FOAM_HOST_DEVICE bool junction_on_world(Index j) const {
    const std::array<Index, 3>& halves = mesh().junction_half[size(j)];
    return left(halves[0]) == kWorld || left(halves[1]) == kWorld || left(halves[2]) == kWorld;
  }
  /// Whether the junction sits on the wall of a sealed container.
  FOAM_HOST_DEVICE bool pinned(Index j) const {
    return mesh().boundary == Boundary::Fixed && junction_on_world(j);
  }
  /// Whether the film is a piece of the wall of a sealed container.
  FOAM_HOST_DEVICE bool wall(Index h) const {
    return mesh().boundary == Boundary::Fixed && on_world(h);
  }
  /// Whether a bubble touches the world.
  FOAM_HOST_DEVICE bool bubble_on_world(Index b) const {
    bool found = false;
    for_each_half(mesh(), b, [&](Index h) { found = found || right(h) == kWorld; });
    return found;
  }

  /// Area of a bubble: its polygon and the segments of its arcs (thesis 3.3.12), cm².
  FOAM_HOST_DEVICE double area(Index b) const {
    return area(b, [this](Index f) { return segment_area(norm(chord(2 * f)), half_angle(2 * f)); });
  }
  /// The same. \param segment segment(f) is the area between half-film 2f and its chord, cm²
  template <class Segment> FOAM_HOST_DEVICE double area(Index b, const Segment& segment) const {
    double twice_polygon = 0;
    double segments = 0;
    Vec2
        at; // relative to the first junction: a torus has no origin, and no digits are lost far out
    for_each_half(mesh(), b, [&](Index h) {
      const Vec2 d = chord(h);
      twice_polygon += cross(at, d);
      segments += (h & 1) ? -segment(film_of(h)) : segment(film_of(h));
      at += d;
    });
    return 0.5 * twice_polygon + segments;
  }

private:
  FOAM_HOST_DEVICE const Mesh& mesh() const { return static_cast<const Mesh&>(*this); }
  FOAM_HOST_DEVICE Mesh& mesh() { return static_cast<Mesh&>(*this); }

  FOAM_HOST_DEVICE Index around_junction(Index h, int step) const {
    const std::array<Index, 3>& halves = mesh().junction_half[size(start(h))];
    const int k = halves[0] == h ? 0 : (halves[1] == h ? 1 : 2);
    return halves[static_cast<std::size_t>((k + step) % 3)];
  }
};

} // namespace foam
