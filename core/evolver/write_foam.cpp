// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolver/write_foam.h"

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

#include "base/error.h"
#include "base/number.h"
#include "geometry/arc.h"

namespace foam {
namespace {

using std::to_string;

class Writer {
public:
  explicit Writer(const Foam& foam)
      : foam_(foam), touched_(foam.exterior.size(), 0), edges_(foam.film_angle.size()) {}

  std::string run() {
    if (foam_.exterior.size() > 1 && !foam_.surroundings.has_walls()) {
      throw FoamError("a foam in several gases cannot be written for Surface Evolver: free ones, "
                      "those on a torus and those between walls can");
    }
    header();
    constraints();
    junctions();
    corners();
    films();
    untouched_walls();
    sort_bubbles();
    std::string text = header_text_ + "\nVERTICES\n" + vertex_text_ + "\nEDGES\n" + edge_text_;
    text += "\nFACES\n" + faces() + "\nBODIES\n" + bodies() + "\nREAD\n";
    return text;
  }

private:
  void header() {
    header_text_ = "// A foam of " + to_string(foam_.bubble_count()) +
                   " bubbles. A film's tension is both of its surfaces'.\nSTRING\n"
                   "SPACE_DIMENSION 2\n";
    if (foam_.surroundings.has_images()) {
      const bool torus = foam_.surroundings.periodic();
      const auto& [origin, first, second] = foam_.surroundings.lattice;
      header_text_ += torus ? "TORUS_FILLED\nPERIODS\n" : "TORUS\nPERIODS\n";
      header_text_ += place(first) + "\n";
      header_text_ += place(torus ? second : Vec2{0, first.x}) + "\n"; // a channel has none
      header_text_ += "DISPLAY_ORIGIN" + place(origin) + "\n";
    }
    header_text_ += "QUADRATIC\nLENGTH_METHOD_NAME \"circular_arc_length\"\n"
                    "AREA_METHOD_NAME \"circular_arc_area\"\n"
                    "DEFINE BODY ATTRIBUTE BubbleId REAL\nTOTAL_TIME " +
                    number(foam_.time) + "\n";
  }

  static std::string place(Vec2 p) { return " " + number(p.x) + " " + number(p.y); }

  /// The lines and circles that the pieces of walls lie on.
  void constraints() {
    constraint_.assign(foam_.wall_piece.size(), 0);
    int count = 0;
    for (const Piece p : foam_.piece_slots()) {
      if (p.index() > 0 && on_one_circle(Piece(p.index() - 1), p)) {
        constraint_[p] = count;
        continue;
      }
      constraint_[p] = ++count;
      header_text_ += "CONSTRAINT " + to_string(count) + "\nFORMULA: ";
      const WallPiece& piece = foam_.wall_piece[p];
      if (piece.half_angle == 0) {
        const Vec2 normal = left_normal((1 / norm(piece.chord)) * piece.chord);
        header_text_ += "(" + number(normal.x) + ")*" + less("x", piece.start.x) + " + (" +
                        number(normal.y) + ")*" + less("y", piece.start.y) + " = 0\n";
      } else {
        const Vec2 centre = piece.centre();
        header_text_ += less("x", centre.x) + "^2 + " + less("y", centre.y) +
                        "^2 = " + number(norm(piece.start - centre)) + "^2\n";
      }
    }
  }
  static std::string less(const std::string& variable, double value) {
    return "(" + variable + " - (" + number(value) + "))";
  }
  bool on_one_circle(Piece before, Piece piece) const {
    const WallPiece& a = foam_.wall_piece[before];
    const WallPiece& b = foam_.wall_piece[piece];
    constexpr double kSame = 1e-12; // of a radius
    return foam_.piece_outside[before] == foam_.piece_outside[piece] &&
           a.half_angle * b.half_angle > 0 &&
           norm(a.centre() - b.centre()) * std::abs(a.curvature()) < kSame &&
           std::abs(b.curvature() / a.curvature() - 1) < kSame;
  }

  int add_vertex(Vec2 at, const std::string& attributes = "") {
    vertex_text_ += to_string(++vertices_) + place(at) + attributes + "\n";
    return vertices_;
  }

