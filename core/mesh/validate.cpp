// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/validate.h"

#include <algorithm>
#include <cmath>
#include <type_traits>

#include "mesh/element_measures.h"
#include "mesh/hosted_walls.h"

namespace foam {
namespace {

using std::to_string;

template <class Element> std::string name(Element e) {
  return to_string(e.index());
}

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
      check_hosts();
      check_euler();
    }
    return std::move(problems_);
  }

private:
  void check_sizes() {
    const std::size_t bubbles = foam_.bubble_half.size();
    const std::size_t films = foam_.film_angle.size();
    const std::size_t junctions = foam_.position.size();
    for_each_array(
        [&]<class Element, class T>(const Field<Element, T>& field) {
          if constexpr (std::is_same_v<Element, Bubble>) {
            require(field.size() == bubbles, "the bubbles' arrays differ in length");
          } else if constexpr (std::is_same_v<Element, Film>) {
            require(field.size() == films || is_absent(field, foam_.film_tension),
                    "the films' arrays differ in length");
          } else if constexpr (std::is_same_v<Element, Half>) {
            require(field.size() == 2 * films, "the films' arrays differ in length");
          } else if constexpr (std::is_same_v<Element, Junction>) {
            require(field.size() == junctions || is_absent(field, foam_.junction_piece),
                    "the junctions' arrays differ in length");
          }
        },
        foam_);
  }

  /// Whether a field is one that a foam need not have, and does not.
  static bool is_absent(const auto& field, const auto& optional) {
    return static_cast<const void*>(&field) == &optional && optional.empty();
  }

  template <class Element> static bool in(Element e, Slots<Element> slots) {
    return e.index() >= 0 && e.index() < slots.size();
  }

  bool has_outside(Bubble b) const {
    return b.is_outside() && b.outside().place() < foam_.exterior.size();
  }

  /// Every index points to an element that exists, and back.
  void check_references() {
    for (const Film f : foam_.film_slots()) {
      const bool ends[] = {foam_.start(f.half()) != kNone, foam_.end(f.half()) != kNone};
      require(ends[0] == ends[1], "film " + name(f) + " has only one end");
      if (!ends[0] || !ends[1]) {
        continue;
      }
      for (const Half h : {f.half(), f.half().twin()}) {
        const Junction j = foam_.start(h);
        const bool junction_exists = in(j, foam_.junction_slots()) && foam_.has_junction(j);
        require(junction_exists && std::ranges::count(foam_.junction_half[j], h) == 1,
                "half-film " + name(h) + " is not one of the three of its junction " + name(j));
        const Bubble b = foam_.left(h);
        require(has_outside(b) || (in(b, foam_.bubble_slots()) && foam_.has_bubble(b)),
                "half-film " + name(h) + " bounds bubble " + name(b) + ", which does not exist");
      }
    }
    for (const Junction j : foam_.junction_slots()) {
      if (foam_.has_junction(j)) {
        for (const Half h : foam_.junction_half[j]) {
          require(in(h, foam_.half_slots()) && foam_.start(h) == j,
                  "junction " + name(j) + " holds half-film " + name(h) +
                      ", which does not start there");
        }
      }
    }
    for (const Bubble b : foam_.bubble_slots()) {
      if (foam_.has_bubble(b)) {
        const Half h = foam_.bubble_half[b];
        require(in(h, foam_.half_slots()) && foam_.start(h) != kNone && foam_.left(h) == b,
                "bubble " + name(b) + " is not on the left of its half-film " + name(h));
      }
    }
  }

  void check_junctions() {
    for (const Junction j : foam_.junction_slots()) {
      if (foam_.has_junction(j)) {
        for (const Half h : foam_.junction_half[j]) {
          require(foam_.left(h) == foam_.right(foam_.next_around_junction(h)),
                  "the bubbles around junction " + name(j) + " do not fit together");
        }
      }
    }
  }

  void check_loops() {
    Field<Bubble, Index> bounding(foam_.bubble_half.size(), 0);
    for (const Half h : foam_.half_slots()) {
      if (foam_.start(h) != kNone && !foam_.left(h).is_outside()) {
        ++bounding[foam_.left(h)];
      }
    }
    for (const Bubble b : foam_.bubble_slots()) {
      if (!foam_.has_bubble(b)) {
        continue;
      }
      const std::string bubble = "bubble " + name(b);
      Index loop = 0;
      Wrap around;
      for_each_half(foam_, b, [&](Half h) {
        ++loop;
        around = around + foam_.wrap(h);
      });
      require(loop == bounding[b], bubble + " is bounded by more than one loop of films");
      require(loop == foam_.sides[b], bubble + " has " + to_string(loop) + " films, but counts " +
                                          to_string(foam_.sides[b]));
      require(loop >= 2, bubble + " has fewer than two sides");
      require(around == Wrap{}, "the films of " + bubble + " do not close on the torus");
    }
  }

  /// A wall lies in a bubble if no film ends on it.
  void check_hosts() {
    Field<Outside, Index> films(foam_.exterior.size(), 0);
    for (const Half h : foam_.half_slots()) {
      if (foam_.start(h) != kNone && foam_.left(h).is_outside()) {
        ++films[foam_.left(h).outside()];
      }
    }
    for (const Outside wall : foam_.outside_slots()) {
      const Bubble host = foam_.exterior[wall].host;
      const std::string text = "wall " + name(wall) + ", beside which " + to_string(films[wall]);
      require(host == kNone || films[wall] == 0, text + " films are, also lies free in a bubble");
      require(host == kNone || (in(host, foam_.bubble_slots()) && foam_.has_bubble(host)),
              text + " films are, lies in bubble " + name(host) + ", which does not exist");
    }
  }

  void check_euler() {
    const bool torus = foam_.surroundings.periodic();
    Index faces = foam_.bubble_count();
    for (const Exterior& exterior : foam_.exterior) {
      faces += exterior.host == kNone ? 1 : 0;
    }
    const Index characteristic = foam_.junction_count() - foam_.film_count() + faces;
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

/// The stretches of a wall follow each other once round it, unless two films that end there have
/// passed each other.
void check_order(const Foam& foam, Outside wall, std::vector<std::string>& problems) {
  const Exterior& exterior = foam.exterior[wall];
  if (exterior.kind != Exterior::Kind::Solid || exterior.host != kNone) {
    return;
  }
  const double round = length_of_wall(foam, wall);
  double sum = 0;
  for (const Half h : foam.half_slots()) {
    if (foam.start(h) != kNone && foam.right(h) == Bubble(wall)) {
      const double length = foam.length(h);
      sum += length;
      if (!(length >= 0)) {
        problems.push_back("a stretch of wall " + name(wall) + " is " + to_string(length) +
                           " long");
      }
    }
  }
  if (!(std::abs(sum - round) < 1e-6 * round)) {
    problems.push_back("the stretches of wall " + name(wall) + " are " + to_string(sum) +
                       " long in all, and the wall is " + to_string(round));
  }
}

} // namespace

std::vector<std::string> validate(const Foam& foam) {
  return Validator(foam).run();
}

std::vector<std::string> validate_walls(const Foam& foam) {
  std::vector<std::string> problems;
  for (const Outside wall : foam.outside_slots()) {
    check_order(foam, wall, problems);
  }
  return problems;
}

std::vector<std::string> validate_geometry(const Foam& foam) {
  std::vector<std::string> problems;
  for (const Junction j : foam.junction_slots()) {
    if (foam.moves(j) && !counter_clockwise(foam, j)) {
      problems.push_back("the films of junction " + name(j) + " are not counter-clockwise");
    }
  }
  for (const std::string& problem : validate_walls(foam)) {
    problems.push_back(problem);
  }
  for (const Bubble b : foam.bubble_slots()) {
    if (foam.has_bubble(b) && !(foam.area(b) > 0)) {
      problems.push_back("the area of bubble " + name(b) + " is " + to_string(foam.area(b)));
    }
  }
  return problems;
}

} // namespace foam
