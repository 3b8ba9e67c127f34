// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/newton_matrix.h"

#include <algorithm>

#include "base/number.h"
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
  return film_lagrangian(foam.chord(h), foam.half_angle(h), foam.pressure_difference(h),
                         foam.tension(film));
}

double stiffness(const Foam& foam, Film film) {
  return foam.tension(film) * norm(foam.chord(film.half()));
}

} // namespace

bool NewtonMatrix::angle_is_delicate(const Foam& foam, Film film) {
  return lagrangian_of(foam, film).hessian[kAngle][kAngle] < kKeepBelow * stiffness(foam, film);
}

void NewtonMatrix::set_up(const Foam& foam, const Region& region,
                          std::span<const char> keep_angle) {
  unknowns_.number(foam, region, keep_angle);
  films_.assign(region.films.size(), {});
  for (std::size_t i = 0; i < films_.size(); ++i) {
    films_[i].unknown = unknowns_.of_film(foam, region.films[i]);
  }
}

std::vector<std::size_t> NewtonMatrix::assemble(const Foam& foam, const Region& region,
                                                double shift) {
  std::vector<char> safe(films_.size());
  Host().for_each(static_cast<Index>(films_.size()), [&](Index i) {
    safe[place_of(i)] = assemble_film(foam, region, place_of(i), shift) ? 1 : 0;
  });
  std::vector<std::size_t> unsafe;
  for (std::size_t i = 0; i < films_.size(); ++i) {
    if (!safe[i]) {
      unsafe.push_back(i);
    }
  }
  const double tension = foam.reference_tension();
  const double spacing = region.spacing;
  junction_diagonal_ = (shift + kRegularisation) * tension / spacing;
  pressure_diagonal_ = -kRegularisation * spacing * spacing * spacing / tension;
  const bool pinned = region.whole && shift == 0;
  junction_pin_ = pinned && foam.surroundings.translates() ? tension / spacing : 0;
  pressure_pin_ = pinned && foam.surroundings.closed() ? -spacing * spacing * spacing / tension : 0;
  return unsafe;
}

bool NewtonMatrix::assemble_film(const Foam& foam, const Region& region, std::size_t place,
                                 double shift) {
  FilmLagrangian film = lagrangian_of(foam, region.films[place]);
  const double scale = stiffness(foam, region.films[place]);
  film.hessian[kAngle][kAngle] += shift * scale;
  if (!keeps_angle(place)) {
    if (film.hessian[kAngle][kAngle] < kEliminateTo * scale) {
      return false;
    }
    eliminate_angle(film);
  }
  for_each_lower<FilmLagrangian::kVariables>(
      [&](std::size_t row, std::size_t column, std::size_t k) {
        films_[place].value[k] = film.hessian[row][column];
      });
  return true;
}

double NewtonMatrix::regularisation(std::size_t unknown) const {
  if (unknown < place_of(unknowns_.first_pressure())) {
    return junction_diagonal_;
  }
  return unknown < place_of(unknowns_.first_angle()) ? pressure_diagonal_ : 0;
}

void NewtonMatrix::condense(std::span<const double> angle_gradient, std::span<double> rhs) const {
  for (std::size_t i = 0; i < films_.size(); ++i) {
    if (!keeps_angle(i)) {
      const double* const row = &films_[i].value[kAngleRow];
      for (std::size_t k = 0; k < kAngle; ++k) {
        if (films_[i].unknown[k] != kNone) {
          rhs[place_of(films_[i].unknown[k])] += row[k] * angle_gradient[i] / row[kAngle];
        }
      }
    }
  }
}

double NewtonMatrix::angle_change(std::size_t place, double angle_gradient,
                                  std::span<const double> x,
                                  const FilmLagrangian::Each<double>& held) const {
  const FilmMatrix& film = films_[place];
  if (film.unknown[kAngle] != kNone) {
    return x[place_of(film.unknown[kAngle])];
  }
  double sum = angle_gradient;
  for (std::size_t k = 0; k < kAngle; ++k) {
    const Index u = film.unknown[k];
    sum += film.value[kAngleRow + k] * (u == kNone ? held[k] : x[place_of(u)]);
  }
  return -sum / film.value[kAngleRow + kAngle];
}

void NewtonMatrix::subtract_product(std::span<const double> x, std::span<double> from) const {
  for (std::size_t u = 0; u < from.size(); ++u) {
    from[u] -= regularisation(u) * x[u];
  }
  for (const FilmMatrix& film : films_) {
    foam::subtract_product(film, film.unknown, x, from);
  }
}

void NewtonMatrix::subtract_product(std::span<const double> x,
                                    std::span<const FilmLagrangian::Each<Index>> columns,
                                    std::span<const Index> rows, std::span<double> from) const {
  for (std::size_t u = 0; u < from.size(); ++u) {
    from[u] -= regularisation(u) * x[place_of(rows[u])];
  }
  for (std::size_t i = 0; i < films_.size(); ++i) {
    foam::subtract_product(films_[i], columns[i], x, from);
  }
}

std::vector<double> NewtonMatrix::diagonal() const {
  std::vector<double> diagonal(place_of(unknowns_.count()));
  for (std::size_t u = 0; u < diagonal.size(); ++u) {
    diagonal[u] = regularisation(u);
  }
  if (junction_pin_ > 0) {
    diagonal[0] += junction_pin_;
    diagonal[1] += junction_pin_;
  }
  if (pressure_pin_ < 0) {
    diagonal[place_of(unknowns_.first_pressure())] += pressure_pin_;
  }
  return diagonal;
}

} // namespace foam
