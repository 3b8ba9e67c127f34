// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "evolver/curve.h"
#include "geometry/lattice.h"
#include "geometry/vec2.h"
#include "mesh/ids.h"

namespace foam::evolver {

/// The surface of a datafile of Surface Evolver's in the plane's STRING model, as it lists it. What
/// one element says of another is the other's place in its list, not the number that it has in the
/// file.
struct Datafile {
  struct Vertex {
    std::int64_t number = 0;
    Vec2 place;
    bool fixed = false;
    std::vector<Index> curves; ///< that it keeps to
    int line = 0;
  };
  struct Edge {
    std::int64_t number = 0;
    Index tail = kNone;
    Index head = kNone;
    Index midpoint = kNone; ///< vertex, in the tail's cell of the torus
    Wrap wrap;              ///< periods from the tail's cell to the head's
    double tension = 1;
    bool fixed = false;
    std::vector<Index> curves; ///< that it keeps to
    int line = 0;
  };
  struct Face {
    std::int64_t number = 0;
    Index begin = 0; ///< of its edges in face_edges
    Index end = 0;
    int line = 0;
  };
  /// An edge of a face, walked forwards or backwards.
  struct FaceEdge {
    Index edge = kNone;
    bool forwards = true;
  };
  struct Body {
    std::int64_t number = 0;
    Index face = kNone;
    bool forwards = true;             ///< whether the face is on its left as its loop is walked
    std::optional<double> volume;     ///< VOLUME, the area that it is to have
    double volume_constant = 0;       ///< VOLCONST, which counts as area
    double pressure = 0;              ///< LAGRANGE_MULTIPLIER
    std::optional<std::int64_t> name; ///< BubbleId as Foam writes it, or ORIGINAL
    int line = 0;
  };

  bool torus = false;
  Vec2 origin; ///< DISPLAY_ORIGIN
  Vec2 first_period{1, 0};
  Vec2 second_period{0, 1};
  double time = 0;           ///< TOTAL_TIME
  std::vector<Curve> curves; ///< CONSTRAINTs and BOUNDARYs, set where an element keeps to one
  std::vector<Vertex> vertices;
  std::vector<Edge> edges;
  std::vector<Face> faces;
  std::vector<FaceEdge> face_edges;
  std::vector<Body> bodies;
  std::vector<std::string> warnings; ///< of what was skipped, with line and keyword

  /// Where a walk along an edge starts.
  Index start(FaceEdge walk) const {
    const Edge& edge = edges[place_of(walk.edge)];
    return walk.forwards ? edge.tail : edge.head;
  }
  Index end(FaceEdge walk) const { return start({walk.edge, !walk.forwards}); }
  Vec2 start_place(FaceEdge walk) const { return vertices[place_of(start(walk))].place; }
  Wrap wrap(FaceEdge walk) const {
    const Wrap forwards = edges[place_of(walk.edge)].wrap;
    return walk.forwards ? forwards : -forwards;
  }
  Vec2 period(Wrap w) const {
    return static_cast<double>(w.x) * first_period + static_cast<double>(w.y) * second_period;
  }
  Vec2 chord(FaceEdge walk) const {
    return vertices[place_of(end(walk))].place - start_place(walk) + period(wrap(walk));
  }
  bool bends(FaceEdge walk) const { return edges[place_of(walk.edge)].midpoint != kNone; }
  /// Where an edge that bends does most, from where the walk starts.
  Vec2 middle(FaceEdge walk) const {
    const Edge& edge = edges[place_of(walk.edge)];
    const Vec2 forwards =
        vertices[place_of(edge.midpoint)].place - vertices[place_of(edge.tail)].place;
    return walk.forwards ? forwards : forwards + chord(walk);
  }
};

/// \param include gives the content of a file that the datafile includes
/// \throws FoamError with line and cause for what is no datafile, or is no foam in the plane: what
/// changes the energy or the areas and is not a tension, a volume or a wall
Datafile parse_datafile(std::string text, std::function<std::string(const std::string&)> include);

/// Whether a text, or as much of one as there is, begins as a datafile of the STRING model.
bool is_string_model(const std::string& start);

} // namespace foam::evolver
