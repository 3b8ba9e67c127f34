// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/stress.h"

namespace foam {
namespace {

/// The centroid of a bubble's junctions' polygon, as seen from the start of each of its half-films.
void find_centroid(const Foam& foam, Bubble bubble, Field<Half, Vec2>& centroid) {
  double twice_area = 0;
  Vec2 moment; // six times
  Vec2 at;     // from the first start
  for_each_half(foam, bubble, [&](Half h) {
    const Vec2 next = at + foam.chord(h);
    const double triangle = cross(at, next);
    twice_area += triangle;
    moment += triangle * (at + next);
    centroid[h] = -at;
    at = next;
  });
  for_each_half(foam, bubble, [&](Half h) { centroid[h] += (1 / (3 * twice_area)) * moment; });
}

} // namespace

SymmetricTensor mean_stress(const std::vector<BubbleStatistics>& bubbles) {
  SymmetricTensor sum;
  double area = 0;
  for (const BubbleStatistics& bubble : bubbles) {
    sum += bubble.area * bubble.stress;
    area += bubble.area;
  }
  return (1 / area) * sum;
}

SymmetricTensor stress(const Foam& foam) {
  return statistics(foam, true).stress;
}

SymmetricTensor texture(const Foam& foam) {
  Field<Half, Vec2> centroid(foam.half_bubble.size());
  for (const Bubble b : foam.bubble_slots()) {
    if (foam.has_bubble(b)) {
      find_centroid(foam, b, centroid);
    }
  }
  SymmetricTensor sum;
  double links = 0;
  for (const Film f : foam.film_slots()) {
    if (foam.has_film(f) && !foam.on_outside(f.half())) {
      const Half h = f.half();
      sum += square(foam.chord(h) + centroid[h.twin()] - centroid[h]);
      ++links;
    }
  }
  return (1 / links) * sum;
}

} // namespace foam
