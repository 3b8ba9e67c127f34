// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/lagrangian_system.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "equilibrium/film_lagrangian.h"

namespace foam {
namespace {

// ∂²φ/∂α² in units of T·d; it is 1/3 for a straight film and falls to 0 at α = 90°.
constexpr double kKeepBelow = 0.2;     // angles that are kept from the start
constexpr double kEliminateTo = 0.1;   // an eliminated one must not fall below this
constexpr double kLargestGrowth = 0.5; // of a bubble's area that one step asks for
constexpr int kRefinements = 10;
constexpr double kRegularisation = 1e-8;
constexpr double kFirstShift = 1e-3;
constexpr double kLargestShift = 1e4;

} // namespace

double Residual::largest() const {
  return std::max({force, curvature, area});
}

LagrangianSystem::LagrangianSystem() : solver_(make_sparse_solver()) {}

void LagrangianSystem::reset() {
  last_response_.clear();
  ready_ = false;
  factorised_ = false;
  last_shift_ = 0;
}

double LagrangianSystem::pressure_jump(const Foam& foam, Index film) const {
  return foam.pressure_of(foam.left(2 * film)) - foam.pressure_of(foam.right(2 * film));
}

void LagrangianSystem::set_up(const Foam& foam, Region region) {
  region_ = std::move(region);
  topology_ = foam.topology;
  factorised_ = false;
  const double tension = 2 * foam.surface_tension;
  keep_angle_.assign(region_.films.size(), 0);
  for (std::size_t i = 0; i < region_.films.size(); ++i) {
    const Index f = region_.films[i];
    const Vec2 chord = foam.chord(2 * f);
    const FilmLagrangian film =
        film_lagrangian(chord, foam.half_angle(2 * f), pressure_jump(foam, f), tension);
    constexpr auto k = FilmLagrangian::kAngle;
    keep_angle_[i] = film.hessian[k][k] < kKeepBelow * tension * norm(chord);
  }
  renumber(foam);
  ready_ = true;
}

void LagrangianSystem::renumber(const Foam& foam) {
  number_unknowns(foam);
  build_pattern();
  analysed_ = false;
  factorised_ = false;
  last_response_.clear();
}

void LagrangianSystem::number_unknowns(const Foam& foam) {
  junction_unknown_.assign(foam.position.size(), kNone);
  bubble_unknown_.assign(foam.pressure.size(), kNone);
  Index next = 0;
  for (const Index j : region_.junctions) {
    junction_unknown_[Foam::size(j)] = next;
    next += 2;
  }
  pressure_start_ = next;
  for (const Index b : region_.bubbles) {
    bubble_unknown_[Foam::size(b)] = next++;
  }
  films_.assign(region_.films.size(), {});
  const Index angle_start = next;
  for (std::size_t i = 0; i < films_.size(); ++i) {
    const Index h = 2 * region_.films[i];
    const Index a = junction_unknown_[Foam::size(foam.start(h))];
    const Index b = junction_unknown_[Foam::size(foam.end(h))];
    const auto pressure = [&](Index bubble) {
      return bubble == kWorld ? kNone : bubble_unknown_[Foam::size(bubble)];
    };
    films_[i].unknown = {a,
                         a == kNone ? kNone : a + 1,
                         b,
                         b == kNone ? kNone : b + 1,
                         pressure(foam.left(h)),
                         pressure(foam.right(h)),
                         keep_angle_[i] ? next++ : kNone};
  }
  unknowns_ = next;
  pattern_.delicate = next - angle_start;
}

void LagrangianSystem::build_pattern() {
  struct Entry {
    Index column, row;
    Index* slot;
  };
  std::vector<Entry> entries;
  entries.reserve(28 * films_.size() + Foam::size(unknowns_));
  diagonal_.assign(Foam::size(unknowns_), kNone);
  for (Index i = 0; i < unknowns_; ++i) {
    entries.push_back({i, i, &diagonal_[Foam::size(i)]});
  }
  for (FilmUnknowns& film : films_) {
    film.slot.fill(kNone);
    std::size_t k = 0;
    for (std::size_t i = 0; i < 7; ++i) {
      for (std::size_t j = 0; j <= i; ++j, ++k) {
        const Index u = film.unknown[i];
        const Index v = film.unknown[j];
        if (u != kNone && v != kNone) {
          entries.push_back({std::min(u, v), std::max(u, v), &film.slot[k]});
        }
      }
    }
  }
  // Counting sort by column, then a sort by row within each column.
  std::vector<Index> begin(Foam::size(unknowns_) + 1, 0);
  for (const Entry& e : entries) {
    ++begin[Foam::size(e.column) + 1];
  }
  for (std::size_t i = 1; i < begin.size(); ++i) {
    begin[i] += begin[i - 1];
  }
  std::vector<Entry> sorted(entries.size());
  std::vector<Index> at = begin;
  for (const Entry& e : entries) {
    sorted[Foam::size(at[Foam::size(e.column)]++)] = e;
  }
  pattern_.column_start.assign(1, 0);
  pattern_.row.clear();
  for (Index c = 0; c < unknowns_; ++c) {
    const auto first = sorted.begin() + begin[Foam::size(c)];
    const auto last = sorted.begin() + begin[Foam::size(c) + 1];
    std::sort(first, last, [](const Entry& x, const Entry& y) { return x.row < y.row; });
    Index previous = kNone;
    for (auto e = first; e != last; ++e) {
      if (e->row != previous) {
        pattern_.row.push_back(e->row);
        previous = e->row;
      }
      *e->slot = static_cast<Index>(pattern_.row.size()) - 1;
    }
    pattern_.column_start.push_back(static_cast<Index>(pattern_.row.size()));
  }
}

Residual LagrangianSystem::evaluate(const Foam& foam) {
  const double tension = 2 * foam.surface_tension;
  gradient_.assign(Foam::size(unknowns_), 0.0);
  angle_gradient_.assign(region_.films.size(), 0.0);
  Residual residual;
  for (std::size_t i = 0; i < region_.films.size(); ++i) {
    const Index f = region_.films[i];
    const Vec2 chord = foam.chord(2 * f);
    const double alpha = foam.half_angle(2 * f);
    const double q = pressure_jump(foam, f);
    const double d = norm(chord);
    const FilmForces forces = film_forces(chord, (1 / d) * chord, d, arc_shape(alpha), q, tension);
    for (std::size_t k = 0; k < 4; ++k) {
      if (films_[i].unknown[k] != kNone) {
        gradient_[Foam::size(films_[i].unknown[k])] += forces.ends[k];
      }
    }
    const Index kept = films_[i].unknown[FilmLagrangian::kAngle];
    if (kept != kNone) {
      gradient_[Foam::size(kept)] = forces.angle;
    }
    angle_gradient_[i] = forces.angle;
    residual.curvature =
        std::max(residual.curvature, std::abs(2 * std::sin(alpha) - q * d / tension));
  }
  for (std::size_t i = 0; i < region_.junctions.size(); ++i) {
    residual.force =
        std::max(residual.force, std::hypot(gradient_[2 * i], gradient_[2 * i + 1]) / tension);
  }
  for (std::size_t i = 0; i < region_.bubbles.size(); ++i) {
    const Index b = region_.bubbles[i];
    const double target = foam.target_area[Foam::size(b)];
    const double area = foam.area(b);
    const double excess = area - target;
    const double largest = kLargestGrowth * std::abs(area);
    gradient_[Foam::size(pressure_start_) + i] = -std::clamp(excess, -largest, largest);
    residual.area = std::max(residual.area, std::abs(excess) / target);
  }
  return residual;
}

bool LagrangianSystem::assemble(const Foam& foam, double shift) {
  const double tension = 2 * foam.surface_tension;
  const double spacing = foam.mean_spacing();
  values_.assign(pattern_.row.size(), 0.0);
  condensed_.assign(region_.films.size(), {});
  bool safe = true;
  for (std::size_t i = 0; i < region_.films.size(); ++i) {
    const Index f = region_.films[i];
    const Vec2 chord = foam.chord(2 * f);
    FilmLagrangian film =
        film_lagrangian(chord, foam.half_angle(2 * f), pressure_jump(foam, f), tension);
    constexpr auto angle = FilmLagrangian::kAngle;
    const double stiffness = tension * norm(chord);
    film.hessian[angle][angle] += shift * stiffness;
    if (!keep_angle_[i]) {
      if (film.hessian[angle][angle] < kEliminateTo * stiffness) {
        keep_angle_[i] = 1;
        safe = false;
        continue;
      }
      std::copy_n(film.hessian[angle].begin(), 6, condensed_[i].coupling.begin());
      condensed_[i].pivot = film.hessian[angle][angle];
      eliminate_angle(film);
    }
    const FilmUnknowns& unknowns = films_[i];
    std::size_t k = 0;
    for (std::size_t row = 0; row < 7; ++row) {
      for (std::size_t column = 0; column <= row; ++column, ++k) {
        if (unknowns.slot[k] != kNone) {
          const bool folded = row != column && unknowns.unknown[row] == unknowns.unknown[column];
          values_[Foam::size(unknowns.slot[k])] += (folded ? 2 : 1) * film.hessian[row][column];
        }
      }
    }
  }
  const double junction_shift = (shift + kRegularisation) * tension / spacing;
  const double pressure_shift = kRegularisation * spacing * spacing * spacing / tension;
  for (Index i = 0; i < pressure_start_; ++i) {
    values_[Foam::size(diagonal_[Foam::size(i)])] += junction_shift;
  }
  for (std::size_t i = 0; i < region_.bubbles.size(); ++i) {
    values_[Foam::size(diagonal_[Foam::size(pressure_start_) + i])] -= pressure_shift;
  }
  return safe;
}

bool LagrangianSystem::factorise(const Foam& foam, Index surplus) {
  factorised_ = false;
  const auto constraints = static_cast<Index>(region_.bubbles.size());
  double shift = 0;
  while (shift <= kLargestShift) {
    if (!assemble(foam, shift)) { // some angles are to be kept that were not: other unknowns
      renumber(foam);
      evaluate(foam);
      continue;
    }
    if (!analysed_) {
      solver_->analyse(pattern_);
      analysed_ = true;
    }
    const Index negative = solver_->factorise(values_);
    if (negative >= constraints && negative - constraints <= surplus) {
      factorised_ = true;
      shift_ = shift;
      last_shift_ = shift;
      return true;
    }
    shift = shift == 0 ? std::max(kFirstShift, last_shift_ / 8) : 8 * shift;
  }
  return false;
}

const Step& LagrangianSystem::newton_step(const Foam& foam) {
  rhs_.resize(gradient_.size());
  std::ranges::transform(gradient_, rhs_.begin(), std::negate<>());
  // Condensation: the eliminated angles' residuals act on their films' unknowns.
  for (std::size_t i = 0; i < region_.films.size(); ++i) {
    if (!keep_angle_[i]) {
      const Condensed& film = condensed_[i];
      for (std::size_t k = 0; k < 6; ++k) {
        if (films_[i].unknown[k] != kNone) {
          rhs_[Foam::size(films_[i].unknown[k])] +=
              film.coupling[k] * angle_gradient_[i] / film.pivot;
        }
      }
    }
  }
  solver_->solve(rhs_);
  extract(foam, step_);
  return step_;
}

const Step* LagrangianSystem::response(const Foam& foam, const std::vector<double>& area_rate,
                                       double accuracy) {
  if (!factorised_) {
    return nullptr;
  }
  if (!assemble(foam, 0)) {
    renumber(foam);
    return nullptr;
  }
  std::vector<double> load(Foam::size(unknowns_), 0.0);
  for (std::size_t i = 0; i < region_.bubbles.size(); ++i) {
    load[Foam::size(pressure_start_) + i] = -area_rate[Foam::size(region_.bubbles[i])];
  }
  const auto speed = [&](const std::vector<double>& x) { // of the fastest junction, cm/s
    double largest = 0;
    for (std::size_t i = 0; i < Foam::size(pressure_start_); ++i) {
      largest = std::max(largest, std::abs(x[i]));
    }
    return largest;
  };
  rhs_ = last_response_;
  rhs_.resize(load.size(), 0.0);
  bool done = false;
  for (int k = 0; k < kRefinements && !done; ++k) {
    std::vector<double> correction = load;
    subtract_product(rhs_, correction);
    solver_->solve(correction);
    remove_rigid_motion(foam, correction);
    std::ranges::transform(rhs_, correction, rhs_.begin(), std::plus<>());
    done = speed(correction) <= accuracy * speed(rhs_);
  }
  if (!done && accuracy < kAnyAccuracy) {
    last_response_.clear();
    return nullptr;
  }
  last_response_ = rhs_;
  angle_gradient_.assign(region_.films.size(), 0.0);
  extract(foam, response_);
  return &response_;
}

/// from −= K·x with the matrix as it was last assembled.
void LagrangianSystem::subtract_product(std::span<const double> x, std::span<double> from) const {
  for (std::size_t column = 0; column < Foam::size(unknowns_); ++column) {
    for (Index k = pattern_.column_start[column]; k < pattern_.column_start[column + 1]; ++k) {
      const auto row = Foam::size(pattern_.row[Foam::size(k)]);
      const double value = values_[Foam::size(k)];
      from[row] -= value * x[column];
      if (row != column) {
        from[column] -= value * x[row];
      }
    }
  }
}

/// Takes out of the unknowns' changes what moves the foam as a whole: it costs nothing, so that
/// rounding decides how much of it there is. On a torus that is a translation, for a free foam a
/// rotation too.
void LagrangianSystem::remove_rigid_motion(const Foam& foam, std::span<double> change) const {
  if (!region_.whole || foam.boundary == Boundary::Fixed) {
    return;
  }
  const std::size_t junctions = region_.junctions.size();
  const auto moved = [&](std::size_t i) { return Vec2{change[2 * i], change[2 * i + 1]}; };
  const auto position = [&](std::size_t i) {
    return foam.position[Foam::size(region_.junctions[i])];
  };
  const double share = 1 / static_cast<double>(junctions);
  Vec2 translation;
  Vec2 centre;
  for (std::size_t i = 0; i < junctions; ++i) {
    translation += share * moved(i);
    centre += share * position(i);
  }
  double moment = 0;
  double inertia = 0;
  for (std::size_t i = 0; i < junctions; ++i) {
    const Vec2 r = position(i) - centre;
    moment += cross(r, moved(i));
    inertia += dot(r, r);
  }
  const double rotation = foam.boundary == Boundary::Free ? moment / inertia : 0;
  for (std::size_t i = 0; i < junctions; ++i) {
    const Vec2 rigid = translation + rotation * left_normal(position(i) - centre);
    change[2 * i] -= rigid.x;
    change[2 * i + 1] -= rigid.y;
  }
}

Vec2 LagrangianSystem::displacement(Index junction, const Step& step) const {
  const Index unknown = junction_unknown_[Foam::size(junction)];
  return unknown == kNone ? Vec2{} : step.junctions[Foam::size(unknown / 2)];
}

Vec2 LagrangianSystem::chord_change(const Foam& foam, Index film, const Step& step) const {
  return displacement(foam.end(2 * film), step) - displacement(foam.start(2 * film), step);
}

void LagrangianSystem::extract(const Foam& foam, Step& step) {
  remove_rigid_motion(foam, rhs_);
  step.junctions.resize(region_.junctions.size());
  for (std::size_t i = 0; i < region_.junctions.size(); ++i) {
    step.junctions[i] = {rhs_[2 * i], rhs_[2 * i + 1]};
  }
  step.pressures.assign(rhs_.begin() + pressure_start_,
                        rhs_.begin() + pressure_start_ +
                            static_cast<std::ptrdiff_t>(region_.bubbles.size()));
  if (region_.whole && foam.boundary != Boundary::Free) {
    // Only differences of pressure act in a closed container; their mean stays.
    double mean = 0;
    for (const double p : step.pressures) {
      mean += p;
    }
    mean /= static_cast<double>(step.pressures.size());
    for (double& p : step.pressures) {
      p -= mean;
    }
  }
  step.angles.resize(region_.films.size());
  for (std::size_t i = 0; i < region_.films.size(); ++i) {
    const Index kept = films_[i].unknown[FilmLagrangian::kAngle];
    if (kept != kNone) {
      step.angles[i] = rhs_[Foam::size(kept)];
      continue;
    }
    double sum = angle_gradient_[i];
    for (std::size_t k = 0; k < 6; ++k) {
      if (films_[i].unknown[k] != kNone) {
        sum += condensed_[i].coupling[k] * rhs_[Foam::size(films_[i].unknown[k])];
      }
    }
    step.angles[i] = -sum / condensed_[i].pivot;
  }
}

} // namespace foam
