// SPDX-License-Identifier: GPL-3.0-or-later
#include "construct/division.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>
#include <string>
#include <utility>

#include "base/error.h"
#include "geometry/fitted_arc.h"

namespace foam {
namespace {

using std::to_string;

/// How many points of a film say where it goes from its end.
constexpr std::size_t kPointsAhead = 8;

/// A side, walked forwards or backwards.
struct Step {
  Index side = kNone;
  bool forwards = true;

  Step back() const { return {side, !forwards}; }
};

/// Points of a film from one end to the other, in one piece, and what lies beside it.
struct Chain {
  std::vector<Vec2> points;
  Index left = kNone;
  Index right = kNone;
  std::array<Index, 2> junctions{kNone, kNone};
  Wrap wrap;
};

/// The end of a chain.
struct ChainEnd {
  std::size_t chain = 0;
  int end = 0; ///< 0 where it starts
};

class FoamOfDivision {
public:
  FoamOfDivision(const Division& division, DivisionOutline outline)
      : division_(division), outline_(outline) {}

  DivisionFoam run(double surface_tension) {
    find_steps();
    for (std::size_t p = 0; p < division_.points.size(); ++p) {
      if (is_node(p)) {
        for (std::size_t k = first_step_[p]; k < first_step_[p + 1]; ++k) {
          add_chain(steps_[k]);
        }
      }
    }
    for (std::size_t p = 0; p < division_.points.size(); ++p) {
      if (is_node(p)) {
        place_junctions(p);
      }
    }
    make_films();
    set_.surface_tension = surface_tension;
    for (const std::int64_t id : division_.ids) {
      set_.bubbles.push_back({id, 0, 1});
    }
    if (division_.torus) {
      set_.surroundings = {Boundary::Periodic, *division_.torus};
    }
    if (outline_ == DivisionOutline::Wall) {
      make_wall();
    }
    result_.foam = foam_of(set_);
    take_areas();
    return std::move(result_);
  }

private:
  Index start(Step s) const {
    const Side& side = division_.sides[place_of(s.side)];
    return s.forwards ? side.from : side.to;
  }
  Index end(Step s) const { return start(s.back()); }
  Index left(Step s) const {
    const Side& side = division_.sides[place_of(s.side)];
    return s.forwards ? side.left : side.right;
  }
  Index right(Step s) const { return left(s.back()); }
  Vec2 point(Index p) const { return division_.points[place_of(p)]; }
  Wrap wrap(Step s) const {
    const Wrap forwards = division_.sides[place_of(s.side)].wrap;
    return s.forwards ? forwards : -forwards;
  }
  Vec2 along(Step s) const {
    const Vec2 d = point(end(s)) - point(start(s));
    return division_.torus ? d + division_.torus->period(wrap(s)) : d;
  }

  /// The steps away from each point.
  void find_steps() {
    first_step_.assign(division_.points.size() + 1, 0);
    for (const Side& side : division_.sides) {
      ++first_step_[place_of(side.from) + 1];
      ++first_step_[place_of(side.to) + 1];
    }
    std::partial_sum(first_step_.begin(), first_step_.end(), first_step_.begin());
    steps_.resize(2 * division_.sides.size());
    std::vector<std::size_t> next(first_step_.begin(), first_step_.end() - 1);
    for (std::size_t s = 0; s < division_.sides.size(); ++s) {
      for (const bool forwards : {true, false}) {
        const Step step{static_cast<Index>(s), forwards};
        steps_[next[place_of(start(step))]++] = step;
      }
    }
    chain_ends_.resize(division_.points.size());
  }

  std::size_t valence(std::size_t p) const { return first_step_[p + 1] - first_step_[p]; }
  bool is_node(std::size_t p) const { return valence(p) > 2; }

  /// The film that begins with a step, unless it has been walked from its other end.
  void add_chain(Step first) {
    Chain chain{{point(start(first))}, left(first), right(first), {}, {}};
    Step step = first;
    while (true) {
      chain.points.push_back(chain.points.back() + along(step));
      chain.wrap = chain.wrap + wrap(step);
      const auto at = place_of(end(step));
      if (valence(at) != 2) {
        break;
      }
      const Step ahead = steps_[first_step_[at]];
      step = ahead.side == step.side ? steps_[first_step_[at] + 1] : ahead;
    }
    const auto at = place_of(end(step));
    if (valence(at) == 1) {
      throw FoamError("a side ends at " + number(division_.points[at]) + ", where no other begins");
    }
    const bool walked_before =
        std::pair(start(first), first.side) > std::pair(end(step), step.side);
    if (walked_before) {
      return;
    }
    chain_ends_[place_of(start(first))].push_back({chains_.size(), 0});
    chain_ends_[at].push_back({chains_.size(), 1});
    chains_.push_back(std::move(chain));
  }

