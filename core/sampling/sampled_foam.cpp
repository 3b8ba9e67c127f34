// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/sampled_foam.h"

#include "parallel/host.h"
#include "sampling/foam_sampler.h"

namespace foam {
namespace {

/// The pieces of a wall on which no film ends, each a polyline.
void append_wall(const Foam& foam, Outside wall, double chord_error, FilmPolylines& films) {
  const Exterior& exterior = foam.exterior[wall];
  for (Index i = 0; i < exterior.pieces; ++i) {
    const WallPiece& piece = foam.wall_piece[Piece(exterior.first_piece + i)];
    const int segments = arc_segments(norm(piece.chord), piece.half_angle, chord_error);
    for (int k = 0; k <= segments; ++k) {
      const Vec2 p =
          arc_point(piece.start, piece.chord, piece.half_angle, static_cast<double>(k) / segments);
      films.connectivity.push_back(static_cast<std::int64_t>(films.points.size()));
      films.points.push_back({p.x, p.y, 0});
      films.junction_id.push_back(kNone);
    }
    films.offsets.push_back(static_cast<std::int64_t>(films.connectivity.size()));
    films.left.push_back(foam.bubble_id[exterior.host]);
    films.right.push_back(Bubble(wall).index());
    films.curvature.push_back(piece.curvature());
    films.pressure_difference.push_back(foam.pressure[exterior.host] - exterior.pressure);
    films.length.push_back(piece.length());
    films.half_angle.push_back(piece.half_angle);
    if (!foam.has_uniform_tension()) {
      films.tension.push_back(foam.reference_tension());
    }
    films.on_boundary.push_back(1);
    films.kind.push_back(1);
  }
}

} // namespace

void take_outsides(const Foam& foam, SampledFoam& sampled) {
  sampled.exteriors = foam.exterior;
  sampled.wall_pieces = foam.wall_piece;
  sampled.wall_forces = wall_forces(foam);
}

SampledFoam sample(const Foam& foam, double chord_error) {
  Host host;
  SampledFoam sampled =
      FoamSampler<Host>(host).sample(view_of(foam), BubbleNames<Host>(foam.bubble_id), chord_error);
  sampled.record = static_cast<const FoamRecord&>(foam);
  take_outsides(foam, sampled);
  for (const Outside wall : foam.outside_slots()) {
    if (foam.exterior[wall].host != kNone) {
      append_wall(foam, wall, chord_error > 0 ? chord_error : foam.mean_spacing() / 200,
                  sampled.films);
    }
  }
  return sampled;
}

} // namespace foam
