// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is performed many at once in a frame (topology/reservations.h).
#pragma once

#include <algorithm>
#include <cstdint>

#include "topology/local_operations.h"
#include "topology/reservations.h"
#include "topology/two_sided.h"

namespace foam {

namespace detail {

/// The bubbles beside a two-sided bubble, at both ends of it, and at the far ends of the two films
/// that end in it.
template <class Mesh> FOAM_HOST_DEVICE Touched around_two_sided(const Mesh& mesh, Bubble bubble) {
  const Half e0 = mesh.bubble_half[bubble];
  const Half e1 = mesh.next_in_bubble(e0);
  const auto far_end = [&](Half inner) {
    const Half back = mesh.previous_around_junction(inner).twin();
    return mesh.left(mesh.next_around_junction(back));
  };
  return {bubble, mesh.right(e0), mesh.right(e1), far_end(e0), far_end(e1)};
}

} // namespace detail

/// T1, T2 and T3. Bubbles come before films, small before large. As in the thesis's final algorithm
/// (4.3), a film that has been swapped is swapped again only if a bubble beside it has vanished
/// since, so that there is an end. \tparam Rules as ThesisRules
/// (thesis/rules.h)
template <class Rules> struct CollapseOperations {
  Rules rules;
  FieldView<Film, std::uint8_t> swappable; ///< of a film: not swapped yet; all 1 in the beginning

  /// Bubbles first, then films.
  template <class Mesh> FOAM_HOST_DEVICE static Slots<Index> candidates(const Mesh& mesh) {
    return Slots<Index>(mesh.bubbles + mesh.films);
  }

  template <class Mesh> FOAM_HOST_DEVICE std::uint64_t key(const Mesh& mesh, Index i) const {
    return is_bubble(mesh, i) ? key_of(mesh, Bubble(i)) : key_of(mesh, film(mesh, i));
  }

  template <class Mesh> FOAM_HOST_DEVICE static Touched bubbles(const Mesh& mesh, Index i) {
    if (!is_bubble(mesh, i)) {
      return bubbles_around_film(mesh, film(mesh, i));
    }
    const Bubble bubble(i);
    if (mesh.sides[bubble] == 2) {
      return detail::around_two_sided(mesh, bubble);
    }
    const Half h = mesh.bubble_half[bubble];
    return {bubble, mesh.right(h), mesh.right(mesh.next_in_bubble(h)),
            mesh.right(mesh.previous_in_bubble(h)), kWorld};
  }

  template <class Mesh>
  FOAM_HOST_DEVICE static TopologicalOperation describe(const Mesh& mesh, Index i) {
    return is_bubble(mesh, i) ? removal_of(mesh, Bubble(i)) : swap_of(mesh, film(mesh, i));
  }

  FOAM_HOST_DEVICE void perform(FoamView& mesh, Index i) const {
    if (is_bubble(mesh, i)) {
      remove(mesh, Bubble(i));
    } else {
      swap_film(mesh, film(mesh, i));
      swappable[film(mesh, i)] = 0;
    }
  }

private:
  template <class Mesh> FOAM_HOST_DEVICE static bool is_bubble(const Mesh& mesh, Index i) {
    return i < mesh.bubbles;
  }
  template <class Mesh> FOAM_HOST_DEVICE static Film film(const Mesh& mesh, Index i) {
    return Film(i - mesh.bubbles);
  }

  template <class Mesh>
  FOAM_HOST_DEVICE std::uint64_t key_of(const Mesh& mesh, Bubble bubble) const {
    const bool gives_way = mesh.has_bubble(bubble) &&
                           (can_perform_t2(mesh, bubble) ||
                            (can_perform_t3(mesh, bubble) && !rules.slides(mesh, bubble))) &&
                           rules.vanishes(mesh, bubble);
    return gives_way ? reservation_key(false, std::max(Rules::bubble_size(mesh, bubble), 0.0),
                                       bubble.index())
                     : kNoReservation;
  }
  template <class Mesh> FOAM_HOST_DEVICE std::uint64_t key_of(const Mesh& mesh, Film film) const {
    const bool gives_way = mesh.has_film(film) && swappable[film] && rules.shrunk(mesh, film) &&
                           can_perform_t1(mesh, film);
    return gives_way ? reservation_key(true, Rules::film_size(mesh, film), film.index())
                     : kNoReservation;
  }

  FOAM_HOST_DEVICE void remove(FoamView& mesh, Bubble bubble) const {
    if (mesh.sides[bubble] == 3) {
      for (const Film film : remove_three_sided_bubble(mesh, bubble).films) {
        swappable[film] = 1;
      }
    } else {
      const Film remaining = mesh.previous_around_junction(mesh.bubble_half[bubble]).film();
      remove_two_sided_bubble(mesh, bubble);
      swappable[remaining] = 1;
    }
  }
};

/// Sliding of two-sided bubbles, in the order of their numbers.
struct SlideOperations {
  TwoSidedRule rule;
  FieldView<Bubble, std::uint8_t> waiting; ///< of a bubble: not slid yet; all 1 in the beginning

  template <class Mesh> FOAM_HOST_DEVICE static Slots<Bubble> candidates(const Mesh& mesh) {
    return mesh.bubble_slots();
  }
  template <class Mesh> FOAM_HOST_DEVICE std::uint64_t key(const Mesh& mesh, Bubble bubble) const {
    const bool slides = mesh.has_bubble(bubble) && mesh.sides[bubble] == 2 && waiting[bubble] &&
                        rule.slides(mesh, bubble);
    return slides ? reservation_key(false, 0, bubble.index()) : kNoReservation;
  }
  template <class Mesh> FOAM_HOST_DEVICE static Touched bubbles(const Mesh& mesh, Bubble bubble) {
    return detail::around_two_sided(mesh, bubble);
  }
  FOAM_HOST_DEVICE void perform(FoamView& mesh, Bubble bubble) const {
    slide_two_sided_bubble(mesh, bubble, rule.sliding_distance());
    waiting[bubble] = 0;
  }
};

} // namespace foam
