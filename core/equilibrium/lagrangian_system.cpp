// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/lagrangian_system.h"

#include <algorithm>
#include <cmath>
#include <functional>

#include "algebra/conjugate_residuals.h"
#include "parallel/host.h"
#include "parallel/kernels.h"
#include "physics/film_lagrangian.h"

namespace foam {
namespace {

constexpr double kLargestGrowth = 0.5; // of a bubble's area that one step asks for
constexpr int kDirections = 8;         // after which a new factorisation is cheaper
constexpr double kForcing = 1e-2;      // of the load, that an inexact step may leave
constexpr double kFirstShift = 1e-3;
constexpr double kLargestShift = 1e4;

} // namespace

double Residual::largest() const {
  constexpr parallel::Larger larger{};
  return larger(larger(force, curvature), area);
}

void LagrangianSystem::reset() {
  ready_ = false;
  factorised_ = false;
  last_shift_ = 0;
}

void LagrangianSystem::set_up(const Foam& foam, Region region) {
  const bool adapt = factorised_ && !shifted() && region_.whole && region.whole;
  region_ = std::move(region);
  topology_ = foam.topology;
  ready_ = true;
  keep_angle_.clear();
  for (const Index f : region_.films) {
    keep_angle_.push_back(adapt ? factorisation_.keeps_angle(f)
                                : NewtonMatrix::angle_is_delicate(foam, f));
  }
  renumber(foam);
  factorised_ = adapt;
}

void LagrangianSystem::renumber(const Foam& foam) {
  matrix_.set_up(foam, region_, keep_angle_);
  assembled_ = false;
  analysed_ = false;
  factorised_ = false;
}

Residual LagrangianSystem::evaluate(const Foam& foam) {
  assembled_ = false;
  const double tension = 2 * foam.surface_tension;
  gradient_.assign(Foam::size(matrix_.unknowns().count()), 0.0);
  angle_gradient_.assign(region_.films.size(), 0.0);
  std::vector<std::array<double, 4>> ends(region_.films.size());
  std::vector<double> curvature(region_.films.size());
  segments_.resize(foam.film_angle.size());
  Host().for_each(static_cast<Index>(region_.films.size()), [&](Index place) {
    const auto i = Foam::size(place);
    const Index h = 2 * region_.films[i];
    const Vec2 chord = foam.chord(h);
    const double alpha = foam.half_angle(h);
    const double q = foam.pressure_of(foam.left(h)) - foam.pressure_of(foam.right(h));
    const double d = norm(chord);
    const ArcShape shape = arc_shape(alpha);
    const FilmForces forces = film_forces(chord, (1 / d) * chord, d, shape, q, tension);
    ends[i] = forces.ends;
    segments_[Foam::size(region_.films[i])] = d * d * shape.g;
    angle_gradient_[i] = forces.angle;
    curvature[i] = std::abs(forces.angle) / (tension * d * shape.g1); // since f′ = 2 sin α · g′
  });
  constexpr parallel::Larger larger{};
  Residual residual;
  for (std::size_t i = 0; i < region_.films.size(); ++i) {
    const std::array<Index, 7> unknown = matrix_.film_unknowns(i);
    for (std::size_t k = 0; k < 4; ++k) {
      if (unknown[k] != kNone) {
        gradient_[Foam::size(unknown[k])] += ends[i][k];
      }
    }
    const Index kept = unknown[FilmLagrangian::kAngle];
    if (kept != kNone) {
      gradient_[Foam::size(kept)] = angle_gradient_[i];
    }
    residual.curvature = larger(residual.curvature, curvature[i]);
  }
  for (std::size_t i = 0; i < region_.junctions.size(); ++i) {
    residual.force =
        larger(residual.force, norm(Vec2{gradient_[2 * i], gradient_[2 * i + 1]}) / tension);
  }
  for (std::size_t i = 0; i < region_.bubbles.size(); ++i) {
    const Index b = region_.bubbles[i];
    const double target = foam.target_area[Foam::size(b)];
    const double area =
        foam.area(b, [&](Index f) { return foam.wall(2 * f) ? 0 : segments_[Foam::size(f)]; });
    const double excess = area - target;
    const double largest = kLargestGrowth * std::abs(area);
    gradient_[Foam::size(matrix_.unknowns().first_pressure()) + i] =
        -std::clamp(excess, -largest, largest);
    residual.area = larger(residual.area, std::abs(excess) / target);
  }
  return residual;
}

std::vector<Index> LagrangianSystem::rough_bubbles(const Foam& foam, double limit) const {
  const double tension = 2 * foam.surface_tension;
  std::vector<Index> rough;
  for (std::size_t i = 0; i < region_.films.size(); ++i) {
    const Index h = 2 * region_.films[i];
    if (std::abs(angle_gradient_[i]) > limit * tension * norm(foam.chord(h))) {
      rough.insert(rough.end(), {foam.left(h), foam.right(h)});
    }
  }
  for (std::size_t i = 0; i < region_.junctions.size(); ++i) {
    if (norm(Vec2{gradient_[2 * i], gradient_[2 * i + 1]}) > limit * tension) {
      for (const Index h : foam.junction_half[Foam::size(region_.junctions[i])]) {
        rough.push_back(foam.left(h));
      }
    }
  }
  const auto areas = std::span(gradient_).subspan(Foam::size(matrix_.unknowns().first_pressure()));
  for (std::size_t i = 0; i < region_.bubbles.size(); ++i) {
    const Index b = region_.bubbles[i];
    if (std::abs(areas[i]) > limit * foam.target_area[Foam::size(b)]) {
      rough.push_back(b);
    }
  }
  std::ranges::sort(rough);
  const auto repeated = std::ranges::unique(rough);
  rough.erase(repeated.begin(), repeated.end());
  return rough;
}

/// \returns false if some angles are to be kept that were not: the unknowns are others then.
bool LagrangianSystem::assemble(const Foam& foam, double shift) {
  if (assembled_ && shift == 0) {
    return true;
  }
  const std::vector<std::size_t> unsafe = matrix_.assemble(foam, region_, shift);
  for (const std::size_t i : unsafe) {
    keep_angle_[i] = 1;
  }
  if (!unsafe.empty()) {
    renumber(foam);
    return false;
  }
  assembled_ = shift == 0;
  return true;
}

bool LagrangianSystem::factorise(const Foam& foam, Index surplus) {
  factorised_ = false;
  const auto constraints = static_cast<Index>(region_.bubbles.size());
  double shift = 0;
  while (shift <= kLargestShift) {
    if (!assemble(foam, shift)) {
      evaluate(foam);
      continue;
    }
    if (!analysed_) {
      factorisation_.analyse(foam, region_, matrix_);
      analysed_ = true;
    }
    const Index negative = factorisation_.factorise(foam, region_, matrix_);
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

bool LagrangianSystem::adapt(const Foam& foam) {
  if (factorised_ && !assemble(foam, 0)) {
    evaluate(foam);
  }
  factorised_ = factorised_ &&
                (!region_.whole || (!shifted() && factorisation_.adapt(foam, region_, matrix_)));
  return factorised_;
}

const Step& LagrangianSystem::newton_step(const Foam& foam) {
  std::vector<double> change = load();
  factorisation_.solve(change);
  extract(foam, change, angle_gradient_, {}, step_);
  return step_;
}

const Step* LagrangianSystem::newton_step(const Foam& foam, double limit) {
  std::vector<double> rest = load();
  std::vector<double> change(rest.size(), 0.0);
  const double most = largest(foam, rest);
  // A load below the limit is to be met too: areas are measured here by the mean, not by their own.
  const double enough = limit < most ? std::max(limit, kForcing * most) : kForcing * most;
  if (!solve(foam, change, rest, enough)) {
    return nullptr;
  }
  extract(foam, change, angle_gradient_, {}, step_);
  return &step_;
}

/// The right-hand side of Newton's equations.
std::vector<double> LagrangianSystem::load() const {
  std::vector<double> load(gradient_.size());
  std::ranges::transform(gradient_, load.begin(), std::negate<>());
  matrix_.condense(angle_gradient_, load);
  return load;
}

/// Adds to a change what takes away the rest of the load that it leaves, down to a limit of
/// dimensionless residuals. \returns whether the limit is met.
bool LagrangianSystem::solve(const Foam& foam, std::span<double> change, std::vector<double>& rest,
                             double limit) {
  const Residual unit = units(foam);
  const Unknowns& unknowns = matrix_.unknowns();
  std::vector<double> weight(rest.size(), 1 / unit.curvature);
  const auto first_pressure = weight.begin() + unknowns.first_pressure();
  const auto first_angle = weight.begin() + unknowns.first_angle();
  std::fill(weight.begin(), first_pressure, 1 / unit.force);
  std::fill(first_pressure, first_angle, 1 / unit.area);
  return conjugate_residuals(
      change, rest, weight,
      [&](std::span<const double> x, std::span<double> from) { matrix_.subtract_product(x, from); },
      [&](std::span<double> x) {
        factorisation_.solve(x);
        remove_rigid_motion(foam, x);
      },
      [&](std::span<const double> left) { return largest(foam, left) <= limit; }, kDirections);
}

const Step* LagrangianSystem::response(const Foam& foam, const std::vector<double>& area_rate,
                                       const Rates& expected, double drift) {
  if (drift < kAnyDrift && !adapt(foam)) {
    return nullptr;
  }
  const Unknowns& unknowns = matrix_.unknowns();
  std::vector<double> change(Foam::size(unknowns.count()), 0.0);
  std::vector<double> rest(change.size(), 0.0);
  for (std::size_t i = 0; i < region_.bubbles.size(); ++i) {
    rest[Foam::size(unknowns.first_pressure()) + i] = -area_rate[Foam::size(region_.bubbles[i])];
  }
  for (std::size_t i = 0; i < region_.films.size(); ++i) {
    const FilmShare& share = matrix_.shares()[i];
    const std::array<double, 7> rates = expected.of_film(foam, region_.films[i]);
    subtract_product(share, rates, rest);
    for (std::size_t k = 0; k < rates.size(); ++k) {
      if (share.unknown[k] != kNone) {
        change[Foam::size(share.unknown[k])] = rates[k];
      }
    }
  }
  if (drift == kAnyDrift) {
    factorisation_.solve(rest);
    std::ranges::transform(change, rest, change.begin(), std::plus<>());
  } else if (!solve(foam, change, rest, drift)) {
    return nullptr;
  }
  const std::vector<double> balanced(region_.films.size(), 0.0);
  extract(foam, change, balanced, expected, response_);
  return &response_;
}

/// What residuals of the unknowns' equations are measured in: T for forces, the mean area, and
/// T·spacing for half-angles.
Residual LagrangianSystem::units(const Foam& foam) const {
  const double tension = 2 * foam.surface_tension;
  return {.force = tension,
          .curvature = tension * region_.spacing,
          .area = region_.spacing * region_.spacing};
}

/// The largest dimensionless residual, areas in units of the mean.
double LagrangianSystem::largest(const Foam& foam, std::span<const double> rest) const {
  const Residual unit = units(foam);
  const Unknowns& unknowns = matrix_.unknowns();
  constexpr parallel::Larger larger{};
  const auto part = [&](Index begin, Index end) {
    double most = 0;
    for (Index u = begin; u < end; ++u) {
      most = larger(most, std::abs(rest[Foam::size(u)]));
    }
    return most;
  };
  return larger(larger(part(0, unknowns.first_pressure()) / unit.force,
                       part(unknowns.first_pressure(), unknowns.first_angle()) / unit.area),
                part(unknowns.first_angle(), unknowns.count()) / unit.curvature);
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
  const Index unknown = matrix_.unknowns().junction(junction);
  return unknown == kNone ? Vec2{} : step.junctions[Foam::size(unknown / 2)];
}

Vec2 LagrangianSystem::chord_change(const Foam& foam, Index film, const Step& step) const {
  return displacement(foam.end(2 * film), step) - displacement(foam.start(2 * film), step);
}

/// \param angle_gradient that the change is to bring to zero, by place in region_.films
/// \param held how what is held changes
void LagrangianSystem::extract(const Foam& foam, std::span<double> change,
                               std::span<const double> angle_gradient, const Rates& held,
                               Step& step) const {
  remove_rigid_motion(foam, change);
  step.junctions.resize(region_.junctions.size());
  for (std::size_t i = 0; i < region_.junctions.size(); ++i) {
    step.junctions[i] = {change[2 * i], change[2 * i + 1]};
  }
  const auto pressures =
      change.subspan(Foam::size(matrix_.unknowns().first_pressure()), region_.bubbles.size());
  step.pressures.assign(pressures.begin(), pressures.end());
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
    step.angles[i] =
        matrix_.angle_change(i, angle_gradient[i], change, held.of_film(foam, region_.films[i]));
  }
}

} // namespace foam
