// SPDX-License-Identifier: GPL-3.0-or-later
#include "construct/honeycomb.h"

#include <cmath>
#include <string>

#include "base/error.h"
#include "base/random.h"
#include "mesh/film_set.h"
#include "topology/operations.h"

namespace foam {
namespace {

void check(const HoneycombOptions& options) {
  if (options.columns < 4) {
    throw FoamError("a honeycomb has at least 4 columns, but is to have " +
                    std::to_string(options.columns));
  }
  if (options.rows < 4 || options.rows % 2 != 0) {
    throw FoamError("a honeycomb has an even number of rows, at least 4, but is to have " +
                    std::to_string(options.rows));
  }
  if (!(options.displacement >= 0 && options.displacement <= 0.15)) {
    throw FoamError("the displacement must lie between 0 and 0.15, but is " +
                    number(options.displacement));
  }
  if (!(options.swaps >= 0 && options.swaps <= 1)) {
    throw FoamError("the share of swaps must lie between 0 and 1, but is " + number(options.swaps));
  }
}

/// A place in the rows and columns, brought back onto the torus.
struct Site {
  Index column = 0;
  Index row = 0;
  Wrap wrap;
};

/// Bubble (i, j) has its centre at (i + ½·(j mod 2), j·√¾) times the bubbles' distance. To it
/// belong the junctions below it, 0, and below it to the right, 1, and the films to its lower right
/// 0, its lower left 1, and its right 2.
class Honeycomb {
public:
  explicit Honeycomb(const HoneycombOptions& options)
      : columns_(options.columns), rows_(options.rows), distance_(std::sqrt(2 / std::sqrt(3.0))),
        random_(options.seed) {
    set_.surroundings = {
        Boundary::Periodic,
        Lattice::rectangle(0, columns_ * distance_, 0, rows_ * distance_ * std::sqrt(0.75))};
    set_.surface_tension = options.surface_tension;
    for (Index row = 0; row < rows_; ++row) {
      for (Index column = 0; column < columns_; ++column) {
        add_bubble(column, row, options.displacement);
      }
    }
  }

  const FilmSet& films() const { return set_; }

private:
  void add_bubble(Index column, Index row, double displacement) {
    const Vec2 centre{(column + 0.5 * (row % 2)) * distance_, row * std::sqrt(0.75) * distance_};
    const double side = distance_ / std::sqrt(3.0);
    add_junction(centre + Vec2{0, -side}, displacement);
    add_junction(centre + Vec2{0.5 * distance_, -0.5 * side}, displacement);
    set_.bubbles.push_back({bubble({column, row, {}}), 0, 1});

    const Site here{column, row, {}};
    const Index shift = row % 2; // odd rows stand half a column to the right
    const Site right = site(column + 1, row);
    const Site left = site(column - 1, row);
    const Site lower_right = site(column + shift, row - 1);
    const Site lower_left = site(column + shift - 1, row - 1);
    const Site upper_right = site(column + shift, row + 1);
    add_film(here, 0, here, 1, here, lower_right);
    add_film(left, 1, here, 0, here, lower_left);
    add_film(here, 1, upper_right, 0, here, right);
  }

  void add_junction(Vec2 place, double displacement) {
    const double dx = displacement * (2 * random_.uniform() - 1);
    const double dy = displacement * (2 * random_.uniform() - 1);
    set_.junctions.push_back(place + Vec2{dx, dy});
  }

  void add_film(const Site& from, Index first, const Site& to, Index second, const Site& left,
                const Site& right) {
    set_.films.push_back({2 * bubble(from) + first, 2 * bubble(to) + second, bubble(left),
                          bubble(right), 0, to.wrap - from.wrap});
  }

  Index bubble(const Site& s) const { return s.row * columns_ + s.column; }

  Site site(Index column, Index row) const {
    const auto floor_of = [](Index i, Index n) { return i < 0 ? -1 : (i >= n ? 1 : 0); };
    const Wrap wrap{floor_of(column, columns_), floor_of(row, rows_)};
    return {column - wrap.x * columns_, row - wrap.y * rows_, wrap};
  }

  Index columns_, rows_;
  double distance_; ///< of neighbouring bubbles, cm
  Random random_;
  FilmSet set_;
};

/// Swaps films at random where bubbles keep five to seven sides.
void swap_at_random(Foam& foam, double share, Random random) {
  const auto sides = [&](Bubble b) { return foam.sides[b]; };
  for (const Film f : foam.film_slots()) {
    const Half h = f.half();
    const bool spare = sides(foam.left(h)) > 5 && sides(foam.right(h)) > 5 &&
                       sides(foam.left(foam.next_around_junction(h))) < 7 &&
                       sides(foam.left(foam.next_around_junction(h.twin()))) < 7;
    if (random.uniform() < share && spare && can_perform_t1(foam, f)) {
      perform_t1(foam, f);
    }
  }
  foam.t1_count = 0;
  foam.operations.clear();
}

} // namespace

Foam honeycomb(const HoneycombOptions& options) {
  check(options);
  Foam foam = foam_of(Honeycomb(options).films());
  swap_at_random(foam, options.swaps, Random(~options.seed));
  for (const Bubble b : foam.bubble_slots()) {
    foam.target_area[b] = foam.area(b);
  }
  return foam;
}

} // namespace foam
