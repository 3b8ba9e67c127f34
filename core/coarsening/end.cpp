// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarsening/end.h"

#include <sstream>

namespace foam {
namespace {

Bubble smallest_bubble(const Foam& foam) {
  Bubble smallest = kNone;
  for (const Bubble b : foam.bubble_slots()) {
    if (foam.has_bubble(b) &&
        (smallest == kNone || foam.target_area[b] < foam.target_area[smallest])) {
      smallest = b;
    }
  }
  return smallest;
}

} // namespace

End end_at(const Foam& last, End::Cause cause, const Thresholds& limit, Bubble bubble) {
  const Bubble concerned = bubble == kNone ? smallest_bubble(last) : bubble;
  return {.cause = cause,
          .bubble = last.bubble_id[concerned],
          .sides = last.sides[concerned],
          .area = last.target_area[concerned],
          .t2_area = limit.t2_area,
          .t1_length = limit.t1_length,
          .bubbles = last.bubble_count()};
}

std::string reason(const End& end) {
  std::ostringstream text;
  text << "bubble " << end.bubble << " (" << end.sides << " sides, " << end.area << " cm², of "
       << end.bubbles << " bubbles) ";
  switch (end.cause) {
  case End::Cause::LastTwo:
    text << "comes to the T2 area, " << end.t2_area
         << " cm², and is one of the last two: a single bubble has no junctions and is no foam of "
            "this model. A smaller T2Area lets it live longer";
    break;
  case End::Cause::CannotVanish:
    text << "is to vanish, at a T2 area of " << end.t2_area
         << " cm², and cannot: without it a neighbour would be left with fewer than two sides, or "
            "no equilibrium was found. Another T2Area or a smaller TimeStep may help";
    break;
  case End::Cause::NoEquilibrium:
    text << "is the smallest, and no equilibrium was found for what comes next, with a T1 length "
            "of "
         << end.t1_length << " cm and a T2 area of " << end.t2_area
         << " cm². A smaller TimeStep, other thresholds, or more MaximumIterations may help";
    break;
  }
  return text.str();
}

} // namespace foam
