// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>
#include <vector>

#include "mesh/foam_view.h"

namespace foam {

/// Some elements of a kind, listed or all of them. A range for an executor (parallel/host.h).
template <class Element> class Elements {
public:
  Elements() = default;
  /// \param list ascending; it must outlive this
  FOAM_HOST_DEVICE Elements(const Element* list, Index size) : list_(list), size_(size) {}
  FOAM_HOST_DEVICE explicit Elements(Slots<Element> all) : size_(all.size()) {}

  FOAM_HOST_DEVICE Index size() const { return size_; }
  FOAM_HOST_DEVICE Element operator[](Index i) const {
    return list_ == nullptr ? Element(i) : list_[i];
  }

private:
  const Element* list_ = nullptr;
  Index size_ = 0;
};

/// The part of a foam that an equilibration may change; all else is held. Where all of a kind are
/// in it, some of them may be gone or held.
struct Domain {
  Elements<Junction> junctions; ///< that move
  Elements<Film> films;         ///< whose half-angles change: those of the bubbles
  Elements<Bubble> bubbles;     ///< whose pressures change so that their areas are right
  Elements<Bubble> rim;         ///< beyond the outermost films: their pressures are held
  bool whole = false;           ///< nothing is held but a container's wall
  double spacing = 0;           ///< √(mean target area) of the bubbles, cm
};

/// All of a mesh. \param spacing of its bubbles, cm
inline Domain whole_mesh(const ConstFoamView& mesh, double spacing) {
  return {Elements(mesh.junction_slots()),
          Elements(mesh.film_slots()),
          Elements(mesh.bubble_slots()),
          {},
          true,
          spacing};
}

/// The lists of a domain, which ascend.
struct Region {
  std::vector<Junction> junctions; ///< that move
  std::vector<Film> films;         ///< whose half-angles change: those of the bubbles
  std::vector<Bubble> bubbles;     ///< whose pressures change so that their areas are right
  std::vector<Bubble> rim;         ///< bubbles beyond the outermost films: their pressures are held
  bool whole = false;              ///< nothing is held but a container's wall
  double spacing = 0;              ///< √(mean target area) of the bubbles, cm
};

/// What a region lists; it must outlive this.
Domain domain_of(const Region& region);

/// All of a foam. Junctions and films on the wall of a sealed container are held.
Region whole_foam(const Foam& foam);

/// The given bubbles that are there and so many rings of neighbours around them, ascending.
std::vector<Bubble> rings_around(const Foam& foam, std::span<const Bubble> bubbles, int rings);

/// A patch: the junctions of the given bubbles and of `rings` rings of neighbours around them move.
/// All bubbles at these junctions keep their areas: one of held pressure, grown or shrunk at no
/// cost, would be unstable.
Region patch(const Foam& foam, std::span<const Bubble> bubbles, int rings);

} // namespace foam
