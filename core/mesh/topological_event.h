// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>

#include "geometry/vec2.h"
#include "mesh/ids.h"

namespace foam {

/// A topological operation that has been performed, in terms of a mesh.
struct TopologicalOperation {
  enum class Kind : std::uint8_t { T1 = 1, T2 = 2, T3 = 3 };

  Kind kind = Kind::T1;
  double time = 0;   ///< s
  double strain = 0; ///< of the foam (FoamRecord)
  Vec2 place;        ///< of the film or bubble, cm
  /// T1: the two that lost a side, the two that gained one. T2, T3: the one that vanished, and
  /// those beside it. Filled up with an outside.
  std::array<Bubble, 4> bubbles{kWorld, kWorld, kWorld, kWorld};

  friend bool operator==(const TopologicalOperation&, const TopologicalOperation&) = default;
};

/// The same in terms of bubbles' ids.
struct TopologicalEvent {
  TopologicalOperation::Kind kind = TopologicalOperation::Kind::T1;
  double time = 0;
  double strain = 0;
  Vec2 place;
  std::array<std::int64_t, 4> bubbles{}; ///< BubbleIds in the same order; −1 stands for an outside

  friend bool operator==(const TopologicalEvent&, const TopologicalEvent&) = default;
};

} // namespace foam
