// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/globalisation.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "physics/step_limits.h"

namespace foam {
namespace {

constexpr double kLargestMove = 0.3; // of a junction's shortest film, in a limited step

} // namespace

Snapshot::Snapshot(const Foam& foam, const Region& region) : region_(region) {
  for (const Index j : region.junctions) {
    values_.junctions.push_back(foam.position[Foam::size(j)]);
  }
  for (const Index f : region.films) {
    values_.angles.push_back(foam.film_angle[Foam::size(f)]);
  }
  for (const Index b : region.bubbles) {
    values_.pressures.push_back(foam.pressure[Foam::size(b)]);
  }
}

void Snapshot::restore(Foam& foam) const {
  for (std::size_t i = 0; i < region_.junctions.size(); ++i) {
    foam.position[Foam::size(region_.junctions[i])] = values_.junctions[i];
  }
  for (std::size_t i = 0; i < region_.films.size(); ++i) {
    foam.film_angle[Foam::size(region_.films[i])] = values_.angles[i];
  }
  for (std::size_t i = 0; i < region_.bubbles.size(); ++i) {
    foam.pressure[Foam::size(region_.bubbles[i])] = values_.pressures[i];
  }
}

void Snapshot::advance(Foam& foam, const Step& step, double fraction) const {
  restore(foam);
  for (std::size_t i = 0; i < region_.junctions.size(); ++i) {
    foam.position[Foam::size(region_.junctions[i])] += fraction * step.junctions[i];
  }
  for (std::size_t i = 0; i < region_.films.size(); ++i) {
    foam.film_angle[Foam::size(region_.films[i])] += fraction * step.angles[i];
  }
  for (std::size_t i = 0; i < region_.bubbles.size(); ++i) {
    foam.pressure[Foam::size(region_.bubbles[i])] += fraction * step.pressures[i];
  }
}

double longest_step(const Foam& foam, const LagrangianSystem& system, const Step& step) {
  double fraction = 1;
  const Region& region = system.region();
  for (std::size_t i = 0; i < region.films.size(); ++i) {
    const Index f = region.films[i];
    fraction =
        std::min(fraction, longest_film_step(foam.chord(2 * f), system.chord_change(foam, f, step),
                                             foam.half_angle(2 * f), step.angles[i]));
  }
  return fraction;
}

Step limited_step(const Foam& foam, const LagrangianSystem& system, const Step& step) {
  Step limited = step;
  const Region& region = system.region();
  for (std::size_t i = 0; i < region.junctions.size(); ++i) {
    double shortest = std::numeric_limits<double>::infinity();
    for (const Index h : foam.junction_half[Foam::size(region.junctions[i])]) {
      shortest = std::min(shortest, norm(foam.chord(h)));
    }
    const double length = norm(step.junctions[i]);
    if (length > kLargestMove * shortest) {
      limited.junctions[i] = (kLargestMove * shortest / length) * step.junctions[i];
    }
  }
  for (std::size_t i = 0; i < region.films.size(); ++i) {
    const double largest =
        largest_turn(foam.film_angle[Foam::size(region.films[i])], step.angles[i]);
    limited.angles[i] = std::clamp(step.angles[i], -largest, largest);
  }
  return limited;
}

Merit::Merit(const Foam& foam, const LagrangianSystem& system, const Step& step)
    : region_(system.region()), mu_(penalty(foam, system, step)) {}

double Merit::operator()(const Foam& foam) const {
  double length = 0;
  for (const Index f : region_.films) {
    length += foam.length(2 * f);
  }
  double work = 0;
  for (const Index b : region_.rim) {
    work += foam.pressure[Foam::size(b)] * foam.area(b);
  }
  return 2 * foam.surface_tension * length - work + mu_ * violation(foam);
}

double Merit::violation(const Foam& foam) const {
  double sum = 0;
  for (const Index b : region_.bubbles) {
    sum += std::abs(foam.area(b) - foam.target_area[Foam::size(b)]);
  }
  return sum;
}

/// μ above the largest multiplier before and after the step, and large enough for the step to be
/// a direction of descent (Nocedal & Wright, 18.36).
double Merit::penalty(const Foam& foam, const LagrangianSystem& system, const Step& step) const {
  double largest = 0;
  for (std::size_t i = 0; i < region_.bubbles.size(); ++i) {
    const double p = foam.pressure[Foam::size(region_.bubbles[i])];
    largest = std::max({largest, std::abs(p), std::abs(p + step.pressures[i])});
  }
  double slope = 0; // of the films' energy along the step
  for (std::size_t i = 0; i < region_.films.size(); ++i) {
    const Index f = region_.films[i];
    slope += arc_growth(foam.chord(2 * f), system.chord_change(foam, f, step),
                        foam.half_angle(2 * f), step.angles[i]);
  }
  slope *= 2 * foam.surface_tension;
  const double floor = 1e-3 * foam.surface_tension / region_.spacing;
  const double descent = slope > 0 ? slope / violation(foam) : 0;
  return 1.5 * std::max(largest, std::isfinite(descent) ? descent : 0) + floor;
}

} // namespace foam
