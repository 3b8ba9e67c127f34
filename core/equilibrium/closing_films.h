// SPDX-License-Identifier: GPL-3.0-or-later
//
// T1s on the way to equilibrium, many at once (topology/bidding.h).
#pragma once

#include <cmath>

#include "equilibrium/newton_step.h"
#include "physics/swap_rule.h"
#include "topology/bidding.h"
#include "topology/local_operations.h"

namespace foam::newton {
namespace detail {

/// Marks the films that a step shortens further although they are short. Each swap of a film asks
/// for it to be four times shorter, so that no film is swapped back and forth.
struct MarkClosing {
  static constexpr std::uint8_t kLargestSwapCount = 4;

  FoamView mesh;
  StepView step;
  double t1_length = 0; ///< cm
  const std::uint8_t* swaps = nullptr;
  std::uint8_t* closing = nullptr;

  FOAM_HOST_DEVICE void operator()(Index film) const {
    closing[film] =
        bends(mesh, film) && swaps[film] < kLargestSwapCount &&
        mesh.length(2 * film) <= t1_length * std::pow(0.25, static_cast<double>(swaps[film])) &&
        dot(mesh.chord(2 * film), step.chord_change(mesh, film)) < 0;
  }
};

} // namespace detail

/// T1s of closing films that may be swapped and are pulled shut, the shortest first.
struct ClosingFilmBids {
  std::uint8_t* closing = nullptr; ///< by film; 0 once it is swapped
  std::uint8_t* swaps = nullptr;   ///< how often it has been

  FOAM_HOST_DEVICE static Index candidates(const FoamView& mesh) { return mesh.films; }
  FOAM_HOST_DEVICE std::uint64_t key(const FoamView& mesh, Index film) const {
    const bool gives_way = closing[film] && spares_sides(mesh, film) &&
                           can_perform_t1(mesh, film) && pulled_shut(mesh, film);
    return gives_way ? bid_key(false, mesh.length(2 * film), film) : kNoBid;
  }
  FOAM_HOST_DEVICE static Touched bubbles(const FoamView& mesh, Index film) {
    return bubbles_around_film(mesh, film);
  }
  FOAM_HOST_DEVICE static Performed count(const FoamView& /*mesh*/, Index /*film*/) { return {1}; }
  FOAM_HOST_DEVICE void perform(FoamView& mesh, Index film) const {
    swap_film(mesh, film);
    closing[film] = 0;
    ++swaps[film];
  }
};

} // namespace foam::newton
