// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolver/read_foam.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/number.h"
#include "evolver/datafile.h"
#include "evolver/tokens.h"
#include "geometry/fitted_arc.h"
#include "mesh/filling.h"
#include "mesh/film_set.h"

namespace foam {
namespace {

using evolver::Datafile;
using evolver::fail_at;
using std::to_string;

constexpr std::int64_t kOutside = -1;
/// The side of an edge on which no face was found.
constexpr Index kNothing = kNone;

std::string name(const Datafile::Vertex& vertex) {
  return "vertex " + to_string(vertex.number);
}
std::string name(const Datafile::Edge& edge) {
  return "edge " + to_string(edge.number);
}
std::string name(const Datafile::Face& face) {
  return "face " + to_string(face.number);
}

/// An edge, walked forwards or backwards.
struct Walked {
  Index edge = kNone;
  bool forwards = true;
};

class FoamOfDatafile {
public:
  explicit FoamOfDatafile(const Datafile& file) : file_(file) {}

  EvolverFoam run() {
    set_surroundings();
    find_bodies();
    find_sides();
    name_faces();
    find_ends();
    chain_films();
    take_tensions();
    complete_areas();
    result_.warnings = file_.warnings;
    check_fixed();
    result_.foam = foam_of(set_);
    check_areas();
    return std::move(result_);
  }

private:
  template <class Element> static const Element& at(const std::vector<Element>& of, Index i) {
    return of[place_of(i)];
  }

  void set_surroundings() {
    set_.time = file_.time;
    set_.surroundings.boundary = file_.torus ? Boundary::Periodic : Boundary::Free;
    if (file_.torus) {
      mirrored_ = cross(file_.first_period, file_.second_period) < 0;
      Lattice& lattice = set_.surroundings.lattice;
      lattice = {file_.origin, file_.first_period, file_.second_period};
      if (mirrored_) { // the periods go round clockwise: they change places
        std::swap(lattice.first, lattice.second);
      }
    }
  }

  Wrap wrap(const Datafile::Edge& edge) const {
    return mirrored_ ? Wrap{edge.wrap.y, edge.wrap.x} : edge.wrap;
  }
  Wrap wrap_along(Walked walked) const {
    const Wrap forwards = wrap(at(file_.edges, walked.edge));
    return walked.forwards ? forwards : -forwards;
  }
  Index start(Walked walked) const {
    const Datafile::Edge& edge = at(file_.edges, walked.edge);
    return walked.forwards ? edge.tail : edge.head;
  }
  Index end(Walked walked) const { return start({walked.edge, !walked.forwards}); }
  Vec2 chord(Walked walked) const {
    return at(file_.vertices, end(walked)).place - at(file_.vertices, start(walked)).place +
           set_.surroundings.lattice.period(wrap_along(walked));
  }
  /// Where the edge bulges most, from its start.
  Vec2 middle(Walked walked) const {
    const Datafile::Edge& edge = at(file_.edges, walked.edge);
    const Vec2 forwards =
        at(file_.vertices, edge.midpoint).place - at(file_.vertices, edge.tail).place;
    return walked.forwards ? forwards : forwards + chord(walked);
  }
  bool bends(Walked walked) const { return at(file_.edges, walked.edge).midpoint != kNone; }

  void find_bodies() {
    body_of_.assign(file_.faces.size(), kNone);
    for (std::size_t b = 0; b < file_.bodies.size(); ++b) {
      const Datafile::Body& body = file_.bodies[b];
      Index& of_face = body_of_[place_of(body.face)];
      if (of_face != kNone) {
        fail_at(body.line, name(at(file_.faces, body.face)) + " belongs to two bodies");
      }
      of_face = static_cast<Index>(b);
    }
  }

  /// Whether a face lies on the left of its edges as they are listed.
  bool counter_clockwise(Index face) const {
    const Index body = body_of_[place_of(face)];
    return body == kNone || at(file_.bodies, body).forwards;
  }

