// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolver/find_walls.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <tuple>
#include <utility>

#include "base/number.h"
#include "evolver/tokens.h"
#include "geometry/arc.h"

namespace foam::evolver {
namespace {

using std::to_string;
using Walk = Datafile::FaceEdge;

std::string name(const Datafile::Vertex& vertex) {
  return "vertex " + to_string(vertex.number);
}
std::string name(const Datafile::Edge& edge) {
  return "edge " + to_string(edge.number);
}

bool keeps_to(const std::vector<Index>& curves, Index curve) {
  return std::ranges::find(curves, curve) != curves.end();
}

/// A curve that two elements keep to.
Index common_curve(const std::vector<Index>& a, const std::vector<Index>& b) {
  const auto found = std::ranges::find_if(a, [&](Index curve) { return keeps_to(b, curve); });
  return found == a.end() ? Index{kNone} : *found;
}

/// The direction of a curve where it is nearest to a point.
Vec2 tangent_of(const Curve& curve, Vec2 near) {
  const Vec2 normal = curve.normal(near);
  return {normal.y, -normal.x};
}

class Closing {
public:
  explicit Closing(Datafile& file) : file_(file) {}

  void run() {
    const std::vector<Walk> loops = std::move(file_.face_edges);
    file_.face_edges.clear();
    for (Datafile::Face& face : file_.faces) {
      const Index begin = std::exchange(face.begin, static_cast<Index>(file_.face_edges.size()));
      for (Index k = begin; k < face.end; ++k) {
        const Walk walk = loops[place_of(k)];
        const Walk next = loops[place_of(k + 1 < face.end ? k + 1 : begin)];
        file_.face_edges.push_back(walk);
        if (file_.end(walk) != file_.start(next)) {
          fill_gap(face, walk, file_.end(walk), file_.start(next));
        }
      }
      face.end = static_cast<Index>(file_.face_edges.size());
    }
  }

private:
  void fill_gap(const Datafile::Face& face, Walk before, Index from, Index to) {
    const Datafile::Vertex& a = file_.vertices[place_of(from)];
    const Datafile::Vertex& b = file_.vertices[place_of(to)];
    if (const Index curve = common_curve(a.curves, b.curves); curve != kNone) {
      add_edge(face, before, from, to, curve);
      return;
    }
    for (const Index first : a.curves) {
      for (const Index second : b.curves) {
        const Curve& along = file_.curves[place_of(first)];
        const std::vector<Vec2> corners = crossings(along, file_.curves[place_of(second)]);
        const auto way = [&](Vec2 corner) {
          return way_along(face, before, along, a.place, corner);
        };
        const auto next = std::ranges::min_element(corners, {}, way);
        if (next != corners.end() && way(*next) < std::numeric_limits<double>::infinity()) {
          const Index at = add_vertex(*next, {first, second}, face.line);
          add_edge(face, before, from, at, first);
          add_edge(face, before, at, to, second);
          return;
        }
      }
    }
    fail_at(face.line, "face " + to_string(face.number) + " is open after " +
                           name(file_.edges[place_of(before.edge)]) +
                           ", and no walls close it whose curves " + name(a) + " and " + name(b) +
                           " keep to");
  }

  Index add_vertex(Vec2 place, std::vector<Index> curves, int line) {
    file_.vertices.push_back({0, place, false, std::move(curves), line});
    return static_cast<Index>(file_.vertices.size() - 1);
  }

  void add_edge(const Datafile::Face& face, Walk before, Index from, Index to, Index curve) {
    Datafile::Edge edge;
    edge.tail = from;
    edge.head = to;
    edge.tension = 0;
    edge.curves = {curve};
    edge.line = face.line;
    const Curve& along = file_.curves[place_of(curve)];
    const Vec2 a = file_.vertices[place_of(from)].place;
    const Vec2 b = file_.vertices[place_of(to)].place;
    if (along.curvature != 0) {
      const double half_angle = 0.5 * direction(face, before, along) * along.curvature *
                                way_along(face, before, along, a, b);
      const Vec2 centre = along.centre();
      edge.midpoint = add_vertex(centre + rotated(a - centre, half_angle), {curve}, face.line);
    }
    file_.face_edges.push_back({static_cast<Index>(file_.edges.size()), true});
    file_.edges.push_back(std::move(edge));
  }

