// SPDX-License-Identifier: GPL-3.0-or-later
#include "construct/fill_container.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>
#include <numeric>
#include <string>

#include "base/error.h"
#include "base/random.h"
#include "construct/triangulation.h"
#include "geometry/bounds.h"
#include "mesh/hosted_walls.h"
#include "mesh/validate.h"

namespace foam {
namespace {

using std::to_string;

/// By which points are moved while it is found out what lies beside what, in units of their
/// spacing: of four on a circle three lie nearer to one another then.
constexpr double kNudge = 1e-7;

/// A point, or its image in a channel.
struct Site {
  Index point = kNone; ///< none for those far away, round all others
  Index copy = 0;      ///< periods along x
};

/// Of a cell that walls cut in pieces.
struct CellPiece {
  Half first; ///< of its loop
  double area = 0;
};

/// The loops of films on whose left a bubble is, the largest first. \param halves of them \param
/// seen of all half-films, those in loops that have been found
std::vector<CellPiece> pieces_of(const Foam& foam, Bubble bubble, std::span<const Half> halves,
                                 Field<Half, char>& seen) {
  std::vector<CellPiece> pieces;
  for (const Half first : halves) {
    if (foam.start(first) == kNone || foam.left(first) != bubble || seen[first]) {
      continue;
    }
    CellPiece piece{first, 0};
    Vec2 at;
    Half h = first;
    do {
      seen[h] = 1;
      const double segment = foam.segment(h.film());
      piece.area += 0.5 * cross(at, foam.chord(h)) + (h.reversed() ? -segment : segment);
      at += foam.chord(h);
      h = foam.next_in_bubble(h);
    } while (h != first);
    pieces.push_back(piece);
  }
  std::ranges::sort(pieces, std::greater<>(), &CellPiece::area);
  return pieces;
}

/// Takes away a film between a bubble and itself. At each of its ends the other two films become
/// one. \returns false if they are one already.
bool remove_film_inside(Foam& foam, Half film) {
  for (const Half end : {film, film.twin()}) {
    const Half stays = foam.next_around_junction(end);
    const Half goes = foam.previous_around_junction(end);
    if (stays.film() == goes.film() || stays.film() == end.film() || goes.film() == end.film()) {
      return false;
    }
    const Junction far = foam.end(goes);
    foam.set_wrap(stays, foam.wrap(stays) - foam.wrap(goes));
    foam.half_junction[stays] = far;
    std::ranges::replace(foam.junction_half[far], goes.twin(), stays);
    foam.junction_half[foam.start(end)] = {kNone, kNone, kNone};
    foam.put_off_wall(foam.start(end), {});
    foam.half_junction[goes] = foam.half_junction[goes.twin()] = kNone;
  }
  foam.half_junction[film] = foam.half_junction[film.twin()] = kNone;
  return true;
}

/// Where three films meet, or one ends on a wall.
struct Node {
  Vec2 position;
  std::array<Half, 3> halves; ///< counter-clockwise; on a wall forwards, off it, backwards
  bool on_wall = false;
  Outside wall;
  WallPlace place;
  Bubble before, after; ///< along the wall
};

/// An end of a film.
struct End {
  std::size_t node = 0;
  std::size_t slot = 0; ///< in its halves
  Index copy = 0;       ///< of the image of the node
};

class Filling {
public:
  Filling(std::span<const Vec2> points, const Container& container)
      : container_(container), points_(points) {
    Foam walls;
    walls.set_walls(container.walls);
    walls_ = walls;
  }

  Foam build() {
    check_points();
    place_sites();
    triangles_ = triangulate_plane(places_);
    find_vertices();
    find_films();
    close_walls();
    Foam foam = assemble();
    give_away_pieces(foam);
    house_walls(foam);
    if (const auto problems = validate(foam); !problems.empty()) {
      throw FoamError("the cells of the points make no foam between these walls: " +
                      problems.front() + "; more points may");
    }
    return foam;
  }

private:
  void check_points() const {
    for (std::size_t i = 0; i < points_.size(); ++i) {
      if (!is_inside(container_, points_[i])) {
        throw FoamError("point " + to_string(i) + " at " + number(points_[i]) +
                        " lies on a wall, or outside of the container");
      }
    }
  }

