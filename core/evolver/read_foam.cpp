// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolver/read_foam.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <set>
#include <utility>

#include "base/error.h"
#include "base/number.h"
#include "evolver/datafile.h"
#include "evolver/find_walls.h"
#include "evolver/tokens.h"
#include "geometry/fitted_arc.h"
#include "mesh/filling.h"
#include "mesh/film_set.h"
#include "mesh/validate.h"

namespace foam {
namespace {

using evolver::Datafile;
using evolver::fail_at;
using std::to_string;

constexpr std::int64_t kOutside = -1;
/// The side of an edge on which no face was found.
constexpr Index kNothing = kNone;
/// Of a wall.
constexpr double kNoTension = -std::numeric_limits<double>::infinity();

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
using Walked = Datafile::FaceEdge;

class FoamOfDatafile {
public:
  explicit FoamOfDatafile(const Datafile& file)
      : file_(file), held_(std::ranges::any_of(file.edges, [&](const Datafile::Edge& edge) {
          return is_held(file, edge);
        })) {}

  EvolverFoam run() {
    set_surroundings();
    find_bodies();
    find_sides();
    result_.warnings = file_.warnings;
    name_faces();
    take_walls();
    find_ends();
    chain_films();
    take_tensions();
    check_fixed();
    result_.foam = foam_of(set_);
    check_areas();
    complete_areas();
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

  Wrap wrap_along(Walked walked) const {
    const Wrap wrap = file_.wrap(walked);
    return mirrored_ ? Wrap{wrap.y, wrap.x} : wrap;
  }

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
      around = around + file_.wrap(at(file_.face_edges, k));
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
      const Walked walked = at(file_.face_edges, k);
      const Vec2 d = file_.chord(walked);
      twice += cross(from, d) + (file_.bends(walked) ? cross(file_.middle(walked), d) : 0);
      from += d;
    }
    return twice;
  }

  /// Whether the edges of a face are those of a wall.
  bool is_solid(const Datafile::Face& face) const {
    return std::all_of(file_.face_edges.begin() + face.begin, file_.face_edges.begin() + face.end,
                       [&](Walked walked) {
                         const Datafile::Edge& edge = at(file_.edges, walked.edge);
                         return edge.fixed || !edge.curves.empty();
                       });
  }

  /// The bubble that each face is. A face without a body is an obstacle where its edges are walls.
  /// Else it is the outside of a free foam, which its loop has on its right, and on a torus a
  /// bubble that takes what the others leave.
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
      if (body_of_[f] != kNone || is_solid(face)) {
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
    check_volumes();
  }

  /// One body of a torus, or between walls, may have what the others leave; where none at all has a
  /// VOLUME, as of grains, all have what they have.
  void check_volumes() {
    const bool closed = file_.torus || held_;
    const std::size_t without = without_volume_.size();
    if (without == set_.bubbles.size() && without > 1) {
      measured_ = true;
      result_.warnings.push_back("line " + to_string(without_volume_[0].line) +
                                 ": no body has a VOLUME: target areas are those that they have");
    } else if (without > (closed ? 1 : 0)) {
      const auto& [id, line, name] = without_volume_[closed ? 1 : 0];
      fail_at(line, name + " has no VOLUME, and others have: bubbles have a given area" +
                        (closed ? ", but for one on a torus or between walls" : ""));
    } else if (without == 1) {
      rest_ = without_volume_[0].id;
    }
  }

  void add_bubble(std::int64_t id, double pressure, std::optional<double> volume, double constant,
                  int line, const std::string& name) {
    // On a torus the constant makes up for where the cell's edges run, as Evolver dumps it.
    const double area = volume ? *volume - (file_.torus ? 0 : constant) : 1; // until it is known
    if (!(area > 0)) {
      fail_at(line, "the area of " + name + " must be positive, but is " + number(area));
    }
    if (!volume) {
      without_volume_.push_back({id, line, name});
    }
    set_.bubbles.push_back({id, pressure, area});
  }