  const Vec2& point_of(ChainEnd e, std::size_t ahead) const {
    const auto& points = chains_[e.chain].points;
    const std::size_t i = std::min(ahead, points.size() - 1);
    return e.end == 0 ? points[i] : points[points.size() - 1 - i];
  }
  Index left_of(ChainEnd e) const {
    const Chain& chain = chains_[e.chain];
    return e.end == 0 ? chain.left : chain.right;
  }
  Index right_of(ChainEnd e) const { return left_of({e.chain, 1 - e.end}); }
  /// Where the film goes, of length 1.
  Vec2 way(ChainEnd e) const {
    const Vec2 d = point_of(e, kPointsAhead) - point_of(e, 0);
    const Vec2 first = point_of(e, 1) - point_of(e, 0);
    return norm(d) > 0 ? (1 / norm(d)) * d : (1 / norm(first)) * first;
  }
  void end_in(ChainEnd e, Index junction, Vec2 moved) {
    Chain& chain = chains_[e.chain];
    chain.junctions[static_cast<std::size_t>(e.end)] = junction;
    (e.end == 0 ? chain.points.front() : chain.points.back()) += moved;
  }
  Index new_junction(Vec2 place) {
    set_.junctions.push_back(place);
    return static_cast<Index>(set_.junctions.size()) - 1;
  }

  /// One junction where three films meet; where more do, two of them part from the others until
  /// three are left.
  void place_junctions(std::size_t p) {
    std::vector<ChainEnd> ends = chain_ends_[p];
    std::ranges::sort(ends, {}, [&](ChainEnd e) {
      const Vec2 d = point_of(e, 1) - point_of(e, 0);
      return std::atan2(d.y, d.x);
    });
    const Vec2 place = division_.points[p];
    for (std::size_t k = 0; k < ends.size(); ++k) {
      const Index left = left_of(ends[k]);
      const Index right = right_of(ends[(k + 1) % ends.size()]);
      if (left != right) {
        throw FoamError(name(left) + " and " + name(right) + " overlap at " + number(place));
      }
    }
    if (ends.size() > 3) {
      ++result_.points_of_more_films;
    }
    double shortest = norm(point_of(ends[0], 1) - point_of(ends[0], 0));
    for (const ChainEnd e : ends) {
      shortest = std::min(shortest, norm(point_of(e, 1) - point_of(e, 0)));
    }
    while (ends.size() > 3) {
      part_two(ends, place, 0.25 * shortest);
    }
    const Index junction = new_junction(place);
    for (const ChainEnd e : ends) {
      end_in(e, junction, {});
    }
  }

  /// Gives two films a junction of their own, at a distance, and a film from there that stands for
  /// them. Of those whose outer bubbles differ it takes the pair that pulls most.
  void part_two(std::vector<ChainEnd>& ends, Vec2 place, double distance) {
    const std::size_t n = ends.size();
    std::size_t best = n;
    double most = -1;
    for (std::size_t k = 0; k < n; ++k) {
      const ChainEnd a = ends[k];
      const ChainEnd b = ends[(k + 1) % n];
      const double pull = norm(way(a) + way(b));
      if (right_of(a) != left_of(b) && pull > most) {
        most = pull;
        best = k;
      }
    }
    if (best == n) {
      throw FoamError("a single bubble, " + name(left_of(ends[0])) + " or " +
                      name(right_of(ends[0])) + ", lies all round " + number(place));
    }
    const ChainEnd a = ends[best];
    const ChainEnd b = ends[(best + 1) % n];
    const Vec2 sum = way(a) + way(b);
    const Vec2 direction = most > 0 ? (1 / most) * sum : left_normal(way(b));
    const Vec2 apart = distance * direction;
    const Index junction = new_junction(place + apart);
    // Its end at the place has on its left what b has, and on its right what a has.
    Chain film{{place, place + apart}, left_of(b), right_of(a), {kNone, junction}, {}};
    end_in(a, junction, apart);
    end_in(b, junction, apart);
    ends[best] = {chains_.size(), 0};
    ends.erase(ends.begin() + static_cast<std::ptrdiff_t>((best + 1) % n));
    chains_.push_back(std::move(film));
  }

  std::string name(Index region) const {
    return region == kNone ? std::string("the outside")
                           : "bubble " + to_string(division_.ids[place_of(region)]);
  }
  std::int64_t id(Index region) const {
    return region == kNone ? -1 : division_.ids[place_of(region)];
  }