  /// Whether a face's bubble lies on the left of its loop.
  bool on_left(const Datafile::Face& face) const {
    const auto index = static_cast<Index>(&face - file_.faces.data());
    const auto body = std::ranges::find(file_.bodies, index, &Datafile::Body::face);
    return body == file_.bodies.end() || body->forwards;
  }

  /// In which a face's loop goes on along a curve after one of its edges: 1 as the curve, -1
  /// against it. The edge lies on the face's side of the curve.
  double direction(const Datafile::Face& face, Walk before, const Curve& along) const {
    const Vec2 middle = file_.start_place(before) +
                        (file_.bends(before) ? file_.middle(before) : 0.5 * file_.chord(before));
    return (along.distance(middle) > 0) == on_left(face) ? 1 : -1;
  }

  /// How far a face's loop goes along a curve from one point to another; infinity where it does
  /// not.
  double way_along(const Datafile::Face& face, Walk before, const Curve& along, Vec2 from,
                   Vec2 to) const {
    const double forwards = direction(face, before, along);
    if (along.curvature == 0) {
      const double way = forwards * dot(along.tangent, to - from);
      return way > 0 ? way : std::numeric_limits<double>::infinity();
    }
    const Vec2 centre = along.centre();
    const double angle =
        std::copysign(1.0, forwards * along.curvature) * angle_from_to(from - centre, to - centre);
    return (angle > 0 ? angle : angle + 2 * std::numbers::pi) / std::abs(along.curvature);
  }

  Datafile& file_;
};

/// A part of a wall along a single curve.
struct Run {
  Index curve = kNone; ///< none of a FIXED edge, which is one by itself
  Vec2 start;
  Vec2 chord;
  double half_angle = 0; ///< half of the angle by which it turns to the left: π of a whole circle
};

class Finding {
public:
  Finding(const Datafile& file, const std::vector<std::array<bool, 2>>& beside)
      : file_(file), beside_(beside) {}

  WallsOfDatafile run() {
    found_.of_edge.assign(file_.edges.size(), kNone);
    found_.of_vertex.assign(file_.vertices.size(), false);
    find_edges();
    for (std::size_t e = 0; e < file_.edges.size(); ++e) {
      if (is_wall_[e] && !seen_[e]) {
        follow(static_cast<Index>(e));
      }
    }
    check_vertices();
    number_walls();
    return std::move(found_);
  }

private:
  struct Loop {
    std::vector<Walk> walks; ///< with the foam on the left
    Wall wall;
    bool obstacle = false;
    Index first_curve = std::numeric_limits<Index>::max();
    Index first_edge = std::numeric_limits<Index>::max();
  };

  const Datafile::Edge& edge(Walk walk) const { return file_.edges[place_of(walk.edge)]; }
  const Datafile::Vertex& vertex(Index v) const { return file_.vertices[place_of(v)]; }

  static std::string keyword(const Datafile::Edge& edge) {
    return edge.fixed ? "'fixed': " : "'constraint': ";
  }