  /// The bubble, or the outside, that is left of an edge and right of it.
  std::array<std::int64_t, 2> bubbles(Walked walked) const {
    const auto [left, right] = sides_[place_of(walked.edge)];
    const auto bubble = [&](Index face) {
      const std::int64_t found = face == kNothing ? kOutside : bubble_of_[place_of(face)];
      const Index wall = walls_.of_edge[place_of(walked.edge)];
      return found == kOutside && wall != kNone ? kOutside - wall : found;
    };
    return walked.forwards ? std::array{bubble(left), bubble(right)}
                           : std::array{bubble(right), bubble(left)};
  }
  bool is_wall(Index edge) const { return walls_.of_edge[place_of(edge)] != kNone; }

  void take_walls() {
    walls_.of_edge.assign(file_.edges.size(), kNone);
    std::vector<std::array<bool, 2>> beside(file_.edges.size());
    for (std::size_t e = 0; e < file_.edges.size(); ++e) {
      const auto [left, right] = bubbles({static_cast<Index>(e), true});
      beside[e] = {left != kOutside, right != kOutside};
    }
    walls_ = find_walls(file_, beside);
    result_.warnings.insert(result_.warnings.end(), walls_.warnings.begin(), walls_.warnings.end());
    if (walls_.walls.empty()) {
      return;
    }
    for (const Wall& wall : walls_.walls) {
      Exterior& solid = set_.exteriors.emplace_back();
      solid.kind = Exterior::Kind::Solid;
      solid.contact = wall.contact;
      solid.first_piece = static_cast<Index>(set_.wall_pieces.size());
      solid.pieces = static_cast<Index>(wall.pieces.size());
      set_.wall_pieces.insert(set_.wall_pieces.end(), wall.pieces.begin(), wall.pieces.end());
    }
    set_.surroundings.boundary = Boundary::Container;
    Lattice& lattice = set_.surroundings.lattice;
    const Vec2 period = lattice.first;
    lattice = {file_.origin, {}, {}};
    if (file_.torus) {
      take_channel(period);
    }
  }

  /// Walls on a torus are those of a channel along x.
  void take_channel(Vec2 period) {
    const auto round = std::ranges::count_if(
        walls_.walls, [](const Wall& wall) { return wall.pieces.size() == 1; });
    if (round != 2 || !(period.x > 0) || period.y != 0) {
      throw FoamError("foams on a torus have walls only as channels along its first period, which "
                      "must be along x, but is " +
                      number(period) + ", and " + to_string(round) + " walls go along it");
    }
    set_.surroundings.lattice.first = period;
    for (const Exterior& wall : set_.exteriors) {
      if (wall.pieces == 1) { // begins anywhere, and so where the cell does
        WallPiece& line = set_.wall_pieces[place_of(wall.first_piece)];
        line.start.x = file_.origin.x + (line.chord.x > 0 ? 0 : period.x);
      }
    }
    for (std::size_t e = 0; e < file_.edges.size(); ++e) {
      if (wrap_along({static_cast<Index>(e), true}).y != 0) {
        fail_at(file_.edges[e].line,
                name(file_.edges[e]) + " wraps across the channel that the walls make");
      }
    }
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
        const std::size_t vertex = place_of(file_.start(walked));
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
    const auto& leaving = leaving_[place_of(file_.end(walked))];
    const bool first = leaving[0].edge == walked.edge && leaving[0].forwards != walked.forwards;
    return leaving[first ? 1 : 0];
  }
  bool ends_film(Index vertex) const { return junction_of_[place_of(vertex)] != kNone; }

  void chain_films() {
    std::vector<bool> seen(file_.edges.size(), false);
    for (std::size_t e = 0; e < file_.edges.size(); ++e) {
      const bool hosted = is_wall(static_cast<Index>(e)) && !has_bubble(static_cast<Index>(e));
      if (!seen[e] && !hosted) {
        add_film(chain_through(static_cast<Index>(e)), seen);
      }
    }
  }