  void find_sides() {
    sides_.assign(file_.edges.size(), {kNothing, kNothing});
    for (std::size_t f = 0; f < file_.faces.size(); ++f) {
      const Datafile::Face& face = file_.faces[f];
      const auto index = static_cast<Index>(f);
      check_closed(face);
      for (Index k = face.begin; k < face.end; ++k) {
        const auto [edge, forwards] = at(file_.face_edges, k);
        const bool left = forwards == counter_clockwise(index);
        Index& side = sides_[place_of(edge)][left ? 0 : 1];
        if (side != kNothing) {
          fail_at(face.line, name(at(file_.edges, edge)) + " has " + name(face) + " and " +
                                 name(at(file_.faces, side)) + " on the same side");
        }
        side = index;
      }
    }
  }

  void check_closed(const Datafile::Face& face) const {
    Wrap around;
    for (Index k = face.begin; k < face.end; ++k) {
      const Index following = k + 1 < face.end ? k + 1 : face.begin;
      const auto [edge, forwards] = at(file_.face_edges, k);
      const auto [next, next_forwards] = at(file_.face_edges, following);
      if (end({edge, forwards}) != start({next, next_forwards})) {
        fail_at(face.line, name(face) + " is open after " + name(at(file_.edges, edge)));
      }
      around = around + wrap_along({edge, forwards});
    }
    if (!(around == Wrap{})) {
      fail_at(face.line, "the edges of " + name(face) + " do not close on the torus");
    }
  }

  /// Twice the area that the straight lines between a face's vertices enclose.
  double twice_polygon(const Datafile::Face& face) const {
    double twice = 0;
    Vec2 from;
    for (Index k = face.begin; k < face.end; ++k) {
      const auto [edge, forwards] = at(file_.face_edges, k);
      const Vec2 d = chord({edge, forwards});
      twice += cross(from, d) + (bends({edge, forwards}) ? cross(middle({edge, forwards}), d) : 0);
      from += d;
    }
    return twice;
  }

  /// The bubble that each face is. A face without a body is the outside of a free foam, which its
  /// loop has on its right, and on a torus a bubble that takes what the others leave.
  void name_faces() {
    std::set<std::int64_t> names;
    for (const Datafile::Body& body : file_.bodies) {
      names.insert(body.name.value_or(body.number));
    }
    const bool named =
        names.size() == file_.bodies.size() && (names.empty() || *names.begin() >= 0);
    std::int64_t next = 0;
    bubble_of_.assign(file_.faces.size(), kOutside);
    for (const Datafile::Body& body : file_.bodies) {
      const std::int64_t id = named ? body.name.value_or(body.number) : body.number;
      bubble_of_[place_of(body.face)] = id;
      next = std::max(next, id + 1);
      add_bubble(id, body.pressure, body.volume, body.volume_constant, body.line,
                 "body " + to_string(body.number));
    }
    for (std::size_t f = 0; f < file_.faces.size(); ++f) {
      const Datafile::Face& face = file_.faces[f];
      if (body_of_[f] != kNone) {
        continue;
      }
      if (file_.torus) {
        bubble_of_[f] = next;
        add_bubble(next++, 0, std::nullopt, 0, face.line, name(face));
      } else if (twice_polygon(face) > 0) {
        fail_at(face.line,
                name(face) + " belongs to no body with a VOLUME: bubbles have a given area");
      }
    }
    std::ranges::sort(set_.bubbles, {}, &FilmSet::Bubble::id);
  }

  void add_bubble(std::int64_t id, double pressure, std::optional<double> volume, double constant,
                  int line, const std::string& name) {
    // On a torus the constant makes up for where the cell's edges run, as Evolver dumps it.
    const double area = volume ? *volume - (file_.torus ? 0 : constant) : 0;
    if (volume && !(area > 0)) {
      fail_at(line, "the area of " + name + " must be positive, but is " + number(area));
    }
    if (!volume && (!file_.torus || std::exchange(rest_, id) != kOutside)) {
      fail_at(line, name + " has no VOLUME: bubbles have a given area" +
                        (file_.torus ? ", but for one on a torus" : ""));
    }
    set_.bubbles.push_back({id, pressure, area});
  }