  void junctions() {
    vertex_.assign(foam_.position.size(), 0);
    corner_.assign(foam_.wall_piece.size(), 0);
    for (const Junction j : foam_.junction_slots()) {
      if (foam_.has_junction(j)) {
        vertex_[j] = add_vertex(foam_.position[j], keeping(j));
        if (foam_.on_wall(j)) {
          const Piece piece = foam_.junction_piece[j];
          touched_[foam_.piece_outside[piece]] = 1;
          if (foam_.position[j] == foam_.wall_piece[piece].start) {
            corner_[piece] = vertex_[j];
          }
        }
      }
    }
  }

  std::string on(Piece piece) const { return " CONSTRAINT " + to_string(constraint_[piece]); }
  bool pinned(Piece piece) const {
    return foam_.exterior[foam_.piece_outside[piece]].contact == WallContact::Pinned;
  }

  /// How a junction keeps to a wall. An edge that holds it lies on two curves.
  std::string keeping(Junction j) const {
    if (!foam_.on_wall(j)) {
      return "";
    }
    const Piece piece = foam_.junction_piece[j];
    if (pinned(piece)) {
      return " FIXED";
    }
    return foam_.freedom(j).any()
               ? on(piece)
               : " CONSTRAINTS " + to_string(constraint_[neighbour_piece(foam_, piece, -1)]) + " " +
                     to_string(constraint_[piece]);
  }

  /// Where pieces of walls start, but for where films end there.
  void corners() {
    for (const Piece p : foam_.piece_slots()) {
      if (corner_[p] == 0 && !is_line(foam_.exterior[foam_.piece_outside[p]])) {
        corner_[p] = add_vertex(foam_.wall_piece[p].start, " FIXED");
      }
    }
  }

  int add_edge(int tail, int head, int midpoint, const std::string& attributes) {
    edge_text_ += to_string(++edge_count_) + " " + to_string(tail) + " " + to_string(head) + " " +
                  to_string(midpoint) + attributes + "\n";
    return edge_count_;
  }
  std::string wraps(Film f) const {
    return foam_.surroundings.has_images() ? wrap(foam_.wrap(f.half()), f) : "";
  }

  void films() {
    for (const Film f : foam_.film_slots()) {
      if (foam_.bends(f)) {
        const Half h = f.half();
        const int middle = add_vertex(
            arc_point(foam_.position[foam_.start(h)], foam_.chord(h), foam_.half_angle(h), 0.5));
        edges_[f].push_back(add_edge(vertex_[foam_.start(h)], vertex_[foam_.end(h)], middle,
                                     wraps(f) + " TENSION " + number(foam_.tension(f))));
      } else if (foam_.has_film(f)) {
        add_stretch(f);
      }
    }
  }

  /// A part of a wall, walked with the foam on its left.
  struct WallEdge {
    WallPiece part;
    Piece piece; ///< that it is a part of
    int tail = 0;
    int head = 0;
  };

  int add_wall_edge(const WallEdge& edge, bool backwards, const std::string& wraps) {
    const auto& [part, piece, tail, head] = edge;
    const int middle = add_vertex(arc_point(part.start, part.chord, part.half_angle, 0.5),
                                  pinned(piece) ? " FIXED" : on(piece));
    return add_edge(backwards ? head : tail, backwards ? tail : head, middle,
                    wraps + on(piece) + (pinned(piece) ? " FIXED" : "") + " TENSION 0");
  }

  /// The edges of a stretch of a wall, as its film runs.
  void add_stretch(Film f) {
    const Half h = f.half();
    const bool backwards = foam_.solid(foam_.left(h));
    const Outside wall = (backwards ? foam_.left(h) : foam_.right(h)).outside();
    std::vector<WallEdge> edges;
    foam_.for_each_wall_part(h, [&](const WallPiece& part, double /*corner*/) {
      const Piece piece =
          nearest_piece(foam_, wall, arc_point(part.start, part.chord, part.half_angle, 0.5));
      if (!edges.empty()) {
        edges.back().head = corner_[piece];
      }
      edges.push_back({part, piece, corner_[piece], 0});
    });
    edges.front().tail = vertex_[backwards ? foam_.end(h) : foam_.start(h)];
    edges.back().head = vertex_[backwards ? foam_.start(h) : foam_.end(h)];
    if (is_line(foam_.exterior[wall])) { // which has images
      edges.front().part.start = foam_.position[backwards ? foam_.end(h) : foam_.start(h)];
    }
    if (backwards) {
      std::ranges::reverse(edges);
    }
    for (const WallEdge& edge : edges) {
      edges_[f].push_back(add_wall_edge(edge, backwards, wraps(f)));
    }
  }

