// SPDX-License-Identifier: GPL-3.0-or-later
#include "coarsening/event_queue.h"

#include <tuple>

namespace foam {

void EventQueue::clear(const Foam& foam) {
  entries_ = {};
  bubble_version_.assign(foam.bubble_half.size(), 0);
  film_version_.assign(foam.film_angle.size(), 0);
}

void EventQueue::schedule(const Event& event) {
  entries_.push({event, ++version(event)});
}

std::optional<Event> EventQueue::next() {
  while (!entries_.empty()) {
    const Entry entry = entries_.top();
    entries_.pop();
    if (entry.version == version(entry.event)) {
      return entry.event;
    }
  }
  return std::nullopt;
}

std::uint32_t& EventQueue::version(const Event& event) {
  return event.kind == Event::Kind::Collapse ? bubble_version_[event.bubble]
                                             : film_version_[event.film];
}

bool EventQueue::Entry::operator<(const Entry& other) const {
  const auto order = [](const Event& e) { return std::tie(e.time, e.kind, e.bubble, e.film); };
  return order(event) > order(other.event);
}

} // namespace foam