  void find_ends() {
    std::vector<bool> midpoint(file_.vertices.size(), false);
    for (const Datafile::Edge& edge : file_.edges) {
      if (edge.midpoint != kNone) {
        midpoint[place_of(edge.midpoint)] = true;
      }
    }
    leaving_.assign(file_.vertices.size(), {});
    valence_.assign(file_.vertices.size(), 0);
    for (std::size_t e = 0; e < file_.edges.size(); ++e) {
      for (const bool forwards : {true, false}) {
        const Walked walked{static_cast<Index>(e), forwards};
        const std::size_t vertex = place_of(start(walked));
        if (valence_[vertex] == 3) {
          const Datafile::Vertex& found = file_.vertices[vertex];
          fail_at(found.line,
                  "more than three edges meet in " + name(found) + ": films meet three by three");
        }
        leaving_[vertex][valence_[vertex]++] = walked;
      }
    }
    junction_of_.assign(file_.vertices.size(), kNone);
    for (std::size_t v = 0; v < file_.vertices.size(); ++v) {
      const Datafile::Vertex& vertex = file_.vertices[v];
      if (valence_[v] == 3) {
        junction_of_[v] = static_cast<Index>(set_.junctions.size());
        set_.junctions.push_back(vertex.place);
      } else if (valence_[v] == 1) {
        fail_at(vertex.line, "a single edge ends in " + name(vertex));
      }
      if (midpoint[v] && valence_[v] > 0) {
        fail_at(vertex.line, name(vertex) + " is an edge's midpoint and another's end");
      }
    }
  }

  /// The film's next edge, in whose start two meet.
  Walked following(Walked walked) const {
    const auto& leaving = leaving_[place_of(end(walked))];
    const bool first = leaving[0].edge == walked.edge && leaving[0].forwards != walked.forwards;
    return leaving[first ? 1 : 0];
  }
  bool ends_film(Index vertex) const { return junction_of_[place_of(vertex)] != kNone; }

  void chain_films() {
    std::vector<bool> seen(file_.edges.size(), false);
    for (std::size_t e = 0; e < file_.edges.size(); ++e) {
      if (!seen[e]) {
        add_film(chain_through(static_cast<Index>(e)), seen);
      }
    }
  }

  /// The edges of a film from one end to the other.
  std::vector<Walked> chain_through(Index edge) const {
    Walked first{edge, true};
    while (!ends_film(start(first))) {
      const Walked before = following({first.edge, !first.forwards});
      first = {before.edge, !before.forwards};
      if (first.edge == edge) {
        const Datafile::Edge& of = at(file_.edges, edge);
        fail_at(of.line, name(of) + " belongs to a film that ends in no junction");
      }
    }
    std::vector<Walked> chain{first};
    while (!ends_film(end(chain.back()))) {
      chain.push_back(following(chain.back()));
    }
    return chain;
  }

  std::array<Index, 2> sides(Walked walked) const {
    const auto [left, right] = sides_[place_of(walked.edge)];
    return walked.forwards ? std::array{left, right} : std::array{right, left};
  }

  void add_film(const std::vector<Walked>& chain, std::vector<bool>& seen) {
    const Datafile::Edge& first = at(file_.edges, chain.front().edge);
    PathOfFilm path;
    FilmSet::Film film;
    for (const Walked walked : chain) {
      const Datafile::Edge& edge = at(file_.edges, walked.edge);
      seen[place_of(walked.edge)] = true;
      if (sides(walked) != sides(chain.front()) || edge.tension != first.tension) {
        fail_at(edge.line, name(edge) + " and " + name(first) +
                               " are one film, but differ in their faces or tensions");
      }
      film.wrap = film.wrap + wrap_along(walked);
      const Vec2 d = chord(walked);
      if (bends(walked)) {
        path.add_arc(middle(walked), d);
      } else {
        path.add(d);
      }
    }
    film.start = junction_of_[place_of(start(chain.front()))];
    film.end = junction_of_[place_of(end(chain.back()))];
    if (path.chord() == Vec2{}) {
      fail_at(first.line, name(first) + " belongs to a film that ends where it begins");
    }
    film.half_angle = path.half_angle();
    result_.largest_misfit = std::max(result_.largest_misfit, path.misfit(film.half_angle));
    const auto [left, right] = sides(chain.front());
    film.left = bubble(left, first);
    film.right = bubble(right, first);
    set_.films.push_back(film);
    set_.tensions.push_back(first.tension);
  }