  void place_sites() {
    const Bounds bounds = bounds_of(points_);
    Bounds all = bounds;
    for (const Wall& wall : container_.walls) {
      for (const WallPiece& piece : wall.pieces) {
        all = all + Bounds{piece.start, piece.start};
        all = all + Bounds{piece.end(), piece.end()};
      }
    }
    const double size = norm(all.extent());
    const double spacing = size / std::sqrt(static_cast<double>(points_.size()));
    const Index copies =
        container_.period > 0 ? 2 + static_cast<Index>(std::ceil(size / container_.period)) : 0;
    Random random(1);
    std::vector<Vec2> nudged(points_.begin(), points_.end());
    for (Vec2& p : nudged) {
      p += (kNudge * spacing) * Vec2{random.uniform() - 0.5, random.uniform() - 0.5};
    }
    for (Index copy = -copies; copy <= copies; ++copy) {
      for (std::size_t i = 0; i < points_.size(); ++i) {
        add_site({static_cast<Index>(i), copy}, nudged[i] + period(copy));
      }
    }
    const Vec2 middle = all.low + 0.5 * all.extent();
    const double far = 10 * (size + copies * container_.period);
    for (int k = 0; k < 8; ++k) {
      add_site({}, middle + rotated({far, 0}, 0.1 + k * std::numbers::pi / 4));
    }
  }

  void add_site(Site site, Vec2 place) {
    sites_.push_back(site);
    places_.push_back(place);
  }

  Vec2 period(Index copy) const { return {copy * container_.period, 0}; }

  const Site& site(const Corner& corner) const { return sites_[corner.point.place()]; }
  Vec2 place(const Corner& corner) const { return places_[corner.point.place()]; }

  /// The triangle's corners by image, from the one with the least point on; two images of a
  /// triangle have the same.
  using Key = std::array<std::pair<Index, Index>, 3>;
  struct Vertex {
    Vec2 position; ///< of the circumcentre
    bool inside = false;
    bool complete = false; ///< all corners are points
    Key key;
    std::size_t first = 0; ///< corner of the key
    Index copy = 0;        ///< of the image that the key is of
  };

  void find_vertices() {
    for (const Triangle& t : triangles_) {
      Vertex& v = vertices_.emplace_back();
      if (std::ranges::any_of(t, [](const Corner& c) { return c.point.is_outside(); })) {
        continue;
      }
      v.position = circumcentre(place(t[0]), place(t[1]), place(t[2]));
      v.complete = std::ranges::all_of(t, [&](const Corner& c) { return site(c).point != kNone; });
      v.inside = v.complete && is_inside(container_, v.position);
      std::array<std::pair<Index, Index>, 3> corners;
      std::ranges::transform(t, corners.begin(), [&](const Corner& c) {
        return std::pair(site(c).point, site(c).copy);
      });
      const auto least = std::ranges::min_element(corners);
      v.copy = least->second;
      v.first = static_cast<std::size_t>(least - corners.begin());
      std::ranges::rotate(corners, least);
      for (auto& corner : corners) {
        corner.second -= v.copy;
      }
      v.key = corners;
    }
  }

  static Vec2 circumcentre(Vec2 a, Vec2 b, Vec2 c) {
    const Vec2 u = b - a;
    const Vec2 v = c - a;
    const double twice = 2 * cross(u, v);
    return a +
           (1 / twice) * Vec2{v.y * dot(u, u) - u.y * dot(v, v), u.x * dot(v, v) - v.x * dot(u, u)};
  }

  /// A side of a triangle.
  struct Side {
    std::size_t triangle;
    std::size_t corner; ///< at which it begins, with the triangle on the left
  };

  void find_films() {
    std::map<std::pair<std::size_t, std::size_t>, Side> sides; // by the sites at their ends
    for (std::size_t t = 0; t < triangles_.size(); ++t) {
      for (std::size_t k = 0; k < 3; ++k) {
        const Corner& from = triangles_[t][k];
        const Corner& to = triangles_[t][(k + 1) % 3];
        if (!from.point.is_outside() && !to.point.is_outside()) {
          sides[{from.point.place(), to.point.place()}] = {t, k};
        }
      }
    }
    for (const auto& [ends, side] : sides) {
      const Site& a = sites_[ends.first];
      const Site& b = sites_[ends.second];
      // Of the images of a film, and of its two sides, one.
      const bool first = std::pair(a.point, a.copy) < std::pair(b.point, b.copy) && a.copy == 0;
      if (a.point != kNone && b.point != kNone && first) {
        if (const auto twin = sides.find({ends.second, ends.first}); twin != sides.end()) {
          cut_film(side, twin->second, Bubble(b.point), Bubble(a.point));
        }
      }
    }
  }

