// SPDX-License-Identifier: GPL-3.0-or-later
#include "evolver/write_foam.h"

#include <algorithm>
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
  explicit Writer(const Foam& foam) : foam_(foam) {}

  std::string run() {
    if (foam_.surroundings.has_walls() || foam_.exterior.size() > 1) {
      throw FoamError(
          "a foam with walls, or in several gases, cannot be written for Surface Evolver: "
          "free ones and those on a torus can");
    }
    header();
    vertices();
    edges();
    faces();
    bodies();
    text_ += "READ\n";
    return std::move(text_);
  }

private:
  void header() {
    text_ += "// A foam of " + to_string(foam_.bubble_count()) +
             " bubbles. A film's tension is both of its surfaces'.\nSTRING\nSPACE_DIMENSION 2\n";
    if (foam_.surroundings.periodic()) {
      const auto& [origin, first, second] = foam_.surroundings.lattice;
      text_ += "TORUS_FILLED\nPERIODS\n";
      place(first);
      place(second);
      text_ += "DISPLAY_ORIGIN";
      place(origin);
    }
    text_ += "QUADRATIC\nLENGTH_METHOD_NAME \"circular_arc_length\"\n"
             "AREA_METHOD_NAME \"circular_arc_area\"\nDEFINE BODY ATTRIBUTE BubbleId REAL\n";
    text_ += "TOTAL_TIME " + number(foam_.time) + "\n";
  }

  void place(Vec2 p) { text_ += " " + number(p.x) + " " + number(p.y) + "\n"; }

  /// Junctions, and the middles of films.
  void vertices() {
    text_ += "\nVERTICES\n";
    vertex_.assign(foam_.position.size(), 0);
    int count = 0;
    for (const Junction j : foam_.junction_slots()) {
      if (foam_.has_junction(j)) {
        vertex_[j] = ++count;
        text_ += to_string(count);
        place(foam_.position[j]);
      }
    }
    midpoints_ = count;
    for (const Film f : foam_.film_slots()) {
      if (foam_.has_film(f)) {
        const Half h = f.half();
        text_ += to_string(++count);
        place(arc_point(foam_.position[foam_.start(h)], foam_.chord(h), foam_.half_angle(h), 0.5));
      }
    }
  }

  void edges() {
    text_ += "\nEDGES\n";
    edge_.assign(foam_.film_angle.size(), 0);
    int count = 0;
    for (const Film f : foam_.film_slots()) {
      if (!foam_.has_film(f)) {
        continue;
      }
      const Half h = f.half();
      edge_[f] = ++count;
      text_ += to_string(count) + " " + to_string(vertex_[foam_.start(h)]) + " " +
               to_string(vertex_[foam_.end(h)]) + " " + to_string(midpoints_ + count);
      if (foam_.surroundings.periodic()) {
        text_ += wrap(foam_.wrap(h), f);
      }
      text_ += " TENSION " + number(foam_.tension(f)) + "\n";
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

  void faces() {
    text_ += "\nFACES\n";
    for (const Bubble b : foam_.bubble_slots()) {
      if (foam_.has_bubble(b)) {
        bubbles_.push_back(b);
      }
    }
    std::ranges::sort(bubbles_, {}, [&](Bubble b) { return foam_.bubble_id[b]; });
    for (std::size_t k = 0; k < bubbles_.size(); ++k) {
      text_ += to_string(k + 1);
      for_each_half(foam_, bubbles_[k], [&](Half h) {
        text_ += (h.reversed() ? " -" : " ") + to_string(edge_[h.film()]);
      });
      text_ += "\n";
    }
  }

  void bodies() {
    const double outside = foam_.exterior.empty() ? 0 : foam_.exterior[Outside(0)].pressure;
    text_ += "\nBODIES\n";
    for (std::size_t k = 0; k < bubbles_.size(); ++k) {
      const Bubble b = bubbles_[k];
      text_ += to_string(k + 1) + " " + to_string(k + 1) + " VOLUME " +
               number(foam_.target_area[b]) + " LAGRANGE_MULTIPLIER " +
               number(foam_.pressure[b] - outside) + " BubbleId " + to_string(foam_.bubble_id[b]) +
               "\n";
    }
    text_ += "\n";
  }

  const Foam& foam_;
  std::string text_;
  Field<Junction, int> vertex_; ///< a junction's number in the file
  Field<Film, int> edge_;
  std::vector<Bubble> bubbles_;
  int midpoints_ = 0; ///< so many vertices before the first
};

} // namespace

std::string write_evolver(const Foam& foam) {
  return Writer(foam).run();
}

} // namespace foam
