// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>

#include "geometry/arc.h"
#include "geometry/lattice.h"
#include "geometry/vec2.h"
#include "mesh/ids.h"
#include "mesh/surroundings.h"
#include "mesh/walls.h"

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
    return mesh().surroundings.has_images() ? d + mesh().surroundings.lattice.period(wrap(h)) : d;
  }
  /// Unit tangent of h at its start, pointing into the film.
  FOAM_HOST_DEVICE Vec2 tangent(Half h) const { return start_tangent(chord(h), half_angle(h)); }
  FOAM_HOST_DEVICE double length(Half h) const {
    return wall(h) ? stretch(h).length : arc_length(norm(chord(h)), half_angle(h));
  }
  /// Area between a film's half() and its chord, cm².
  FOAM_HOST_DEVICE double segment(Film f) const {
    const Half h = f.half();
    return wall(h) ? stretch(h).segment : segment_area(norm(chord(h)), half_angle(h));
  }

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
  /// Whether the film is a stretch of a wall.
  FOAM_HOST_DEVICE bool wall(Half h) const {
    return mesh().surroundings.has_walls() && (solid(left(h)) || solid(right(h)));
  }
  /// Calls visit(part, corner) for the parts of a stretch of a wall, as the wall is walked; see
  /// foam::for_each_part.
  template <class Visit> FOAM_HOST_DEVICE void for_each_wall_part(Half h, Visit&& visit) const {
    const Half forwards = solid(right(h)) ? h : h.twin();
    for_each_part(mesh(), place_on_wall(start(forwards)), place_on_wall(end(forwards)),
                  chord(forwards), visit);
  }
  /// The stretch of the wall that a film is, seen from h.
  FOAM_APART WallStretch stretch(Half h) const {
    WallStretch sum;
    Vec2 at; // from the start
    double twice_polygon = 0;
    for_each_wall_part(h, [&](const WallPiece& part, double corner) {
      const double d = norm(part.chord);
      sum.length += arc_length(d, part.half_angle);
      sum.segment += segment_area(d, part.half_angle);
      sum.turn += 2 * part.half_angle + corner;
      twice_polygon += cross(at, part.chord);
      at += part.chord;
    });
    sum.segment += 0.5 * twice_polygon; // which the chord closes
    const double sign = solid(right(h)) ? 1 : -1;
    return {sum.length, sign * sum.segment, sign * sum.turn};
  }
  /// Where on its wall a film ends. \pre on_wall(j)
  FOAM_HOST_DEVICE WallPlace place_on_wall(Junction j) const {
    const Piece piece = mesh().junction_piece[j];
    return {piece, mesh().wall_piece[piece].place_of(mesh().position[j])};
  }
  /// Whether a film ends there on a wall.
  FOAM_HOST_DEVICE bool on_wall(Junction j) const {
    return mesh().surroundings.has_walls() && mesh().junction_piece[j] != kNone;
  }
  /// The place at a distance (cm) from the start of a stretch of a wall.
  FOAM_HOST_DEVICE WallPlace place_on_stretch(Half h, double distance) const {
    return moved_along_wall(mesh(), place_on_wall(start(h)), solid(right(h)) ? distance : -distance,
                            AtEdges::Pass);
  }
  /// Puts a junction on a wall.
  FOAM_HOST_DEVICE void put_on_wall(Junction j, WallPlace at) {
    mesh().junction_piece[j] = at.piece;
    mesh().position[j] = point_of(mesh(), at);
  }
  /// Puts a junction off the walls.
  FOAM_HOST_DEVICE void put_off_wall(Junction j, Vec2 at) {
    if (mesh().surroundings.has_walls()) {
      mesh().junction_piece[j] = kNone;
    }
    mesh().position[j] = at;
  }
  /// Moves a junction from a place as far as it may, by a change (cm) and on a wall along it.
  FOAM_HOST_DEVICE void displace(Junction j, Vec2 from, Vec2 change) {
    if (on_wall(j)) {
      slide(j, from, change);
    } else {
      mesh().position[j] = from + change;
    }
  }
  /// The change of a film's chord, or of the length of a stretch of a wall, in units of the length
  /// that it has, when its ends move by so much.
  FOAM_HOST_DEVICE double relative_growth(Half h, Vec2 start_change, Vec2 end_change) const {
    if (wall(h)) {
      return relative_growth_of_stretch(h, start_change, end_change);
    }
    const Vec2 d = chord(h);
    return dot(d, end_change - start_change) / dot(d, d);
  }
  /// The one half-film that leaves a wall. \pre on_wall(j)
  FOAM_HOST_DEVICE Half off_wall(Junction j) const {
    const std::array<Half, 3>& halves = mesh().junction_half[j];
    return !wall(halves[0]) ? halves[0] : (!wall(halves[1]) ? halves[1] : halves[2]);
  }
  /// How the junction may move: one on a wall along it, if it slips.
  FOAM_HOST_DEVICE Freedom freedom(Junction j) const {
    return on_wall(j) ? freedom_on_wall(j) : Freedom::free();
  }
  /// Whether a film is pinned there to a wall.
  FOAM_HOST_DEVICE bool pinned(Junction j) const {
    return on_wall(j) && mesh().exterior[mesh().piece_outside[mesh().junction_piece[j]]].contact ==
                             WallContact::Pinned;
  }
  /// Whether there is the junction and it moves.
  FOAM_HOST_DEVICE bool moves(Junction j) const { return has_junction(j) && !pinned(j); }
  /// Whether there is the film and it bends: it is no wall.
  FOAM_HOST_DEVICE bool bends(Film f) const { return has_film(f) && !wall(f.half()); }

  /// Whether there is the film and its ends may come together: it is none between walls.
  FOAM_HOST_DEVICE bool may_close(Film f) const {
    if (!has_film(f)) {
      return false;
    }
    const Half h = f.half();
    return wall(h) ? !pinned(start(h)) : !on_wall(start(h)) || !on_wall(end(h));
  }

  /// Whether a bubble has an outside beside it.
  FOAM_HOST_DEVICE bool bubble_on_outside(Bubble b) const {
    bool found = false;
    for_each_half(mesh(), b, [&](Half h) { found = found || right(h).is_outside(); });
    return found;
  }

  /// Area of a bubble: its polygon and the segments of its arcs (thesis 3.3.12), cm².
  FOAM_APART double area(Bubble b) const {
    return area(b, [this](Film f) { return segment(f); });
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
    return 0.5 * twice_polygon + segments +
           (mesh().surroundings.has_walls() ? area_of_walls_in(b) : 0);
  }

  /// Whether a wall lies in the bubble that no film touches.
  FOAM_HOST_DEVICE bool hosts_wall(Bubble b) const {
    bool found = false;
    for (const Outside o : mesh().outside_slots()) {
      found = found || mesh().exterior[o].host == b;
    }
    return found;
  }
  /// Area inside of a whole wall, on the account of the foam's side: negative of an obstacle, cm².
  FOAM_APART double area_of_wall(Outside outside) const {
    const Exterior& exterior = mesh().exterior[outside];
    double twice_polygon = 0;
    double segments = 0;
    Vec2 at;
    for (Index i = 0; i < exterior.pieces; ++i) {
      const WallPiece& piece = mesh().wall_piece[Piece(exterior.first_piece + i)];
      twice_polygon += cross(at, piece.chord);
      segments += segment_area(norm(piece.chord), piece.half_angle);
      at += piece.chord;
    }
    return 0.5 * twice_polygon + segments;
  }

  /// Whether it is an outside with a wall.
  FOAM_HOST_DEVICE bool solid(Bubble b) const {
    return b.is_outside() && mesh().exterior[b.outside()].kind == Exterior::Kind::Solid;
  }