  /// The film that crosses a side of a triangle, and so runs from its circumcentre to that of the
  /// next, ends at each wall between them.
  void cut_film(const Side& from, const Side& to, Bubble left, Bubble right) {
    const Vec2 start = vertices_[from.triangle].position;
    const Vec2 end = vertices_[to.triangle].position;
    struct Crossing {
      double way;
      WallPlace place;
      bool enters;
    };
    std::vector<Crossing> crossings;
    for (const Piece piece : walls_.piece_slots()) {
      const WallPiece& curve = walls_.wall_piece[piece];
      const bool line = is_line(walls_.exterior[walls_.piece_outside[piece]]);
      for (const auto& [way, place] : cuts(curve, line, start, end)) {
        crossings.push_back({way, {piece, place}, cross(curve.tangent(place), end - start) > 0});
      }
    }
    std::ranges::sort(crossings, {}, &Crossing::way);
    bool inside = vertices_[from.triangle].inside;
    End begun = inside ? end_in(from) : End{};
    for (const Crossing& c : crossings) {
      if (c.enters == inside) {
        throw_undecided(point_of(walls_, c.place));
      }
      Node& contact = nodes_.emplace_back();
      contact.on_wall = true;
      contact.position = point_of(walls_, c.place);
      contact.wall = walls_.piece_outside[c.place.piece];
      contact.place = c.place;
      contact.after = c.enters ? right : left; // what enters leaves the wall to the left
      contact.before = c.enters ? left : right;
      const End here{nodes_.size() - 1, 1, 0};
      if (c.enters) {
        begun = here;
      } else {
        add_film(begun, here, left, right);
      }
      inside = c.enters;
    }
    if (inside != vertices_[to.triangle].inside) {
      throw_undecided(end);
    }
    if (inside) {
      add_film(begun, end_in(to), left, right);
    }
  }

  [[noreturn]] static void throw_undecided(Vec2 where) {
    throw FoamError("a film touches a wall near " + number(where) +
                    " without crossing it: move the points by a little");
  }

  /// Where a line from a to b crosses a piece of a wall, or its images: the part of the way, and
  /// the place.
  static std::vector<std::pair<double, double>> cuts(const WallPiece& piece, bool images, Vec2 a,
                                                     Vec2 b) {
    std::vector<std::pair<double, double>> found;
    const Vec2 d = b - a;
    const auto take = [&](double way) {
      const Vec2 at = a + way * d;
      if (way > 0 && way < 1) {
        const Vec2 direction = piece.chord;
        const Vec2 first = rotated(direction, -piece.half_angle);
        const Vec2 last = rotated(direction, piece.half_angle);
        if (images || (dot(at - piece.start, first) >= 0 && dot(piece.end() - at, last) > 0)) {
          found.emplace_back(way, piece.place_of(at));
        }
      }
    };
    if (piece.half_angle == 0) {
      const double across = cross(piece.chord, d);
      if (across != 0) {
        take(cross(piece.start - a, piece.chord) / cross(d, piece.chord));
      }
      return found;
    }
    const double radius = 1 / piece.curvature();
    const Vec2 r = a - piece.centre();
    const double half_b = dot(r, d) / dot(d, d);
    const double c = (dot(r, r) - radius * radius) / dot(d, d);
    if (const double discriminant = half_b * half_b - c; discriminant > 0) {
      const double root = std::sqrt(discriminant);
      take(-half_b - root);
      take(-half_b + root);
    }
    return found;
  }

  /// In a triangle's circumcentre. Films leave it counter-clockwise through side after side.
  End end_in(const Side& side) {
    const Vertex& vertex = vertices_[side.triangle];
    const auto [entry, is_new] = node_of_.try_emplace(vertex.key, nodes_.size());
    if (is_new) {
      nodes_.emplace_back().position = vertex.position - period(vertex.copy);
    }
    return {entry->second, (side.corner + 3 - vertex.first) % 3, vertex.copy};
  }

  void add_film(End from, End to, Bubble left, Bubble right) {
    const Film film(static_cast<Index>(films_.size()));
    films_.push_back({from.node, to.node, left, right, Wrap{to.copy - from.copy, 0}});
    nodes_[from.node].halves[from.slot] = film.half();
    nodes_[to.node].halves[to.slot] = film.half().twin();
  }

  /// Stretches of walls between films that end there.
  void close_walls() {
    for (const Outside wall : walls_.outside_slots()) {
      std::vector<std::size_t> contacts;
      for (std::size_t n = 0; n < nodes_.size(); ++n) {
        if (nodes_[n].on_wall && nodes_[n].wall == wall) {
          contacts.push_back(n);
        }
      }
      if (contacts.empty()) {
        continue; // it lies in the cell of one point
      }
      const bool line = is_line(walls_.exterior[wall]);
      const auto turns = [&](std::size_t n) {
        return line ? static_cast<Index>(std::floor(nodes_[n].place.place / container_.period)) : 0;
      };
      std::ranges::sort(contacts, {}, [&](std::size_t n) {
        return std::pair(nodes_[n].place.piece.index(),
                         nodes_[n].place.place - turns(n) * container_.period);
      });
      const double direction = walls_.wall_piece[first_piece(wall)].chord.x > 0 ? 1 : -1;
      for (std::size_t k = 0; k < contacts.size(); ++k) {
        const std::size_t n = contacts[k];
        const bool last = k + 1 == contacts.size();
        const std::size_t m = contacts[last ? 0 : k + 1];
        if (nodes_[n].after != nodes_[m].before || n == m) {
          throw_undecided(nodes_[n].position);
        }
        const Index wrap =
            line ? static_cast<Index>(direction) * (turns(n) - turns(m) + (last ? 1 : 0)) : 0;
        add_film({n, 0, 0}, {m, 2, wrap}, nodes_[n].after, Bubble(wall));
      }
    }
  }

