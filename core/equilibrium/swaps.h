// SPDX-License-Identifier: GPL-3.0-or-later
//
// T1s on the way to equilibrium: films that a step shortens further although they are short are
// swapped after it, if they are pulled shut then (physics/swap_rule.h). One after the other in a
// Foam, or many at once on any executor (parallel/host.h).
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include "equilibrium/step.h"
#include "physics/swap_rule.h"
#include "topology/local_operations.h"
#include "topology/operations.h"
#include "topology/reservations.h"

namespace foam::newton {

inline constexpr std::uint8_t kLargestSwapCount = 4; // of one film in one equilibration
inline constexpr double kShort = 0.25; // of the smaller bubble's size: longer films are not short

/// Whether a step shortens a film further although it is short, also beside its bubbles. Each swap
/// of a film asks for it to be four times shorter, so that no film is swapped back and forth.
/// \param t1_length cm \param swaps how often it has been swapped
FOAM_HOST_DEVICE inline bool closes(const ConstFoamView& mesh, Film film, const StepView& step,
                                    double t1_length, std::uint8_t swaps) {
  if (!mesh.may_close(film) || swaps >= kLargestSwapCount) {
    return false;
  }
  const double length = mesh.length(film.half());
  return length <= t1_length * std::pow(0.25, static_cast<double>(swaps)) &&
         length <= kShort * size_beside(mesh, film) &&
         mesh.relative_growth(film.half(), step.junction[mesh.start(film.half())],
                              step.junction[mesh.end(film.half())]) < 0;
}

/// Whether a closing film is to be swapped. Three-sided bubbles keep their sides: they vanish by
/// T2.
template <class Mesh> FOAM_HOST_DEVICE bool may_be_swapped(const Mesh& mesh, Film film) {
  return can_perform_t1(mesh, film) && spares_sides(mesh, film) && unstable_to_t1(mesh, film);
}

/// Swaps one after the other, the shortest first, no two at one junction.
class SwapsInTurn {
public:
  /// Begins an equilibration: no film has been swapped.
  void begin(const Foam& foam) {
    for (const Film f : swapped_) {
      count_[f] = 0;
    }
    swapped_.clear();
    count_.resize(foam.film_angle.size(), 0);
  }

  /// Marks the films that a step closes.
  void mark(const Foam& foam, const Domain& domain, const StepView& step, double t1_length) {
    const ConstFoamView mesh = view_of(foam);
    closing_.clear();
    const auto note = [&](Film f) {
      if (closes(mesh, f, step, t1_length, count_[f])) {
        closing_.push_back({mesh.length(f.half()), f});
      }
    };
    for (Index i = 0; i < domain.films.size(); ++i) {
      note(domain.films[i]);
    }
    for (Index i = 0; i < domain.junctions.size(); ++i) { // the wall's stretches are not among them
      if (const Junction j = domain.junctions[i]; mesh.on_wall(j)) {
        for (const Half h : mesh.junction_half[j]) {
          if (mesh.wall(h) && !h.reversed()) {
            note(h.film());
          }
        }
      }
    }
    std::ranges::sort(closing_, [](const Closing& a, const Closing& b) {
      return a.length < b.length || (a.length == b.length && a.film < b.film);
    });
  }

  /// Swaps those of them that may be. \returns the bubbles around them
  std::vector<Bubble> perform(Foam& foam) {
    std::vector<Bubble> touched;
    std::vector<Junction> used;
    for (const auto& [length, film] : closing_) {
      const std::array ends{foam.start(film.half()), foam.end(film.half())};
      const bool taken = std::ranges::find_first_of(used, ends) != used.end();
      if (!taken && may_be_swapped(foam, film)) {
        for (const Junction j : ends) {
          for (const Half h : foam.junction_half[j]) {
            touched.push_back(foam.left(h));
          }
        }
        perform_t1(foam, film);
        ++count_[film];
        swapped_.push_back(film);
        used.insert(used.end(), ends.begin(), ends.end());
      }
    }
    return touched;
  }

private:
  struct Closing {
    double length; ///< cm
    Film film;
  };

  Field<Film, std::uint8_t> count_; ///< how often each has been swapped
  std::vector<Film> swapped_;
  std::vector<Closing> closing_;
};

/// T1s of closing films that may be swapped, the shortest first.
struct ClosingFilmSwaps {
  FieldView<Film, std::uint8_t> closing; ///< 0 once it is swapped
  FieldView<Film, std::uint8_t> swaps;   ///< how often it has been

  template <class Mesh> FOAM_HOST_DEVICE static Slots<Film> candidates(const Mesh& mesh) {
    return mesh.film_slots();
  }
  FOAM_HOST_DEVICE std::uint64_t key(const ConstFoamView& mesh, Film film) const {
    return closing[film] && may_be_swapped(mesh, film)
               ? reservation_key(false, mesh.length(film.half()), film.index())
               : kNoReservation;
  }
  FOAM_HOST_DEVICE static Touched bubbles(const ConstFoamView& mesh, Film film) {
    return bubbles_around_film(mesh, film);
  }
  FOAM_HOST_DEVICE static TopologicalOperation describe(const ConstFoamView& mesh, Film film) {
    return swap_of(mesh, film);
  }
  FOAM_HOST_DEVICE void perform(FoamView& mesh, Film film) const {
    swap_film(mesh, film);
    closing[film] = 0;
    ++swaps[film];
  }
};

/// Swaps many at once (topology/reservations.h).
template <class Executor> class SwapsAtOnce {
public:
  explicit SwapsAtOnce(Executor& executor) : executor_(executor), reservations_(executor) {}

  /// Begins an equilibration: no film has been swapped.
  void begin(const FoamView& mesh) {
    count_.resize(place_of(mesh.films));
    closing_.resize(place_of(mesh.films));
    executor_.for_each(mesh.films, parallel::Fill<std::uint8_t>{count_.data(), 0});
    reservations_.take_performed(); // of one that was aborted
  }

  /// Marks the films that a step closes.
  void mark(const FoamView& mesh, const StepView& step, double t1_length) {
    const ConstFoamView foam = const_view(mesh);
    const FieldView<Film, std::uint8_t> closing(closing_.data());
    const FieldView<Film, std::uint8_t> count(count_.data());
    executor_.for_each(
        mesh.film_slots(),
        FOAM_KERNEL(Film f) { closing[f] = closes(foam, f, step, t1_length, count[f]) ? 1 : 0; });
  }

  /// Swaps those of them that may be. \returns how many
  std::int64_t perform(const FoamView& mesh) {
    const ClosingFilmSwaps swaps{FieldView<Film, std::uint8_t>(closing_.data()),
                                 FieldView<Film, std::uint8_t>(count_.data())};
    return reservations_.run(mesh, swaps);
  }

  /// All since this was asked last.
  std::vector<TopologicalOperation> take_performed() { return reservations_.take_performed(); }

private:
  Executor& executor_;
  Reservations<Executor> reservations_;
  typename Executor::template Array<std::uint8_t> count_; ///< how often each has been swapped
  typename Executor::template Array<std::uint8_t> closing_;
};

} // namespace foam::newton