private:
  FOAM_HOST_DEVICE const Mesh& mesh() const { return static_cast<const Mesh&>(*this); }
  FOAM_HOST_DEVICE Mesh& mesh() { return static_cast<Mesh&>(*this); }

  FOAM_APART double area_of_walls_in(Bubble b) const {
    double sum = 0;
    for (const Outside o : mesh().outside_slots()) {
      sum += mesh().exterior[o].host == b ? area_of_wall(o) : 0;
    }
    return sum;
  }
  FOAM_APART void slide(Junction j, Vec2 from, Vec2 change) {
    if (from != mesh().position[j]) {
      const Outside outside = mesh().piece_outside[mesh().junction_piece[j]];
      mesh().junction_piece[j] = nearest_piece(mesh(), outside, from);
      mesh().position[j] = from;
    }
    const Freedom may = freedom(j);
    if (const double way = may.is_along() ? dot(change, may.tangent()) : 0; way != 0) {
      put_on_wall(j, moved_along_wall(mesh(), place_on_wall(j), way, AtEdges::Stop));
    }
  }
  FOAM_APART double relative_growth_of_stretch(Half h, Vec2 start_change, Vec2 end_change) const {
    const double forwards = dot(end_change, tangent_of(mesh(), place_on_wall(end(h)))) -
                            dot(start_change, tangent_of(mesh(), place_on_wall(start(h))));
    return (solid(right(h)) ? forwards : -forwards) / length(h);
  }
  FOAM_APART Freedom freedom_on_wall(Junction j) const {
    if (pinned(j)) {
      return Freedom::none();
    }
    const Piece piece = mesh().junction_piece[j];
    const WallPiece& curve = mesh().wall_piece[piece];
    const double place = curve.place_of(mesh().position[j]);
    if (place == 0 && starts_at_edge(mesh(), piece)) {
      return freedom_at_edge(j, piece);
    }
    return Freedom::along(curve.tangent(place), curve.curvature());
  }
  /// A film on an edge is held there as long as it pulls along neither of the pieces that meet
  /// there.
  FOAM_APART Freedom freedom_at_edge(Junction j, Piece after) const {
    const Vec2 pull = tangent(off_wall(j));
    const WallPiece& ahead = mesh().wall_piece[after];
    const WallPiece& behind = mesh().wall_piece[neighbour_piece(mesh(), after, -1)];
    if (const Vec2 forwards = ahead.tangent(0); dot(pull, forwards) > 0) {
      return Freedom::along(forwards, ahead.curvature());
    }
    if (const Vec2 forwards = behind.tangent(behind.length()); dot(pull, forwards) < 0) {
      return Freedom::along(forwards, behind.curvature());
    }
    return Freedom::none();
  }
  FOAM_HOST_DEVICE Half around_junction(Half h, int step) const {
    const std::array<Half, 3>& halves = mesh().junction_half[start(h)];
    const int k = halves[0] == h ? 0 : (halves[1] == h ? 1 : 2);
    return halves[static_cast<std::size_t>((k + step) % 3)];
  }
};

} // namespace foam