  Piece first_piece(Outside wall) const { return Piece(walls_.exterior[wall].first_piece); }

  Foam assemble() {
    Foam foam;
    foam.clear(static_cast<Index>(points_.size()), static_cast<Index>(films_.size()),
               static_cast<Index>(nodes_.size()));
    std::iota(foam.bubble_id.begin(), foam.bubble_id.end(), std::int64_t{0});
    for (const Film f : foam.film_slots()) {
      const FilmBetween& film = films_[f.place()];
      const Half h = f.half();
      foam.half_junction[h] = Junction(static_cast<Index>(film.from));
      foam.half_junction[h.twin()] = Junction(static_cast<Index>(film.to));
      foam.half_bubble[h] = film.left;
      foam.half_bubble[h.twin()] = film.right;
      foam.film_wrap[f] = film.wrap;
    }
    for (const Junction j : foam.junction_slots()) {
      foam.position[j] = nodes_[j.place()].position;
      foam.junction_half[j] = nodes_[j.place()].halves;
    }
    count_sides(foam);
    for (const Bubble b : foam.bubble_slots()) {
      if (!foam.has_bubble(b)) {
        throw FoamError("point " + to_string(b.index()) + " has no film around it");
      }
    }
    foam.surroundings.boundary = Boundary::Container;
    foam.surroundings.lattice.origin = container_.walls[0].pieces[0].start;
    foam.surroundings.lattice.first.x = container_.period;
    foam.set_walls(container_.walls);
    return foam;
  }

  /// What walls cut off of a cell goes to the neighbour with which it has the longest film.
  static void give_away_pieces(Foam& foam) {
    Field<Bubble, std::vector<Half>> halves(foam.bubble_half.size());
    for (const Half h : foam.half_slots()) {
      if (!foam.left(h).is_outside()) {
        halves[foam.left(h)].push_back(h);
      }
    }
    Field<Half, char> seen(foam.half_junction.size(), 0);
    for (const Bubble b : foam.bubble_slots()) {
      const std::vector<CellPiece> pieces = pieces_of(foam, b, halves[b], seen);
      for (std::size_t i = 1; i < pieces.size(); ++i) {
        Half longest = kNone;
        Half h = pieces[i].first;
        do {
          const bool taker = !foam.right(h).is_outside() && foam.right(h) != b;
          if (taker && (longest == kNone || foam.length(h) > foam.length(longest))) {
            longest = h;
          }
          h = foam.next_in_bubble(h);
        } while (h != pieces[i].first);
        if (longest == kNone) {
          return; // which validate() says
        }
        const Bubble taker = foam.right(longest);
        do {
          foam.half_bubble[h] = taker;
          halves[taker].push_back(h);
          h = foam.next_in_bubble(h);
        } while (h != pieces[i].first);
        if (!remove_film_inside(foam, longest)) {
          return;
        }
      }
    }
    count_sides(foam);
  }

  static void count_sides(Foam& foam) {
    std::ranges::fill(foam.sides, 0);
    std::ranges::fill(foam.bubble_half, kNone);
    for (const Half h : foam.half_slots()) {
      if (const Bubble b = foam.left(h); foam.start(h) != kNone && !b.is_outside()) {
        foam.bubble_half[b] = h;
        ++foam.sides[b];
      }
    }
  }

  struct FilmBetween {
    std::size_t from, to; ///< nodes
    Bubble left, right;
    Wrap wrap;
  };

  const Container& container_;
  std::span<const Vec2> points_;
  Foam walls_; ///< nothing but the walls
  std::vector<Site> sites_;
  std::vector<Vec2> places_; ///< of the sites, nudged
  std::vector<Triangle> triangles_;
  std::vector<Vertex> vertices_; ///< of the triangles
  std::map<Key, std::size_t> node_of_;
  std::vector<Node> nodes_;
  std::vector<FilmBetween> films_;
};

} // namespace

Foam fill_container(std::span<const Vec2> points, const Container& container) {
  return Filling(points, container).build();
}

} // namespace foam