  void make_films() {
    for (const Chain& chain : chains_) {
      PathOfFilm path;
      for (std::size_t i = 1; i < chain.points.size(); ++i) {
        path.add(chain.points[i] - chain.points[i - 1]);
      }
      if (path.chord() == Vec2{}) {
        throw FoamError("the film between " + name(chain.left) + " and " + name(chain.right) +
                        " ends where it begins, at " + number(chain.points[0]));
      }
      const double half_angle = path.half_angle();
      set_.films.push_back({chain.junctions[0], chain.junctions[1], id(chain.left), id(chain.right),
                            half_angle, chain.wrap});
      result_.misfit.push_back(path.misfit(half_angle));
    }
  }

  /// Along the films that the outside lies on the right of, one after the other; straight stretches
  /// are one piece.
  void make_wall() {
    std::vector<const Chain*> from(set_.junctions.size(), nullptr);
    for (Chain& chain : chains_) {
      if (chain.left == kNone) {
        std::swap(chain.left, chain.right);
        std::swap(chain.junctions[0], chain.junctions[1]);
        std::ranges::reverse(chain.points);
      }
      if (chain.right == kNone) {
        from[place_of(chain.junctions[0])] = &chain;
      }
    }
    const auto first = std::ranges::find_if(from, [](const Chain* c) { return c != nullptr; });
    if (first == from.end()) {
      throw FoamError("there is no outline to make a wall of");
    }
    std::vector<Vec2> corners;
    const Chain* chain = *first;
    for (std::size_t steps = 0; steps < chains_.size(); ++steps) {
      corners.insert(corners.end(), chain->points.begin(), chain->points.end() - 1);
      chain = from[place_of(chain->junctions[1])];
      if (chain == *first || chain == nullptr) {
        break;
      }
    }
    drop_straight(corners);
    set_.surroundings.boundary = Boundary::Container;
    Exterior wall;
    wall.kind = Exterior::Kind::Solid;
    wall.contact = WallContact::Slip;
    wall.pieces = static_cast<Index>(corners.size());
    set_.exteriors.push_back(wall);
    for (std::size_t i = 0; i < corners.size(); ++i) {
      set_.wall_pieces.push_back({corners[i], corners[(i + 1) % corners.size()] - corners[i], 0});
    }
  }

  static void drop_straight(std::vector<Vec2>& corners) {
    constexpr double kStraight = 1e-9;
    std::vector<Vec2> kept;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const Vec2 before = kept.empty() ? corners.back() : kept.back();
      const Vec2 a = corners[i] - before;
      const Vec2 b = corners[(i + 1) % corners.size()] - corners[i];
      if (std::abs(cross(a, b)) > kStraight * norm(a) * norm(b) || dot(a, b) < 0) {
        kept.push_back(corners[i]);
      }
    }
    corners = std::move(kept);
  }

  void take_areas() {
    Foam& foam = result_.foam;
    for (const Bubble b : foam.bubble_slots()) {
      foam.target_area[b] = foam.area(b);
      if (!(foam.target_area[b] > 0)) {
        throw FoamError("the area of bubble " + to_string(foam.bubble_id[b]) + " is " +
                        number(foam.target_area[b]));
      }
    }
  }

  const Division& division_;
  DivisionOutline outline_;
  DivisionFoam result_;
  FilmSet set_;
  std::vector<std::size_t> first_step_; ///< of each point, in steps_
  std::vector<Step> steps_;
  std::vector<Chain> chains_;
  std::vector<std::vector<ChainEnd>> chain_ends_; ///< in each point
};

} // namespace

DivisionFoam foam_of_division(const Division& division, DivisionOutline outline,
                              double surface_tension) {
  require(surface_tension > 0, "the surface tension", "positive", surface_tension);
  return FoamOfDivision(division, outline).run(surface_tension);
}

std::vector<Index> pieces_of(const Division& division) {
  std::vector<Index> parent(division.points.size());
  std::iota(parent.begin(), parent.end(), Index{0});
  const auto root = [&](Index p) {
    while (parent[place_of(p)] != p) {
      p = parent[place_of(p)] = parent[place_of(parent[place_of(p)])];
    }
    return p;
  };
  for (const Side& side : division.sides) {
    parent[place_of(root(side.from))] = root(side.to);
  }
  std::vector<Index> number(division.points.size(), kNone);
  std::vector<Index> pieces;
  Index count = 0;
  for (const Side& side : division.sides) {
    Index& piece = number[place_of(root(side.from))];
    if (piece == kNone) {
      piece = count++;
    }
    pieces.push_back(piece);
  }
  return pieces;
}

} // namespace foam
