// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarsening/end.h"

#include <functional>
#include <sstream>

namespace foam {
namespace {

/// The bubble whose area a comparison puts first.
template <class Before> Bubble first_bubble(const Foam& foam, const Before& before) {
  Bubble first = kNone;
  for (const Bubble b : foam.bubble_slots()) {
    if (foam.has_bubble(b) &&
        (first == kNone || before(foam.target_area[b], foam.target_area[first]))) {
      first = b;
    }
  }
  return first;
}

Bubble concerned_by(const Foam& foam, End::Cause cause) {
  return cause == End::Cause::AllVanish ? first_bubble(foam, std::greater())
                                        : first_bubble(foam, std::less());
}

} // namespace

End end_at(const Foam& last, End::Cause cause, const Thresholds& limit, Bubble bubble) {
  const Bubble concerned = bubble == kNone ? concerned_by(last, cause) : bubble;
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
  text << "bubble " << end.bubble << ", with " << end.sides << " sides and an area of " << end.area
       << " cm², ";
  switch (end.cause) {
  case End::Cause::LastTwo:
    text << "comes to the T2 area of " << end.t2_area << " cm² before the next frame and is one of "
         << "the last two then: a single bubble has no junctions and is no foam of this model. ";
    if (end.bubbles > 2) {
      text << "That frame would lose " << end.bubbles - 2
           << " other bubbles as well: a smaller TimeStep shows how";
    } else {
      text << "A smaller T2Area lets it live longer";
    }
    break;
  case End::Cause::AllVanish:
    text << "is the largest of " << end.bubbles << " and below the T2 area of " << end.t2_area
         << " cm²: all would vanish at once. T2Area has to be small beside the bubbles";
    break;
  case End::Cause::CannotVanish:
    text << "is to vanish before the next frame, at a T2 area of " << end.t2_area
         << " cm², and cannot: the bubbles around it have no sides to spare, or the foam no "
         << "equilibrium without it. " << end.bubbles
         << " bubbles are left. A smaller TimeStep or another T2Area may help";
    break;
  case End::Cause::NoEquilibrium:
    text << "is the smallest of " << end.bubbles
         << ", and no equilibrium was found for the next frame, with a T1 length of "
         << end.t1_length << " cm and a T2 area of " << end.t2_area
         << " cm². A smaller TimeStep, other thresholds or more MaximumIterations may help";
    break;
  }
  return text.str();
}

} // namespace foam
