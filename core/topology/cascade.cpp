// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/cascade.h"

#include <algorithm>
#include <deque>

#include "topology/collapse.h"

namespace foam {
namespace {

template <class Element> std::vector<Element> all_of(Slots<Element> slots) {
  std::vector<Element> all;
  all.reserve(place_of(slots.size()));
  for (const Element e : slots) {
    all.push_back(e);
  }
  return all;
}

/// The two queues of Figure 4.8.
class Cascade {
public:
  Cascade(Foam& foam, const CollapseRules& rules) : collapse_(foam, rules) {}

  CascadeResult run(std::span<const Film> films, std::span<const Bubble> bubbles) && {
    bubbles_.assign(bubbles.begin(), bubbles.end());
    process_bubbles();
    leave_out(films); // they are tested anyway; Figure 4.8 empties the queue here
    films_.insert(films_.begin(), films.begin(), films.end());
    while (!films_.empty()) {
      const Film film = films_.front();
      films_.pop_front();
      push(collapse_.film(film)); // Figure 4.9
      process_bubbles();
    }
    return std::move(collapse_).result();
  }

private:
  /// Figures 4.10 and 4.11.
  void process_bubbles() {
    while (!bubbles_.empty()) {
      const Bubble bubble = bubbles_.front();
      bubbles_.pop_front();
      push(collapse_.bubble(bubble));
    }
  }

  /// Takes the given films out of the queue.
  void leave_out(std::span<const Film> films) {
    std::vector<Film> sorted(films.begin(), films.end());
    std::ranges::sort(sorted);
    std::erase_if(films_, [&](Film f) { return std::ranges::binary_search(sorted, f); });
  }

  void push(const Affected& after) {
    films_.insert(films_.end(), after.films.begin(), after.films.end());
    bubbles_.insert(bubbles_.end(), after.bubbles.begin(), after.bubbles.end());
  }

  Collapse collapse_;
  std::deque<Film> films_;
  std::deque<Bubble> bubbles_;
};

} // namespace

CascadeResult topological_cascade(Foam& foam, const CollapseRules& rules) {
  return topological_cascade(foam, rules, all_of(foam.film_slots()), all_of(foam.bubble_slots()));
}

CascadeResult topological_cascade(Foam& foam, const CollapseRules& rules,
                                  std::span<const Film> films, std::span<const Bubble> bubbles) {
  return Cascade(foam, rules).run(films, bubbles);
}

} // namespace foam
