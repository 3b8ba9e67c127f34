// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <queue>
#include <vector>

#include "mesh/foam.h"

namespace foam {

/// What is expected of one film or bubble.
struct Event {
  enum class Kind : std::uint8_t {
    Collapse, ///< a bubble reaches the area at which it gives way
    Close,    ///< a film reaches the T1 length
    Strain,   ///< a film has changed so much that its motion does not carry on
    Touch     ///< a film comes upon an obstacle that lies free in a bubble
  };

  double time = 0; ///< s from the beginning of the frame
  Kind kind = Kind::Collapse;
  Bubble bubble = kNone; ///< that collapses, or none
  Film film = kNone;     ///< that closes or is strained, or none
};

/// The events that lie ahead, the next one first; of two at one instant the one of lower kind, then
/// of lower index. A film and a bubble has one event at most: a new one replaces the old.
class EventQueue {
public:
  /// Expects nothing.
  void clear(const Foam& foam);
  void schedule(const Event& event);
  /// What was expected of the bubble, or of the film, will not be.
  void cancel(Bubble bubble) { ++bubble_version_[bubble]; }
  void cancel(Film film) { ++film_version_[film]; }
  /// Takes out the next event, if there is one.
  std::optional<Event> next();

private:
  struct Entry {
    Event event;
    std::uint32_t version = 0;
    bool operator<(const Entry& other) const; ///< comes later
  };
  std::uint32_t& version(const Event& event);

  std::priority_queue<Entry> entries_;
  Field<Bubble, std::uint32_t> bubble_version_;
  Field<Film, std::uint32_t> film_version_;
};

} // namespace foam