  /// Obstacles in bubbles.
  void untouched_walls() {
    for (const Piece p : foam_.piece_slots()) {
      if (!touched_[foam_.piece_outside[p]]) {
        add_wall_edge({foam_.wall_piece[p], p, corner_[p], corner_[neighbour_piece(foam_, p, 1)]},
                      false, foam_.surroundings.has_images() ? wrap({}, Film(0)) : "");
      }
    }
  }

  /// Signs for what they can say, and six bits a dimension for the rest, of which five are a number
  /// in two's complement.
  static std::string wrap(Wrap w, Film film) {
    const auto within = [&](int low, int high) {
      return std::min(w.x, w.y) >= low && std::max(w.x, w.y) <= high;
    };
    if (within(-1, 1)) {
      const auto sign = [](int n) { return n < 0 ? " -" : (n > 0 ? " +" : " *"); };
      return std::string(sign(w.x)) + sign(w.y);
    }
    if (!within(-16, 15)) {
      throw FoamError("film " + to_string(film.index()) + " goes " + to_string(w.x) + " and " +
                      to_string(w.y) +
                      " times round the torus; Surface Evolver counts from -16 to 15");
    }
    return " WRAP " + to_string((w.x & 31) + ((w.y & 31) << 6));
  }

  void sort_bubbles() {
    for (const Bubble b : foam_.bubble_slots()) {
      if (foam_.has_bubble(b)) {
        bubbles_.push_back(b);
      }
    }
    std::ranges::sort(bubbles_, {}, [&](Bubble b) { return foam_.bubble_id[b]; });
  }

  std::string faces() const {
    std::string text;
    for (std::size_t k = 0; k < bubbles_.size(); ++k) {
      text += to_string(k + 1);
      for_each_half(foam_, bubbles_[k], [&](Half h) {
        const std::vector<int>& edges = edges_[h.film()];
        for (std::size_t i = 0; i < edges.size(); ++i) {
          text += h.reversed() ? " -" + to_string(edges[edges.size() - 1 - i])
                               : " " + to_string(edges[i]);
        }
      });
      text += "\n";
    }
    return text;
  }

  /// Between walls one bubble has what the others leave, as Surface Evolver cannot tell that their
  /// areas add up; pressures are above its, or else the outside's.
  std::string bodies() const {
    const bool walls = foam_.surroundings.has_walls();
    const double outside = walls                    ? foam_.pressure[bubbles_.back()]
                           : foam_.exterior.empty() ? 0
                                                    : foam_.exterior[Outside(0)].pressure;
    std::string text;
    for (std::size_t k = 0; k < bubbles_.size(); ++k) {
      const Bubble b = bubbles_[k];
      text += to_string(k + 1) + " " + to_string(k + 1);
      if (!walls || b != bubbles_.back()) {
        text += " VOLUME " + number(foam_.target_area[b]) + " LAGRANGE_MULTIPLIER " +
                number(foam_.pressure[b] - outside);
      }
      if (walls && foam_.hosts_wall(b)) {
        text += " VOLCONST " + number(hosted_area(b));
      }
      text += " BubbleId " + to_string(foam_.bubble_id[b]) + "\n";
    }
    return text;
  }

  /// Of the obstacles in a bubble, as its edges do not go round them.
  double hosted_area(Bubble b) const {
    double sum = 0;
    for (const Outside wall : foam_.outside_slots()) {
      sum += foam_.exterior[wall].host == b ? foam_.area_of_wall(wall) : 0;
    }
    return sum;
  }

  const Foam& foam_;
  std::string header_text_;
  std::string vertex_text_;
  std::string edge_text_;
  int vertices_ = 0; ///< so far
  int edge_count_ = 0;
  Field<Junction, int> vertex_;         ///< a junction's number in the file
  Field<Piece, int> constraint_;        ///< number of the one that a piece lies on
  Field<Piece, int> corner_;            ///< number of the vertex in which a piece starts
  Field<Outside, char> touched_;        ///< whether films end on a wall
  Field<Film, std::vector<int>> edges_; ///< a film's numbers in the file, from its start
  std::vector<Bubble> bubbles_;
};

} // namespace

std::string write_evolver(const Foam& foam) {
  return Writer(foam).run();
}

} // namespace foam
