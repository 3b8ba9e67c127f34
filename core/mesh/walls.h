// SPDX-License-Identifier: GPL-3.0-or-later
//
// Walls as curves: where films end on them, and what lies between two ends. A wall is walked with
// the foam on its left.
#pragma once

#include <algorithm>
#include <limits>

#include "geometry/arc.h"
#include "geometry/wall_piece.h"
#include "mesh/ids.h"
#include "mesh/surroundings.h"

namespace foam {

/// A place on a wall.
struct WallPlace {
  Piece piece;
  double place = 0; ///< on it, cm
};

/// A stretch of a wall.
struct WallStretch {
  double length = 0;  ///< cm
  double segment = 0; ///< area between it and its chord, on the account of the foam's side, cm²
  double turn = 0;    ///< by which its tangent turns to the left, corners included, rad
};

/// Whether a wall is a straight line without an end.
FOAM_HOST_DEVICE inline bool is_line(const Exterior& wall) {
  return wall.pieces == 1;
}

/// The piece after another, or before it.
template <class Mesh>
FOAM_HOST_DEVICE Piece neighbour_piece(const Mesh& mesh, Piece piece, Index step) {
  const Exterior& wall = mesh.exterior[mesh.piece_outside[piece]];
  const Index place = piece.index() - wall.first_piece + step + wall.pieces;
  return Piece(wall.first_piece + place % wall.pieces);
}

/// The piece of a wall that is nearest to a point; of several the one that starts there, or the
/// first.
template <class Mesh>
FOAM_APART Piece nearest_piece(const Mesh& mesh, Outside outside, Vec2 point) {
  const Exterior& wall = mesh.exterior[outside];
  Piece nearest(wall.first_piece);
  double least = std::numeric_limits<double>::infinity();
  for (Index i = 0; i < wall.pieces; ++i) {
    const Piece piece(wall.first_piece + i);
    if (mesh.wall_piece[piece].start == point) {
      return piece;
    }
    const double distance = mesh.wall_piece[piece].distance(point);
    if (distance < least) {
      least = distance;
      nearest = piece;
    }
  }
  return nearest;
}

/// The place of a point of a wall.
template <class Mesh>
FOAM_HOST_DEVICE WallPlace wall_place(const Mesh& mesh, Outside outside, Vec2 point) {
  const Piece piece = nearest_piece(mesh, outside, point);
  return {piece, mesh.wall_piece[piece].place_of(point)};
}

/// The angle by which the tangent turns to the left where a piece ends.
template <class Mesh> FOAM_HOST_DEVICE double corner_turn(const Mesh& mesh, Piece piece) {
  if (is_line(mesh.exterior[mesh.piece_outside[piece]])) {
    return 0;
  }
  const WallPiece& before = mesh.wall_piece[piece];
  const WallPiece& after = mesh.wall_piece[neighbour_piece(mesh, piece, 1)];
  return angle_from_to(before.tangent(before.length()), after.tangent(0));
}

/// Whether a film that slides along the wall is held up where a piece starts, by a corner that
/// stands out into the foam.
template <class Mesh> FOAM_HOST_DEVICE bool starts_at_edge(const Mesh& mesh, Piece piece) {
  constexpr double kSmooth = 1e-9; // rad
  return !is_line(mesh.exterior[mesh.piece_outside[piece]]) &&
         corner_turn(mesh, neighbour_piece(mesh, piece, -1)) < -kSmooth;
}

/// Whether what moves along a wall stops at edges, corners that stand out into the foam.
enum class AtEdges { Pass, Stop };

/// The place at a distance (cm) along the wall, backwards if that is negative.
template <class Mesh>
FOAM_APART WallPlace moved_along_wall(const Mesh& mesh, WallPlace from, double distance,
                                      AtEdges at_edges) {
  double place = from.place + distance;
  Piece piece = from.piece;
  if (is_line(mesh.exterior[mesh.piece_outside[piece]])) {
    return {piece, place};
  }
  const auto stops = [&] { return at_edges == AtEdges::Stop && starts_at_edge(mesh, piece); };
  bool leaves_edge = from.place == 0;
  while (place < 0) {
    if (!leaves_edge && stops()) {
      return {piece, 0};
    }
    leaves_edge = false;
    piece = neighbour_piece(mesh, piece, -1);
    place += mesh.wall_piece[piece].length();
  }
  while (place > mesh.wall_piece[piece].length()) {
    place -= mesh.wall_piece[piece].length();
    piece = neighbour_piece(mesh, piece, 1);
    if (stops()) {
      return {piece, 0};
    }
  }
  return {piece, place};
}

template <class Mesh> FOAM_HOST_DEVICE Vec2 point_of(const Mesh& mesh, WallPlace at) {
  return mesh.wall_piece[at.piece].point(at.place);
}

/// The direction of the wall there, of length 1.
template <class Mesh> FOAM_HOST_DEVICE Vec2 tangent_of(const Mesh& mesh, WallPlace at) {
  return mesh.wall_piece[at.piece].tangent(at.place);
}

/// Calls visit(part, corner) for the straight and circular parts of the stretch from one place to
/// another of the same wall, forwards. \param chord between the two, cm; corner is the angle by
/// which the tangent turns before the part.
template <class Mesh, class Visit>
FOAM_HOST_DEVICE void for_each_part(const Mesh& mesh, WallPlace from, WallPlace to, Vec2 chord,
                                    Visit&& visit) {
  const WallPiece& first = mesh.wall_piece[from.piece];
  if (is_line(mesh.exterior[mesh.piece_outside[from.piece]])) {
    visit(WallPiece{first.point(from.place), chord, 0}, 0.0);
    return;
  }
  const auto part = [](const WallPiece& piece, double begin, double end) {
    const Vec2 start = piece.point(begin);
    return WallPiece{start, piece.point(end) - start,
                     piece.half_angle * (end - begin) / piece.length()};
  };
  if (from.piece == to.piece && from.place <= to.place) {
    visit(part(first, from.place, to.place), 0.0);
    return;
  }
  if (from.place < first.length()) {
    visit(part(first, from.place, first.length()), 0.0);
  }
  Piece piece = from.piece;
  while (true) {
    const double corner = corner_turn(mesh, piece);
    piece = neighbour_piece(mesh, piece, 1);
    const WallPiece& next = mesh.wall_piece[piece];
    if (piece == to.piece) {
      if (to.place > 0) {
        visit(part(next, 0, to.place), corner);
      }
      return;
    }
    visit(next, corner);
  }
}

} // namespace foam