  void find_edges() {
    is_wall_.assign(file_.edges.size(), false);
    seen_.assign(file_.edges.size(), false);
    walls_at_.assign(file_.vertices.size(), {});
    films_at_.assign(file_.vertices.size(), false);
    std::optional<std::size_t> held;
    std::optional<std::size_t> free;
    for (std::size_t e = 0; e < file_.edges.size(); ++e) {
      const Datafile::Edge& edge = file_.edges[e];
      const bool between = beside_[e][0] && beside_[e][1];
      is_wall_[e] = !between && is_held(file_, edge);
      if (between && (edge.fixed || !edge.curves.empty())) {
        fail_at(edge.line, keyword(edge) + name(edge) +
                               " does not move, and has bubbles on both its sides: films that do "
                               "not are not read");
      }
      if (!between) {
        (is_wall_[e] ? held : free) = e;
      }
      for (const Index v : {edge.tail, edge.head}) {
        if (is_wall_[e]) {
          walls_at_[place_of(v)].push_back(static_cast<Index>(e));
        } else {
          films_at_[place_of(v)] = true;
        }
      }
    }
    if (held && free) {
      const Datafile::Edge& edge = file_.edges[*held];
      fail_at(edge.line, keyword(edge) + name(edge) + " does not move, but " +
                             name(file_.edges[*free]) +
                             " beside gas does, and films that do not are not read: walls enclose "
                             "all of a foam");
    }
  }

  /// The wall from an edge on, until it closes.
  void follow(Index first) {
    Loop loop;
    Walk walk{first, !beside_[place_of(first)][1]};
    do {
      seen_[place_of(walk.edge)] = true;
      loop.walks.push_back(walk);
      const Index end = file_.end(walk);
      const auto& walls = walls_at_[place_of(end)];
      if (walls.size() != 2) {
        fail_at(vertex(end).line, to_string(walls.size()) + " edges of walls meet in " +
                                      name(vertex(end)) + ", and walls are closed lines");
      }
      const Index next = walls[walls[0] == walk.edge ? 1 : 0];
      walk = {next, file_.edges[place_of(next)].tail == end};
    } while (walk.edge != first);
    take_contact(loop);
    take_pieces(loop);
    loops_.push_back(std::move(loop));
  }

  /// What films do on the wall; and that it has one tension.
  void take_contact(Loop& loop) {
    const Datafile::Edge& first = edge(loop.walks[0]);
    const Datafile::Vertex* pinned = nullptr;
    const Datafile::Vertex* slips = nullptr;
    for (const Walk walk : loop.walks) {
      if (edge(walk).tension != first.tension) {
        fail_at(edge(walk).line, name(edge(walk)) + " and " + name(first) +
                                     " are one wall, but differ in their tensions: films meet "
                                     "walls at 90 degrees");
      }
      if (films_at_[place_of(file_.start(walk))]) {
        const Datafile::Vertex& contact = vertex(file_.start(walk));
        (contact.fixed ? pinned : slips) = &contact;
      }
    }
    if (pinned != nullptr && slips != nullptr) {
      fail_at(pinned->line, "'fixed': " + name(*pinned) + " does not move, and " + name(*slips) +
                                " on the same wall does");
    }
    if (first.tension != 0) {
      found_.warnings.push_back("line " + to_string(first.line) + ": the tension of " +
                                name(first) +
                                " and of all its wall is left out: it is the same everywhere");
    }
    const bool any = pinned != nullptr || slips != nullptr;
    loop.wall.contact =
        (any ? pinned != nullptr : first.fixed) ? WallContact::Pinned : WallContact::Slip;
  }

  /// The curve that an edge of a wall lies on; none of a fixed one that lies on none.
  Index curve_of(Walk walk) const {
    const Datafile::Vertex& a = vertex(file_.start(walk));
    const Datafile::Vertex& b = vertex(file_.end(walk));
    const Index shared = common_curve(a.curves, b.curves);
    const Index curve = !edge(walk).curves.empty() ? edge(walk).curves[0] : shared;
    for (const Datafile::Vertex* end : {&a, &b}) {
      constexpr double kOn = 1e-9; // of a length that belongs to the curve
      if (curve == kNone) {
        if (!end->fixed) {
          fail_at(edge(walk).line,
                  "'fixed': " + name(edge(walk)) + " ends in " + name(*end) + ", which moves");
        }
      } else if (!keeps_to(end->curves, curve)) {
        const Curve& of = file_.curves[place_of(curve)];
        if (!end->fixed || std::abs(of.distance(end->place)) > kOn * of.scale()) {
          fail_at(end->line, "'constraint': " + name(*end) + " does not keep to the curve of " +
                                 name(edge(walk)) + ", which ends there");
        }
      }
    }
    return curve;
  }

