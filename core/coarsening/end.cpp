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

Bubble concerned_by(const Foam& foam, const Obstacle& obstacle) {
  if (obstacle.bubble != kNone) {
    return obstacle.bubble;
  }
  return obstacle.cause == End::Cause::AllVanish ? first_bubble(foam, std::greater())
                                                 : first_bubble(foam, std::less());
}

/// The property that T2 areas follow.
std::string t2_property(const End& end) {
  return end.thresholds == ThresholdKind::Relative ? "Alpha" : "T2Area";
}

/// Where T2Area is not read: what has it read.
std::string set_to_be_read(const End& end) {
  return end.thresholds == ThresholdKind::Automatic ? ", with Thresholds Absolute," : "";
}

std::string of_last_two(const End& end) {
  if (end.bubbles > 2) {
    return "That frame would lose " + std::to_string(end.bubbles - 2) +
           " other bubbles as well: a smaller TimeStep shows how";
  }
  if (end.area > 2 * end.limit.t2_area) { // the greater part of its life is before that
    return "A smaller TimeStep shows more of it";
  }
  if (end.least_t2_area) {
    return "No smaller T2 area has equilibria: nothing else is to come";
  }
  return "A smaller " + t2_property(end) + set_to_be_read(end) + " lets it live longer";
}

std::string of_a_bubble_that_stays(const End& end) {
  // One of more sides does not wait for the T2 area, but loses them as it gets small.
  const bool waits = end.sides <= 3;
  const bool read = !end.least_t2_area || end.thresholds == ThresholdKind::Automatic;
  const std::string other = read ? "another " + t2_property(end) + set_to_be_read(end)
                                 : "a " + t2_property(end) + " with which it is larger";
  return "A smaller TimeStep" + (waits ? " or " + other : "") + " may help";
}

} // namespace

End end_at(const Foam& last, const Obstacle& obstacle, const Thresholds& limit,
           const ThresholdOptions& asked) {
  const Bubble concerned = concerned_by(last, obstacle);
  return {.cause = obstacle.cause,
          .bubble = last.bubble_id[concerned],
          .sides = last.sides[concerned],
          .area = last.target_area[concerned],
          .area_ahead = obstacle.area_ahead,
          .limit = limit,
          .thresholds = asked.kind,
          .least_t2_area = thresholds(last, asked).t2_area < 0.999 * limit.t2_area,
          .bubbles = last.bubble_count()};
}

std::string reason(const End& end) {
  std::ostringstream text;
  if (end.cause == End::Cause::NotStrained) {
    text << "no equilibrium of its " << end.bubbles << " bubbles was found at a strain of "
         << end.strain << ". More MaximumIterations or a larger Tolerance may help";
    return text.str();
  }
  text << "bubble " << end.bubble << ", with " << end.sides << " sides and an area of " << end.area
       << " cm², ";
  switch (end.cause) {
  case End::Cause::LastTwo:
    text << "comes to the T2 area of " << end.limit.t2_area << " cm² before the next frame and is "
         << "one of the last two then: a single bubble has no junctions and is no foam of this "
         << "model. " << of_last_two(end);
    break;
  case End::Cause::AllVanish:
    text << "is the largest of " << end.bubbles << " and below the T2 area of " << end.limit.t2_area
         << " cm²: all would vanish at once. " << t2_property(end)
         << " has to be small beside the bubbles";
    break;
  case End::Cause::CannotVanish:
    text << "is to vanish before the next frame, at a T2 area of " << end.limit.t2_area
         << " cm², and cannot: the bubbles around it have no sides to spare, or the foam no "
         << "equilibrium without it. " << end.bubbles << " bubbles are left. "
         << of_a_bubble_that_stays(end);
    break;
  case End::Cause::NoEquilibrium:
    if (end.area_ahead < 0) {
      text << "would be turned inside out in the next frame, to an area of " << end.area_ahead
           << " cm². A smaller TimeStep, more MaximumIterations or Equilibrator Newton may help";
    } else {
      text << "is the smallest of " << end.bubbles
           << ", and no equilibrium was found for the next frame, with a T1 length of "
           << end.limit.t1_length << " cm and a T2 area of " << end.limit.t2_area
           << " cm². A smaller TimeStep, other thresholds or more MaximumIterations may help";
    }
    break;
  case End::Cause::NotStrained:
    break; // has no bubble
  }
  return text.str();
}

} // namespace foam