  bool has_bubble(Index edge) const {
    const auto [left, right] = bubbles({edge, true});
    return left >= 0 || right >= 0;
  }

  /// The edges of a film from one end to the other.
  std::vector<Walked> chain_through(Index edge) const {
    Walked first{edge, true};
    while (!ends_film(file_.start(first))) {
      const Walked before = following({first.edge, !first.forwards});
      first = {before.edge, !before.forwards};
      if (first.edge == edge) {
        const Datafile::Edge& of = at(file_.edges, edge);
        fail_at(of.line, name(of) + " belongs to a film that ends in no junction");
      }
    }
    std::vector<Walked> chain{first};
    while (!ends_film(file_.end(chain.back()))) {
      chain.push_back(following(chain.back()));
    }
    return chain;
  }

  void add_film(const std::vector<Walked>& chain, std::vector<bool>& seen) {
    const Datafile::Edge& first = at(file_.edges, chain.front().edge);
    PathOfFilm path;
    FilmSet::Film film;
    for (const Walked walked : chain) {
      const Datafile::Edge& edge = at(file_.edges, walked.edge);
      seen[place_of(walked.edge)] = true;
      if (bubbles(walked) != bubbles(chain.front()) || edge.tension != first.tension) {
        fail_at(edge.line, name(edge) + " and " + name(first) +
                               " are one film, but differ in their faces or tensions");
      }
      film.wrap = film.wrap + wrap_along(walked);
      const Vec2 d = file_.chord(walked);
      if (file_.bends(walked)) {
        path.add_arc(file_.middle(walked), d);
      } else {
        path.add(d);
      }
    }
    film.start = junction_of_[place_of(file_.start(chain.front()))];
    film.end = junction_of_[place_of(file_.end(chain.back()))];
    const auto [left, right] = bubbles(chain.front());
    film.left = left;
    film.right = right;
    const bool wall = is_wall(chain.front().edge);
    if (file_.torus && !wall && std::min(left, right) == kOutside) {
      fail_at(first.line,
              name(first) + " has a face on one side only: the foam does not fill its torus");
    }
    if (!wall) {
      if (path.chord() == Vec2{}) {
        fail_at(first.line, name(first) + " belongs to a film that ends where it begins");
      }
      film.half_angle = path.half_angle();
      result_.largest_misfit = std::max(result_.largest_misfit, path.misfit(film.half_angle));
    }
    set_.films.push_back(film);
    set_.tensions.push_back(wall ? kNoTension : first.tension);
  }

  void take_tensions() {
    std::vector<double> sorted = set_.tensions;
    std::erase(sorted, kNoTension);
    if (sorted.empty()) {
      throw FoamError("the file has no edges");
    }
    const auto median = sorted.begin() + static_cast<std::ptrdiff_t>(sorted.size() / 2);
    std::ranges::nth_element(sorted, median);
    set_.surface_tension = 0.5 * *median;
    if (std::ranges::count(sorted, *median) == std::ssize(sorted)) {
      set_.tensions.clear();
    }
    std::ranges::replace(set_.tensions, kNoTension, *median);
  }

