// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/reused_factorisation.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "equilibrium/nested_dissection.h"

namespace foam {
namespace {

constexpr double kLargestChange = 0.1; // of a film's chord, or of its half-angle in rad
constexpr int kPatchRings = 1;
constexpr double kLargestPatch = 0.2; // of the foam's bubbles

/// Takes the mean out of every `stride`-th of some numbers, from `first` on.
void level(std::span<double> numbers, std::size_t first, std::size_t stride) {
  double sum = 0;
  std::size_t count = 0;
  for (std::size_t i = first; i < numbers.size(); i += stride, ++count) {
    sum += numbers[i];
  }
  for (std::size_t i = first; i < numbers.size(); i += stride) {
    numbers[i] -= sum / static_cast<double>(count);
  }
}

/// Takes out of a load what nothing but the pins of NewtonMatrix would bear: a force on the whole
/// foam, a gain of a closed container's gas.
void balance(const Surroundings& surroundings, const Unknowns& unknowns, std::span<double> load) {
  const auto coordinates = place_of(unknowns.first_pressure());
  if (surroundings.translates_along_x()) {
    level(load.first(coordinates), 0, 2);
  }
  if (surroundings.translates_along_y()) {
    level(load.first(coordinates), 1, 2);
  }
  if (surroundings.closed()) {
    level(load.subspan(coordinates, place_of(unknowns.first_angle()) - coordinates), 0, 1);
  }
}

} // namespace

Index ReusedFactorisation::factorise(const Foam& foam, const Region& region,
                                     const NewtonMatrix& matrix) {
  renumbering_.clear();
  patch_.reset();
  topology_ = foam.topology;
  whole_ = region.whole;
  if (whole_) {
    unknowns_ = matrix.unknowns();
    surroundings_ = foam.surroundings;
    films_.assign(foam.film_angle.size(), {});
    for (const Film f : region.films) {
      films_[f] = state_of(foam, f);
    }
  }
  if (numbering_ != matrix.numbering()) {
    solver_.analyse(nested_dissection(foam, region, matrix.unknowns()), matrix.shares());
    numbering_ = matrix.numbering();
  }
  return solver_.factorise(matrix.shares(), matrix.diagonal());
}

bool ReusedFactorisation::adapt(const Foam& foam, const Region& region,
                                const NewtonMatrix& matrix) {
  solver_.round();
  if (topology_ != foam.topology) {
    renumbering_ = renumbering(matrix.shares(), place_of(matrix.unknowns().count()),
                               unknowns_.of_films(foam, region.films));
    topology_ = foam.topology;
  }
  std::vector<Bubble> bubbles = changed_bubbles(foam, region);
  if (patch_ && patch_->topology == foam.topology && patch_->bubbles == bubbles) {
    return true;
  }
  patch_.reset();
  return bubbles.empty() || make_patch(foam, region, std::move(bubbles), matrix);
}

ReusedFactorisation::FilmState ReusedFactorisation::state_of(const Foam& foam, Film film) {
  const Half h = film.half();
  return {{foam.start(h), foam.end(h)},
          {foam.left(h), foam.right(h)},
          foam.chord(h),
          foam.half_angle(h)};
}

bool ReusedFactorisation::FilmState::changed(const FilmState& now) const {
  return now.ends != ends || now.sides != sides ||
         norm(now.chord - chord) > kLargestChange * norm(chord) ||
         std::abs(now.angle - angle) > kLargestChange;
}

std::vector<Bubble> ReusedFactorisation::changed_bubbles(const Foam& foam,
                                                         const Region& region) const {
  std::vector<Bubble> bubbles;
  for (const Film f : region.films) {
    if (f.place() >= films_.size() || films_[f].changed(state_of(foam, f))) {
      bubbles.insert(bubbles.end(), {foam.left(f.half()), foam.right(f.half())});
    }
  }
  return bubbles;
}

/// \returns false if the patch is too large or singular.
bool ReusedFactorisation::make_patch(const Foam& foam, const Region& region,
                                     std::vector<Bubble> bubbles, const NewtonMatrix& matrix) {
  const double most = kLargestPatch * static_cast<double>(region.bubbles.size());
  const Region around = patch(foam, bubbles, kPatchRings);
  if (static_cast<double>(around.bubbles.size()) > most) {
    return false;
  }
  std::vector<char> keep_angle(around.films.size());
  std::ranges::transform(around.films, keep_angle.begin(),
                         [&](Film f) { return keeps_angle(f) ? 1 : 0; });
  NewtonMatrix part;
  part.set_up(foam, around, std::move(keep_angle));
  part.assemble(foam, around, 0);
  patch_ = std::make_unique<Patch>(Patch{foam.topology, std::move(bubbles), {}});
  const bool regular =
      patch_->correction.set_up({part.shares().begin(), part.shares().end()}, part.diagonal(),
                                matrix.unknowns().of_films(foam, around.films),
                                nested_dissection(foam, around, part.unknowns()));
  if (!regular) {
    patch_.reset();
  }
  return regular;
}

void ReusedFactorisation::solve(std::span<double> rhs) {
  if (!patch_) {
    solve_as_before(rhs);
    return;
  }
  std::vector<double> load = patch_->correction.part_of(rhs);
  solve_as_before(rhs);
  patch_->correction.correct(std::move(load), rhs);
}

/// With the matrix that was factorised. What was not there then does not move, and its part of the
/// load is left out.
void ReusedFactorisation::solve_as_before(std::span<double> rhs) {
  if (renumbering_.empty()) {
    if (whole_) {
      balance(surroundings_, unknowns_, rhs);
    }
    solver_.solve(rhs);
    return;
  }
  std::vector<double> old(place_of(unknowns_.count()), 0.0);
  for (std::size_t u = 0; u < rhs.size(); ++u) {
    if (renumbering_[u] != kNone) {
      old[place_of(renumbering_[u])] = rhs[u];
    }
  }
  balance(surroundings_, unknowns_, old);
  solver_.solve(old);
  for (std::size_t u = 0; u < rhs.size(); ++u) {
    rhs[u] = renumbering_[u] == kNone ? 0 : old[place_of(renumbering_[u])];
  }
}

} // namespace foam
