// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/newton_matrix.h"

#include <algorithm>
#include <utility>

#include "equilibrium/zero_modes.h"
#include "parallel/host.h"

namespace foam {
namespace {

constexpr auto kAngle = FilmLagrangian::kAngle;
using newton::kRegularisation;
constexpr std::size_t kAngleRow = kAngle * (kAngle + 1) / 2; // in a lower triangle

// ∂²φ/∂α² in units of T·d; it is 1/3 for a straight film and falls to 0 at α = 90°.
constexpr double kKeepBelow = 0.2;   // angles that are kept from the start
constexpr double kEliminateTo = 0.1; // an eliminated one must not fall below this

FilmLagrangian lagrangian_of(const Foam& foam, Film film) {
  const Half h = film.half();
  FilmLagrangian phi = film_lagrangian(foam.chord(h), foam.half_angle(h),
                                       foam.pressure_difference(h), foam.tension(film));
  for (const Half end : {h, h.twin()}) {
    if (const Junction j = foam.start(end); foam.on_wall(j) && !foam.pinned(j)) {
      keep_to_curve(phi, end.reversed() ? 1 : 0, foam.freedom(j),
                    foam.tension(film) / foam.length(h));
    }
  }
  return phi;
}

double stiffness(const Foam& foam, Film film) {
  return foam.tension(film) * norm(foam.chord(film.half()));
}

/// \returns false if the film's angle must be kept but is not.
bool assemble_film(const Foam& foam, Film film, double shift, FilmMatrix& share) {
  FilmLagrangian phi = lagrangian_of(foam, film);
  const double scale = stiffness(foam, film);
  phi.hessian[kAngle][kAngle] += shift * scale;
  if (share.unknown[kAngle] == kNone) {
    if (phi.hessian[kAngle][kAngle] < kEliminateTo * scale) {
      return false;
    }
    eliminate_angle(phi);
  }
  for_each_lower<FilmLagrangian::kVariables>(
      [&](std::size_t row, std::size_t column, std::size_t k) {
        share.value[k] = phi.hessian[row][column];
      });
  return true;
}

} // namespace

bool NewtonMatrix::angle_is_delicate(const Foam& foam, Film film) {
  return lagrangian_of(foam, film).hessian[kAngle][kAngle] < kKeepBelow * stiffness(foam, film);
}

void NewtonMatrix::set_up(const Foam& foam, const Region& region, std::vector<char> keep_angle) {
  keep_angle_ = std::move(keep_angle);
  unknowns_.number(foam, region, keep_angle_);
  ++numbering_;
  films_.assign(region.films.size(), {});
  for (std::size_t i = 0; i < films_.size(); ++i) {
    films_[i].unknown = unknowns_.of_film(foam, region.films[i]);
  }
}

bool NewtonMatrix::assemble(const Foam& foam, const Region& region, double shift) {
  std::vector<char> keep = keep_angle_;
  Host().for_each(static_cast<Index>(films_.size()), [&](Index i) {
    const std::size_t place = place_of(i);
    if (!assemble_film(foam, region.films[place], shift, films_[place])) {
      keep[place] = 1;
    }
  });
  if (keep != keep_angle_) {
    set_up(foam, region, std::move(keep));
    return false;
  }
  const double tension = foam.reference_tension();
  const double spacing = region.spacing;
  regularisation_.assign(place_of(unknowns_.count()), 0);
  const auto pressures = regularisation_.begin() + unknowns_.first_pressure();
  std::fill(regularisation_.begin(), pressures, (shift + kRegularisation) * tension / spacing);
  std::fill_n(pressures, region.bubbles.size(),
              -kRegularisation * spacing * spacing * spacing / tension);
  diagonal_ = regularisation_;
  const bool pinned = region.whole && shift == 0;
  if (pinned && foam.surroundings.translates_along_x()) {
    diagonal_[0] += tension / spacing;
  }
  if (pinned && foam.surroundings.translates_along_y()) {
    diagonal_[1] += tension / spacing;
  }
  if (pinned && foam.surroundings.closed()) {
    diagonal_[place_of(unknowns_.first_pressure())] -= spacing * spacing * spacing / tension;
  }
  return true;
}

void NewtonMatrix::add_angles(std::span<const double> angle_gradient, std::span<double> rhs) const {
  for (std::size_t i = 0; i < films_.size(); ++i) {
    const FilmLagrangian::Each<Index>& unknown = films_[i].unknown;
    if (unknown[kAngle] != kNone) {
      rhs[place_of(unknown[kAngle])] -= angle_gradient[i];
      continue;
    }
    const double* const row = &films_[i].value[kAngleRow];
    for (std::size_t k = 0; k < kAngle; ++k) {
      if (unknown[k] != kNone) {
        rhs[place_of(unknown[k])] += row[k] * angle_gradient[i] / row[kAngle];
      }
    }
  }
}

double NewtonMatrix::angle_change(std::size_t place, double angle_gradient,
                                  std::span<const double> x,
                                  const FilmLagrangian::Each<double>& held) const {
  const FilmMatrix& film = films_[place];
  FilmLagrangian::Each<double> change = held;
  for (std::size_t k = 0; k < change.size(); ++k) {
    if (film.unknown[k] != kNone) {
      change[k] = x[place_of(film.unknown[k])];
    }
  }
  return film.unknown[kAngle] != kNone
             ? change[kAngle]
             : eliminated_angle(angle_gradient, &film.value[kAngleRow], change);
}

void NewtonMatrix::subtract_product(std::span<const double> x, std::span<double> from) const {
  for (std::size_t u = 0; u < from.size(); ++u) {
    from[u] -= regularisation_[u] * x[u];
  }
  for (const FilmMatrix& film : films_) {
    foam::subtract_product(film, film.unknown, x, from);
  }
}

} // namespace foam
