// SPDX-License-Identifier: GPL-3.0-or-later
#include "topology/cascade.h"

#include <algorithm>
#include <deque>
#include <numeric>

#include "topology/collapse.h"

namespace foam {
namespace {

std::vector<Index> up_to(Index n) {
  std::vector<Index> all(Foam::size(n));
  std::iota(all.begin(), all.end(), Index{0});
  return all;
}

/// The two queues of Figure 4.8.
class Cascade {
public:
  Cascade(Foam& foam, const CollapseRules& rules) : collapse_(foam, rules) {}

  CascadeResult run(std::span<const Index> films, std::span<const Index> bubbles) && {
    bubbles_.assign(bubbles.begin(), bubbles.end());
    process_bubbles();
    leave_out(films); // they are tested anyway; Figure 4.8 empties the queue here
    films_.insert(films_.begin(), films.begin(), films.end());
    while (!films_.empty()) {
      const Index film = films_.front();
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
      const Index bubble = bubbles_.front();
      bubbles_.pop_front();
      push(collapse_.bubble(bubble));
    }
  }

  /// Takes the given films out of the queue.
  void leave_out(std::span<const Index> films) {
    std::vector<Index> sorted(films.begin(), films.end());
    std::ranges::sort(sorted);
    std::erase_if(films_, [&](Index f) { return std::ranges::binary_search(sorted, f); });
  }

  void push(const Aftermath& after) {
    films_.insert(films_.end(), after.films.begin(), after.films.end());
    bubbles_.insert(bubbles_.end(), after.bubbles.begin(), after.bubbles.end());
  }

  Collapse collapse_;
  std::deque<Index> films_;
  std::deque<Index> bubbles_;
};

} // namespace

CascadeResult topological_cascade(Foam& foam, const CollapseRules& rules) {
  return topological_cascade(foam, rules, up_to(foam.film_capacity()),
                             up_to(foam.bubble_capacity()));
}

CascadeResult topological_cascade(Foam& foam, const CollapseRules& rules,
                                  std::span<const Index> films, std::span<const Index> bubbles) {
  return Cascade(foam, rules).run(films, bubbles);
}

} // namespace foam
