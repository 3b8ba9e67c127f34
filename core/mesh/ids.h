// SPDX-License-Identifier: GPL-3.0-or-later
//
// The numbers of a mesh's elements, a type for each kind, so that one is not taken for another.
#pragma once

#include <compare>
#include <cstddef>
#include <cstdint>

#include "geometry/host_device.h"

namespace foam {

using Index = std::int32_t;

/// An index as the place in an array.
FOAM_HOST_DEVICE constexpr std::size_t place_of(Index index) {
  return static_cast<std::size_t>(index);
}

/// No element, of whatever kind.
struct None {
  // NOLINTNEXTLINE(google-explicit-constructor): it stands for any kind's
  FOAM_HOST_DEVICE constexpr operator Index() const { return -1; }
};
inline constexpr None kNone;

/// The number of an element of one kind, from 0; below that it is none.
template <class Kind> class Id {
public:
  Id() = default;
  // NOLINTNEXTLINE(google-explicit-constructor): kNone is one of each kind
  FOAM_HOST_DEVICE constexpr Id(None /*none*/) {}
  FOAM_HOST_DEVICE constexpr explicit Id(Index index) : index_(index) {}

  FOAM_HOST_DEVICE constexpr Index index() const { return index_; }
  /// The same, as the place in an array.
  FOAM_HOST_DEVICE constexpr std::size_t place() const { return static_cast<std::size_t>(index_); }

  FOAM_HOST_DEVICE friend constexpr bool operator==(Id a, Id b) { return a.index_ == b.index_; }
  FOAM_HOST_DEVICE friend constexpr bool operator<(Id a, Id b) { return a.index_ < b.index_; }
  FOAM_HOST_DEVICE friend constexpr bool operator>(Id a, Id b) { return b < a; }
  FOAM_HOST_DEVICE friend constexpr bool operator<=(Id a, Id b) { return !(b < a); }
  FOAM_HOST_DEVICE friend constexpr bool operator>=(Id a, Id b) { return !(a < b); }

private:
  Index index_ = -1;
};

struct Film;

/// One side of a film: from its one end to its other, with a bubble on its left.
struct Half : Id<Half> {
  using Id::Id;

  FOAM_HOST_DEVICE constexpr Half twin() const { return Half(index() ^ 1); }
  FOAM_HOST_DEVICE constexpr Film film() const;
  /// Whether it runs against its film.
  FOAM_HOST_DEVICE constexpr bool reversed() const { return (index() & 1) != 0; }
};

struct Film : Id<Film> {
  using Id::Id;

  FOAM_HOST_DEVICE constexpr Half half() const { return Half(2 * index()); }
};

constexpr Film Half::film() const {
  return Film(index() >> 1);
}

struct Junction : Id<Junction> {
  using Id::Id;
};

/// What lies around the foam: number 0, 1, … of the outsides.
struct Outside : Id<Outside> {
  using Id::Id;
};

/// A piece of an outside's wall.
struct Piece : Id<Piece> {
  using Id::Id;
};

/// A bubble, or in its place an outside.
struct Bubble : Id<Bubble> {
  using Id::Id;
  FOAM_HOST_DEVICE constexpr explicit Bubble(Outside o) : Id(-1 - o.index()) {}

  FOAM_HOST_DEVICE constexpr bool is_outside() const { return index() < 0; }
  FOAM_HOST_DEVICE constexpr Outside outside() const { return Outside(-1 - index()); }
};

/// The first outside, the only one that there is so far: the thesis's world.
inline constexpr Bubble kWorld{Outside(0)};

/// So many elements of a kind, from 0.
template <class Kind> class Slots {
public:
  class Iterator {
  public:
    FOAM_HOST_DEVICE constexpr explicit Iterator(Index index) : index_(index) {}
    FOAM_HOST_DEVICE constexpr Kind operator*() const { return Kind(index_); }
    FOAM_HOST_DEVICE constexpr Iterator& operator++() {
      ++index_;
      return *this;
    }
    FOAM_HOST_DEVICE friend constexpr bool operator==(Iterator a, Iterator b) {
      return a.index_ == b.index_;
    }

  private:
    Index index_;
  };

  FOAM_HOST_DEVICE constexpr explicit Slots(Index size) : size_(size) {}
  FOAM_HOST_DEVICE constexpr Index size() const { return size_; }
  FOAM_HOST_DEVICE constexpr Kind operator[](Index i) const { return Kind(i); }
  FOAM_HOST_DEVICE constexpr Iterator begin() const { return Iterator(0); }
  FOAM_HOST_DEVICE constexpr Iterator end() const { return Iterator(size_); }

private:
  Index size_;
};

} // namespace foam