  /// A single fixed vertex says where a foam is that could be anywhere else.
  void check_fixed() {
    std::vector<const Datafile::Vertex*> fixed;
    for (std::size_t v = 0; v < file_.vertices.size(); ++v) {
      if (file_.vertices[v].fixed && !walls_.of_vertex[v]) {
        fixed.push_back(&file_.vertices[v]);
      }
    }
    if (!walls_.walls.empty()) {
      std::erase_if(fixed, [&](const Datafile::Vertex* vertex) {
        return valence_[static_cast<std::size_t>(vertex - file_.vertices.data())] == 0;
      });
    }
    if (!fixed.empty() && !walls_.walls.empty()) {
      fail_at(fixed[0]->line, "'fixed': " + name(*fixed[0]) +
                                  " is on no wall, and junctions that "
                                  "do not move are not read");
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

  void check_areas() const {
    const Foam& foam = result_.foam;
    for (const Bubble b : foam.bubble_slots()) {
      if (!(foam.area(b) > 0)) {
        throw FoamError("the area of bubble " + to_string(foam.bubble_id[b]) + " is " +
                        number(foam.area(b)) + ": are its edges listed clockwise?");
      }
    }
    if (const auto problems = validate_walls(foam); !problems.empty()) {
      throw FoamError(problems.front());
    }
  }

  /// Obstacles in bubbles take of their areas. One bubble of a torus, or between walls, may have
  /// what the others leave.
  void complete_areas() {
    Foam& foam = result_.foam;
    if (measured_) {
      for (const Bubble b : foam.bubble_slots()) {
        foam.target_area[b] = foam.area(b);
      }
      return;
    }
    for (const Outside wall : foam.outside_slots()) {
      if (const Bubble host = foam.exterior[wall].host; host != kNone && !file_.torus) {
        foam.target_area[host] += foam.area_of_wall(wall);
      }
    }
    if (rest_ != kOutside) {
      const Bubble rest(
          static_cast<Index>(std::ranges::find(foam.bubble_id, rest_) - foam.bubble_id.begin()));
      foam.target_area[rest] = 0;
      foam.target_area[rest] =
          space_of(foam) - std::accumulate(foam.target_area.begin(), foam.target_area.end(), 0.0);
      remove_mean_pressure();
    }
    for (const Bubble b : foam.bubble_slots()) {
      if (!(foam.target_area[b] > 0)) {
        throw FoamError("the area that is left for bubble " + to_string(foam.bubble_id[b]) +
                        " is " + number(foam.target_area[b]));
      }
    }
    const double scale =
        fill_space(foam, kMeasuredAreas,
                   walls_.walls.empty() ? "the VOLUMEs of bodies do not fit PERIODS"
                                        : "the VOLUMEs of bodies do not fit the walls");
    constexpr double kUntold = 1e-6;
    if (std::abs(scale - 1) > kUntold) {
      result_.warnings.push_back("the VOLUMEs of the bodies do not fill the " +
                                 std::string(walls_.walls.empty() ? "torus" : "container") +
                                 ": they were scaled by " + number(scale));
    }
  }

  /// Pressures are above that of the one bubble without a VOLUME; their mean means nothing.
  void remove_mean_pressure() {
    auto& pressure = result_.foam.pressure;
    const double mean = std::accumulate(pressure.begin(), pressure.end(), 0.0) /
                        static_cast<double>(pressure.size());
    for (double& p : pressure) {
      p -= mean;
    }
  }

  const Datafile& file_;
  bool held_; ///< whether edges are, as those of walls
  evolver::WallsOfDatafile walls_;
  EvolverFoam result_;
  FilmSet set_;
  bool mirrored_ = false;
  std::int64_t rest_ = kOutside; ///< the bubble that has what the others leave
  struct WithoutVolume {
    std::int64_t id;
    int line;
    std::string name;
  };
  std::vector<WithoutVolume> without_volume_;
  bool measured_ = false;                      ///< whether target areas are the areas
  std::vector<Index> body_of_;                 ///< of a face
  std::vector<std::int64_t> bubble_of_;        ///< of a face
  std::vector<std::array<Index, 2>> sides_;    ///< of an edge: the faces left and right
  std::vector<std::array<Walked, 3>> leaving_; ///< of a vertex
  std::vector<std::size_t> valence_;           ///< of a vertex
  std::vector<Index> junction_of_;             ///< of a vertex
};

} // namespace

EvolverFoam read_evolver(std::string text, std::function<std::string(const std::string&)> include) {
  Datafile file = evolver::parse_datafile(std::move(text), std::move(include));
  evolver::close_faces(file);
  return FoamOfDatafile(file).run();
}

} // namespace foam
