// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "mesh/elements.h"
#include "mesh/foam_view.h"
#include "parallel/kernels.h"

namespace foam {

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

/// √(mean target area) of those of some bubbles that are there, cm.
template <class Executor>
double mean_spacing(Executor& executor, const ConstFoamView& mesh,
                    const Elements<Bubble>& bubbles) {
  const Vec2 total = executor.reduce( // in x of the areas, in y of the bubbles
      bubbles, Vec2{},
      FOAM_KERNEL(Bubble b) {
        return mesh.has_bubble(b) ? Vec2{mesh.target_area[b], 1} : Vec2{};
      },
      parallel::Add{});
  return std::sqrt(total.x / std::max(total.y, 1.0));
}

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

/// A patch: the junctions of the given bubbles and of `rings` rings of neighbours around them move.
/// All bubbles at these junctions keep their areas: one of held pressure, grown or shrunk at no
/// cost, would be unstable.
Region patch(const Foam& foam, std::span<const Bubble> bubbles, int rings);

} // namespace foam