  double half_angle(Walk walk, Index curve) const {
    const Vec2 d = file_.chord(walk);
    const double curvature = curve == kNone ? 0 : file_.curves[place_of(curve)].curvature;
    if (file_.bends(walk) && (curve == kNone || curvature != 0)) {
      return angle_from_to(file_.middle(walk), d - file_.middle(walk)); // by the inscribed angle
    }
    if (curvature == 0) {
      return 0;
    }
    const Vec2 along = tangent_of(file_.curves[place_of(curve)], file_.start_place(walk));
    const double half = std::asin(std::min(0.5 * std::abs(curvature) * norm(d), 1.0));
    return std::copysign(half, curvature * dot(along, d));
  }

  void take_pieces(Loop& loop) {
    std::vector<Run> runs;
    Wrap round;
    for (const Walk walk : loop.walks) {
      const Index curve = curve_of(walk);
      round = round + file_.wrap(walk);
      loop.first_edge = std::min(loop.first_edge, walk.edge);
      loop.first_curve =
          std::min(loop.first_curve, curve == kNone ? std::numeric_limits<Index>::max() : curve);
      const Run run{curve, file_.start_place(walk), file_.chord(walk), half_angle(walk, curve)};
      if (!std::isfinite(run.start.x + run.start.y + run.chord.x + run.chord.y + run.half_angle)) {
        fail_at(edge(walk).line, name(edge(walk)) + " is part of a wall without end");
      }
      if (!runs.empty() && curve != kNone && runs.back().curve == curve) {
        append(runs.back(), run);
      } else {
        runs.push_back(run);
      }
    }
    if (runs.size() > 1 && runs[0].curve != kNone && runs[0].curve == runs.back().curve) {
      append(runs.back(), runs[0]);
      runs[0] = runs.back();
      runs.pop_back();
    }
    std::erase_if(runs, [](const Run& r) { return r.chord == Vec2{} && r.half_angle == 0; });
    check_closed(loop, runs, round);
    const auto first = std::ranges::find(runs, loop.first_curve, &Run::curve);
    std::rotate(runs.begin(), first == runs.end() ? runs.begin() : first, runs.end());
    for (const Run& run : runs) {
      add_pieces(run, loop.wall.pieces);
    }
    orient(loop);
  }

  static void append(Run& run, const Run& next) {
    run.chord += next.chord;
    run.half_angle += next.half_angle;
  }

  void check_closed(const Loop& loop, const std::vector<Run>& runs, Wrap round) const {
    const Datafile::Edge& first = edge(loop.walks[0]);
    const std::string wall = "the wall of " + name(first);
    if (runs.empty()) {
      fail_at(first.line, wall + " has no length");
    }
    const bool line = runs.size() == 1 && runs[0].half_angle == 0;
    if (!(round == Wrap{}) && !line) {
      fail_at(first.line, wall + " goes round the torus, and is no straight line");
    }
    if (!(round == Wrap{}) && runs[0].chord.y != 0) {
      fail_at(first.line, wall + " is that of a channel, which must run along x, but goes " +
                              number(runs[0].chord));
    }
    if (round == Wrap{} && line) {
      fail_at(first.line, wall + " encloses nothing");
    }
  }

