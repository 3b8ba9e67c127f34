// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/validate.h"

#include <algorithm>

#include "mesh/element_measures.h"

namespace foam {
namespace {

using std::to_string;

class Validator {
public:
  explicit Validator(const Foam& foam) : foam_(foam) {}

  std::vector<std::string> run() {
    check_sizes();
    if (problems_.empty()) {
      check_references();
    }
    if (problems_.empty()) {
      check_junctions();
    }
    if (problems_.empty()) {
      check_loops();
      check_euler();
    }
    return std::move(problems_);
  }

private:
  void check_sizes() {
    const std::size_t bubbles = foam_.bubble_half.size();
    const std::size_t films = foam_.film_angle.size();
    const std::size_t junctions = foam_.position.size();
    require(foam_.sides.size() == bubbles && foam_.pressure.size() == bubbles &&
                foam_.target_area.size() == bubbles && foam_.bubble_id.size() == bubbles,
            "the bubbles' arrays differ in length");
    require(foam_.half_junction.size() == 2 * films && foam_.half_bubble.size() == 2 * films &&
                foam_.film_wrap.size() == films,
            "the films' arrays differ in length");
    require(foam_.junction_half.size() == junctions, "the junctions' arrays differ in length");
  }

  /// Every index points to an element that exists, and back.
  void check_references() {
    for (Index f = 0; f < foam_.film_capacity(); ++f) {
      const bool ends[] = {foam_.start(2 * f) != kNone, foam_.start(2 * f + 1) != kNone};
      require(ends[0] == ends[1], "film " + to_string(f) + " has only one end");
      if (!ends[0] || !ends[1]) {
        continue;
      }
      for (const Index h : {2 * f, 2 * f + 1}) {
        const Index j = foam_.start(h);
        const bool junction_exists =
            j >= 0 && j < foam_.junction_capacity() && foam_.has_junction(j);
        require(junction_exists && std::ranges::count(foam_.junction_half[Foam::size(j)], h) == 1,
                "half-film " + to_string(h) + " is not one of the three of its junction " +
                    to_string(j));
        const Index b = foam_.left(h);
        require(b == kWorld || (b >= 0 && b < foam_.bubble_capacity() && foam_.has_bubble(b)),
                "half-film " + to_string(h) + " bounds bubble " + to_string(b) +
                    ", which does not exist");
      }
    }
    for (Index j = 0; j < foam_.junction_capacity(); ++j) {
      if (foam_.has_junction(j)) {
        for (const Index h : foam_.junction_half[Foam::size(j)]) {
          require(h >= 0 && h < 2 * foam_.film_capacity() && foam_.start(h) == j,
                  "junction " + to_string(j) + " holds half-film " + to_string(h) +
                      ", which does not start there");
        }
      }
    }
    for (Index b = 0; b < foam_.bubble_capacity(); ++b) {
      if (foam_.has_bubble(b)) {
        const Index h = foam_.bubble_half[Foam::size(b)];
        require(h >= 0 && h < 2 * foam_.film_capacity() && foam_.start(h) != kNone &&
                    foam_.left(h) == b,
                "bubble " + to_string(b) + " is not on the left of its half-film " + to_string(h));
      }
    }
  }

  void check_junctions() {
    for (Index j = 0; j < foam_.junction_capacity(); ++j) {
      if (foam_.has_junction(j)) {
        for (const Index h : foam_.junction_half[Foam::size(j)]) {
          require(foam_.left(h) == foam_.right(foam_.next_around_junction(h)),
                  "the bubbles around junction " + to_string(j) + " do not fit together");
        }
      }
    }
  }

  void check_loops() {
    std::vector<Index> bounding(foam_.bubble_half.size(), 0);
    for (Index h = 0; h < 2 * foam_.film_capacity(); ++h) {
      if (foam_.start(h) != kNone && foam_.left(h) != kWorld) {
        ++bounding[Foam::size(foam_.left(h))];
      }
    }
    for (Index b = 0; b < foam_.bubble_capacity(); ++b) {
      if (!foam_.has_bubble(b)) {
        continue;
      }
      const std::string name = "bubble " + to_string(b);
      Index loop = 0;
      Wrap around;
      for_each_half(foam_, b, [&](Index h) {
        ++loop;
        around = around + foam_.wrap(h);
      });
      require(loop == bounding[Foam::size(b)], name + " is bounded by more than one loop of films");
      require(loop == foam_.sides[Foam::size(b)], name + " has " + to_string(loop) +
                                                      " films, but counts " +
                                                      to_string(foam_.sides[Foam::size(b)]));
      require(loop >= 2, name + " has fewer than two sides");
      require(around == Wrap{}, "the films of " + name + " do not close on the torus");
    }
  }

  void check_euler() {
    const bool torus = foam_.boundary == Boundary::Periodic;
    const Index characteristic =
        foam_.junction_count() - foam_.film_count() + foam_.bubble_count() + (torus ? 0 : 1);
    require(
        characteristic == (torus ? 0 : 2),
        "Euler's V - E + F is " + to_string(characteristic) + ", not " +
            (torus ? "0: the foam does not fill the torus" : "2: the foam is not in one piece"));
  }

  void require(bool holds, const std::string& problem) {
    if (!holds) {
      problems_.push_back(problem);
    }
  }

  const Foam& foam_;
  std::vector<std::string> problems_;
};

} // namespace

std::vector<std::string> validate(const Foam& foam) {
  return Validator(foam).run();
}

std::vector<std::string> validate_geometry(const Foam& foam) {
  std::vector<std::string> problems;
  for (Index j = 0; j < foam.junction_capacity(); ++j) {
    if (!foam.has_junction(j) || foam.pinned(j)) {
      continue;
    }
    if (!counter_clockwise(foam, j)) {
      problems.push_back("the films of junction " + to_string(j) + " are not counter-clockwise");
    }
  }
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    if (foam.has_bubble(b) && !(foam.area(b) > 0)) {
      problems.push_back("the area of bubble " + to_string(b) + " is " + to_string(foam.area(b)));
    }
  }
  return problems;
}

} // namespace foam
