// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/collapse.h"

#include <algorithm>

#include "topology/operations.h"

namespace foam {

Affected Collapse::film(Film film) {
  if (!rules_.t1 || !can_perform_t1(foam_, film) || !rules_.t1(foam_, film)) {
    return {};
  }
  Affected after{.performed = true, .films = {}, .bubbles = {}};
  for (const Bubble loser : perform_t1(foam_, film)) {
    if (!loser.is_outside()) {
      after.bubbles.push_back(loser);
    }
    note(loser);
  }
  note(foam_.left(film.half()));
  note(foam_.right(film.half()));
  return after;
}

Affected Collapse::bubble(Bubble bubble) {
  Affected after;
  const auto lost = [&](Bubble neighbour) {
    if (!neighbour.is_outside()) {
      after.bubbles.push_back(neighbour);
    }
    note(neighbour);
  };
  if (rules_.t2 && can_perform_t2(foam_, bubble) && rules_.t2(foam_, bubble)) {
    const T2Result removed = perform_t2(foam_, bubble);
    after.performed = true;
    after.films.assign(removed.films.begin(), removed.films.end());
    std::ranges::for_each(removed.bubbles, lost);
  } else if (rules_.t3 && can_perform_t3(foam_, bubble) && rules_.t3(foam_, bubble)) {
    // Of the two films that end in the bubble one remains, which becomes the whole.
    for_each_half(foam_, bubble,
                  [&](Half h) { after.films.push_back(foam_.previous_around_junction(h).film()); });
    after.performed = true;
    std::ranges::for_each(perform_t3(foam_, bubble), lost);
    std::erase_if(after.films, [&](Film f) { return !foam_.has_film(f); });
  }
  return after;
}

void Collapse::note(Bubble bubble) {
  if (!bubble.is_outside()) {
    around_.push_back(bubble);
  }
}

CascadeResult Collapse::result() && {
  std::erase_if(around_, [&](Bubble b) { return !foam_.has_bubble(b); });
  std::ranges::sort(around_);
  const auto repeated = std::ranges::unique(around_);
  around_.erase(repeated.begin(), repeated.end());
  return {std::move(around_)};
}

} // namespace foam