  void add_pieces(const Run& run, std::vector<WallPiece>& pieces) const {
    constexpr double kQuarter = 0.5 * std::numbers::pi; // in half-angles, half a circle
    constexpr double kRounding = 1e-9;
    if (run.curve != kNone && std::abs(run.half_angle) > std::numbers::pi - kRounding) {
      const Curve& circle = file_.curves[place_of(run.curve)];
      for (const WallPiece& piece : whole_circle(circle.centre(), 1 / std::abs(circle.curvature),
                                                 std::copysign(1.0, run.half_angle))) {
        pieces.push_back(piece);
      }
      return;
    }
    const int parts = std::max(1, static_cast<int>(std::ceil(std::abs(run.half_angle) / kQuarter)));
    WallPiece whole{run.start, run.chord, run.half_angle};
    Vec2 at = run.start;
    for (int k = 1; k <= parts; ++k) {
      const Vec2 end = k == parts ? run.start + run.chord
                                  : arc_point(whole.start, whole.chord, whole.half_angle,
                                              static_cast<double>(k) / parts);
      pieces.push_back({at, end - at, run.half_angle / parts});
      at = end;
    }
  }

  /// Walks a wall on which no film ends clockwise: it is an obstacle.
  void orient(Loop& loop) const {
    double twice_area = 0;
    for (const WallPiece& piece : loop.wall.pieces) {
      twice_area += cross(piece.start - loop.wall.pieces[0].start, piece.chord) +
                    2 * segment_area(norm(piece.chord), piece.half_angle);
    }
    const auto [left, right] = beside_[place_of(loop.walks[0].edge)];
    if (!left && !right && twice_area > 0) {
      std::ranges::reverse(loop.wall.pieces);
      for (WallPiece& piece : loop.wall.pieces) {
        piece = {piece.end(), -piece.chord, -piece.half_angle};
      }
      twice_area = -twice_area;
    }
    loop.obstacle = loop.wall.pieces.size() > 1 && twice_area < 0;
  }

  /// What keeps to a curve, and to no wall.
  void check_vertices() {
    for (std::size_t e = 0; e < file_.edges.size(); ++e) {
      if (is_wall_[e]) {
        for (const Index v : {file_.edges[e].tail, file_.edges[e].head, file_.edges[e].midpoint}) {
          if (v != kNone) {
            found_.of_vertex[place_of(v)] = true;
          }
        }
      }
    }
    std::vector<bool> used = films_at_;
    for (std::size_t e = 0; e < file_.edges.size(); ++e) {
      if (!is_wall_[e] && file_.edges[e].midpoint != kNone) {
        used[place_of(file_.edges[e].midpoint)] = true;
      }
    }
    for (std::size_t v = 0; v < file_.vertices.size(); ++v) {
      const Datafile::Vertex& vertex = file_.vertices[v];
      if (used[v] && !found_.of_vertex[v] && !vertex.curves.empty()) {
        fail_at(vertex.line, "'constraint': " + name(vertex) +
                                 " keeps to a curve, but is not on a wall: no edge of one ends "
                                 "there");
      }
    }
  }

  void number_walls() {
    std::ranges::sort(loops_, {}, [](const Loop& loop) {
      return std::tuple(loop.obstacle, loop.first_curve, loop.first_edge);
    });
    for (const Loop& loop : loops_) {
      for (const Walk walk : loop.walks) {
        found_.of_edge[place_of(walk.edge)] = static_cast<Index>(found_.walls.size());
      }
      found_.walls.push_back(loop.wall);
    }
  }

  const Datafile& file_;
  const std::vector<std::array<bool, 2>>& beside_;
  WallsOfDatafile found_;
  std::vector<Loop> loops_;
  std::vector<bool> is_wall_;                ///< of an edge
  std::vector<bool> seen_;                   ///< of an edge
  std::vector<std::vector<Index>> walls_at_; ///< edges of walls that end in a vertex
  std::vector<bool> films_at_;               ///< whether films end in a vertex
};

} // namespace

bool is_held(const Datafile& file, const Datafile::Edge& edge) {
  return edge.fixed || !edge.curves.empty() ||
         common_curve(file.vertices[place_of(edge.tail)].curves,
                      file.vertices[place_of(edge.head)].curves) != kNone;
}

void close_faces(Datafile& file) {
  Closing(file).run();
}

WallsOfDatafile find_walls(const Datafile& file, const std::vector<std::array<bool, 2>>& beside) {
  return Finding(file, beside).run();
}

} // namespace foam::evolver
