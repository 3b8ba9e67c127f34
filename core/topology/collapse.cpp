// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/collapse.h"

#include <algorithm>

#include "topology/operations.h"

namespace foam {

Aftermath Collapse::film(Index film) {
  if (!rules_.t1 || !can_perform_t1(foam_, film) || !rules_.t1(foam_, film)) {
    return {};
  }
  Aftermath after{.performed = true, .films = {}, .bubbles = {}};
  for (const Index loser : perform_t1(foam_, film)) {
    if (loser != kWorld) {
      after.bubbles.push_back(loser);
    }
    note(loser);
  }
  note(foam_.left(2 * film));
  note(foam_.right(2 * film));
  return after;
}

Aftermath Collapse::bubble(Index bubble) {
  Aftermath after;
  const auto lost = [&](Index neighbour) {
    if (neighbour != kWorld) {
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
    for_each_half(foam_, bubble, [&](Index h) {
      after.films.push_back(Foam::film_of(foam_.previous_around_junction(h)));
    });
    after.performed = true;
    std::ranges::for_each(perform_t3(foam_, bubble), lost);
    std::erase_if(after.films, [&](Index f) { return !foam_.has_film(f); });
  }
  return after;
}

void Collapse::note(Index bubble) {
  if (bubble != kWorld) {
    around_.push_back(bubble);
  }
}

CascadeResult Collapse::result() && {
  std::erase_if(around_, [&](Index b) { return !foam_.has_bubble(b); });
  std::ranges::sort(around_);
  const auto repeated = std::ranges::unique(around_);
  around_.erase(repeated.begin(), repeated.end());
  return {std::move(around_)};
}

} // namespace foam