  std::int64_t bubble(Index face, const Datafile::Edge& edge) const {
    if (face != kNothing) {
      return bubble_of_[place_of(face)];
    }
    if (file_.torus) {
      fail_at(edge.line,
              name(edge) + " has a face on one side only: the foam does not fill its torus");
    }
    return kOutside;
  }

  void take_tensions() {
    std::vector<double> sorted = set_.tensions;
    if (sorted.empty()) {
      throw FoamError("the file has no edges");
    }
    const auto median = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::ranges::nth_element(sorted, median);
    set_.surface_tension = 0.5 * *median;
    if (std::ranges::count(sorted, *median) == std::ssize(sorted)) {
      set_.tensions.clear();
    }
  }

  /// One bubble of a torus may have what the others leave.
  void complete_areas() {
    if (rest_ == kOutside) {
      return;
    }
    double others = 0;
    for (const auto& bubble : set_.bubbles) {
      others += bubble.target_area;
    }
    const auto rest = std::ranges::find(set_.bubbles, rest_, &FilmSet::Bubble::id);
    rest->target_area = set_.surroundings.lattice.area() - others;
  }

  /// A single fixed vertex says where a foam is that could be anywhere else.
  void check_fixed() {
    std::vector<const Datafile::Vertex*> fixed;
    for (const Datafile::Vertex& vertex : file_.vertices) {
      if (vertex.fixed) {
        fixed.push_back(&vertex);
      }
    }
    if (fixed.size() > 1) {
      fail_at(fixed[1]->line, "'fixed': " + name(*fixed[1]) + " and " + name(*fixed[0]) +
                                  " do not move, and junctions that do not are not read");
    }
    if (fixed.size() == 1) {
      result_.warnings.push_back("line " + to_string(fixed[0]->line) + ": 'fixed' is not kept: " +
                                 name(*fixed[0]) + " moves with the foam");
    }
  }

  void check_areas() {
    Foam& foam = result_.foam;
    for (const Bubble b : foam.bubble_slots()) {
      if (!(foam.area(b) > 0)) {
        throw FoamError("the area of bubble " + to_string(foam.bubble_id[b]) + " is " +
                        number(foam.area(b)) + ": are its edges listed clockwise?");
      }
    }
    const double scale =
        fill_space(foam, kMeasuredAreas, "the VOLUMEs of bodies do not fit PERIODS");
    constexpr double kUntold = 1e-6;
    if (std::abs(scale - 1) > kUntold) {
      result_.warnings.push_back(
          "the VOLUMEs of the bodies do not fill the torus: they were scaled by " + number(scale));
    }
  }

  const Datafile& file_;
  EvolverFoam result_;
  FilmSet set_;
  bool mirrored_ = false;
  std::int64_t rest_ = kOutside;               ///< the bubble that has what the others leave
  std::vector<Index> body_of_;                 ///< of a face
  std::vector<std::int64_t> bubble_of_;        ///< of a face
  std::vector<std::array<Index, 2>> sides_;    ///< of an edge: the faces left and right
  std::vector<std::array<Walked, 3>> leaving_; ///< of a vertex
  std::vector<std::size_t> valence_;           ///< of a vertex
  std::vector<Index> junction_of_;             ///< of a vertex
};

} // namespace

EvolverFoam read_evolver(std::string text, std::function<std::string(const std::string&)> include) {
  const Datafile file = evolver::parse_datafile(std::move(text), std::move(include));
  return FoamOfDatafile(file).run();
}

} // namespace foam
