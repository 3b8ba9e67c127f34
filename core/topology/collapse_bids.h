// SPDX-License-Identifier: GPL-3.0-or-later
//
// What bubbles and films bid for in a frame (topology/bidding.h).
#pragma once

#include <cstdint>

#include "topology/bidding.h"
#include "topology/local_operations.h"
#include "topology/two_sided.h"

namespace foam {

/// How many operations of each kind were performed.
struct OperationCount {
  std::int64_t t1 = 0, t2 = 0, t3 = 0;

  FOAM_HOST_DEVICE bool any() const { return t1 + t2 + t3 > 0; }
  friend FOAM_HOST_DEVICE OperationCount operator+(OperationCount a, OperationCount b) {
    return {a.t1 + b.t1, a.t2 + b.t2, a.t3 + b.t3};
  }
  friend bool operator==(const OperationCount& a, const OperationCount& b) = default;
};

/// Counts operations that have been performed on the view of a foam.
inline void count(Foam& foam, const OperationCount& performed) {
  foam.t1_count += performed.t1;
  foam.t2_count += performed.t2;
  foam.t3_count += performed.t3;
  foam.topology += static_cast<std::uint64_t>(performed.t1 + performed.t2 + performed.t3);
}

namespace detail {

/// The bubbles beside a two-sided bubble, at both ends of it, and at the far ends of the two films
/// that end in it.
FOAM_HOST_DEVICE inline Touched around_two_sided(const FoamView& mesh, Index bubble) {
  const Index e0 = mesh.bubble_half[FoamView::size(bubble)];
  const Index e1 = mesh.next_in_bubble(e0);
  const auto far_end = [&](Index inner) {
    const Index back = FoamView::twin(mesh.previous_around_junction(inner));
    return mesh.left(mesh.next_around_junction(back));
  };
  return {bubble, mesh.right(e0), mesh.right(e1), far_end(e0), far_end(e1)};
}

} // namespace detail

/// T1, T2 and T3. Bubbles come before films, small before large. As in the thesis's final algorithm
/// (4.3), a film that has been swapped is swapped again only if a bubble beside it has vanished
/// since, so that there is an end. \tparam Rules as ThesisRules
/// (thesis/rules.h)
template <class Rules> struct CollapseBids {
  Rules rules;
  std::uint8_t* swappable = nullptr; ///< of a film: not swapped yet; all 1 in the beginning

  /// Bubbles first, then films.
  FOAM_HOST_DEVICE static Index candidates(const FoamView& mesh) {
    return mesh.bubbles + mesh.films;
  }

  FOAM_HOST_DEVICE std::uint64_t key(const FoamView& mesh, Index i) const {
    if (i < mesh.bubbles) {
      const bool gives_way =
          mesh.has_bubble(i) &&
          (can_perform_t2(mesh, i) || (can_perform_t3(mesh, i) && !rules.slides(mesh, i))) &&
          rules.vanishes(mesh, i);
      return gives_way ? bid_key(false, std::max(Rules::bubble_size(mesh, i), 0.0), i) : kNoBid;
    }
    const Index film = i - mesh.bubbles;
    const bool gives_way = mesh.has_film(film) && swappable[film] && rules.shrunk(mesh, film) &&
                           can_perform_t1(mesh, film);
    return gives_way ? bid_key(true, Rules::film_size(mesh, film), film) : kNoBid;
  }

  FOAM_HOST_DEVICE static Touched bubbles(const FoamView& mesh, Index i) {
    if (i >= mesh.bubbles) {
      return bubbles_around_film(mesh, i - mesh.bubbles);
    }
    if (mesh.sides[FoamView::size(i)] == 2) {
      return detail::around_two_sided(mesh, i);
    }
    const Index h = mesh.bubble_half[FoamView::size(i)];
    return {i, mesh.right(h), mesh.right(mesh.next_in_bubble(h)),
            mesh.right(mesh.previous_in_bubble(h)), kWorld};
  }

  FOAM_HOST_DEVICE static OperationCount count(const FoamView& mesh, Index i) {
    if (i >= mesh.bubbles) {
      return {1, 0, 0};
    }
    return mesh.sides[FoamView::size(i)] == 3 ? OperationCount{0, 1, 0} : OperationCount{0, 0, 1};
  }

  FOAM_HOST_DEVICE void perform(FoamView& mesh, Index i) const {
    if (i >= mesh.bubbles) {
      swap_film(mesh, i - mesh.bubbles);
      swappable[i - mesh.bubbles] = 0;
    } else if (mesh.sides[FoamView::size(i)] == 3) {
      for (const Index film : remove_three_sided_bubble(mesh, i).films) {
        swappable[film] = 1;
      }
    } else {
      const Index half = mesh.bubble_half[FoamView::size(i)];
      const Index remaining = FoamView::film_of(mesh.previous_around_junction(half));
      remove_two_sided_bubble(mesh, i);
      swappable[remaining] = 1;
    }
  }
};

/// Sliding of two-sided bubbles, in the order of their numbers.
struct SlideBids {
  TwoSidedRule rule;
  std::uint8_t* waiting = nullptr; ///< of a bubble: not slid yet; all 1 in the beginning

  FOAM_HOST_DEVICE static Index candidates(const FoamView& mesh) { return mesh.bubbles; }
  FOAM_HOST_DEVICE std::uint64_t key(const FoamView& mesh, Index bubble) const {
    const bool slides = mesh.has_bubble(bubble) && mesh.sides[FoamView::size(bubble)] == 2 &&
                        waiting[bubble] && rule.slides(mesh, bubble);
    return slides ? bid_key(false, 0, bubble) : kNoBid;
  }
  FOAM_HOST_DEVICE static Touched bubbles(const FoamView& mesh, Index bubble) {
    return detail::around_two_sided(mesh, bubble);
  }
  FOAM_HOST_DEVICE static Performed count(const FoamView& /*mesh*/, Index /*bubble*/) {
    return {1};
  }
  FOAM_HOST_DEVICE void perform(FoamView& mesh, Index bubble) const {
    slide_two_sided_bubble(mesh, bubble, rule.sliding_distance());
    waiting[bubble] = 0;
  }
};

} // namespace foam
