// SPDX-License-Identifier: GPL-3.0-or-later
#include "junction/junction_equilibrator.h"
#include "mesh/number.h"
#include "mesh/validate.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <thread>

namespace foam {
namespace {

void require(bool holds, const std::string& name, const std::string& range, double value) {
  if (!holds) {
    throw FoamError(name + " must be " + range + ", but is " + number(value));
  }
}

void check(const EquilibratorOptions& options) {
  const JunctionOptions& junction = options.junction;
  const auto positive = [](double x) { return x > 0 && std::isfinite(x); };
  require(options.maximum_iterations > 0, "MaximumIterations", "positive",
          options.maximum_iterations);
  require(junction.damping > 0 && junction.damping <= 1, "Damping", "in (0, 1]", junction.damping);
  require(positive(junction.finite_difference_step), "FiniteDifferenceStep", "positive",
          junction.finite_difference_step);
  require(positive(junction.jacobian_tolerance), "JacobianTolerance", "positive",
          junction.jacobian_tolerance);
  require(positive(junction.pressure_tolerance), "PressureTolerance", "positive",
          junction.pressure_tolerance);
  require(positive(junction.position_tolerance), "PositionTolerance", "positive",
          junction.position_tolerance);
  require(junction.minimum_scale > 0 && junction.minimum_scale < 1, "MinimumScale", "in (0, 1)",
          junction.minimum_scale);
}

/// Fewer junctions than these are not worth a thread of their own.
constexpr std::size_t kLeastPerThread = 64;

/// Calls work(begin, end) for equal pieces of [0, size), each in a thread of its own.
template <class Work> void in_threads(std::size_t size, std::size_t threads, const Work& work) {
  const std::size_t pieces = std::clamp<std::size_t>(size / kLeastPerThread, 1, threads);
  std::vector<std::jthread> others;
  others.reserve(pieces - 1);
  for (std::size_t i = 1; i < pieces; ++i) {
    others.emplace_back(work, i * size / pieces, (i + 1) * size / pieces);
  }
  work(0, size / pieces);
}

/// The half-angles that go with the pressures.
void write_half_angles(Foam& foam) {
  for (Index f = 0; f < foam.film_capacity(); ++f) {
    const Index h = 2 * f;
    if (foam.has_film(f)) {
      const double difference = foam.pressure_of(foam.left(h)) - foam.pressure_of(foam.right(h));
      foam.set_half_angle(h, foam.wall(h)
                                 ? 0
                                 : junction::thesis_half_angle(norm(foam.chord(h)), difference,
                                                               foam.surface_tension));
    }
  }
}

} // namespace

JunctionEquilibrator::JunctionEquilibrator(const EquilibratorOptions& options, int threads)
    : options_(options),
      threads_(threads > 0 ? threads
                           : static_cast<int>(std::max(1U, std::thread::hardware_concurrency()))) {
  check(options);
}

void JunctionEquilibrator::Maxima::include(const junction::JunctionChange& change) {
  solvable = solvable && change.solvable;
  for (const double dp : change.pressure) {
    pressure = std::max(pressure, std::abs(dp));
  }
  position = std::max(position, norm(change.position));
}

/// Figure 4.12: all junctions solve against one state of the foam. Positions then change one after
/// the other, as the constraints need it, pressures all at the end.
JunctionEquilibrator::Maxima JunctionEquilibrator::sweep_jacobi(Foam& foam) {
  const JunctionOptions& options = options_.junction;
  steps_.resize(foam.position.size());
  in_threads(steps_.size(), static_cast<std::size_t>(threads_),
             [&](std::size_t begin, std::size_t end) {
               for (std::size_t j = begin; j < end; ++j) {
                 if (foam.has_junction(static_cast<Index>(j))) {
                   steps_[j] = junction::junction_step(foam, static_cast<Index>(j), options);
                 }
               }
             });
  Maxima maxima;
  pressure_change_.assign(foam.pressure.size(), 0);
  for (Index j = 0; j < foam.junction_capacity(); ++j) {
    if (!foam.has_junction(j)) {
      continue;
    }
    const junction::JunctionChange change =
        junction::move_junction(foam, j, steps_[Foam::size(j)], options);
    maxima.include(change);
    for (std::size_t k = 0; k < 3; ++k) {
      if (const Index b = foam.left(foam.junction_half[Foam::size(j)][k]); b != kWorld) {
        pressure_change_[Foam::size(b)] += change.pressure[k];
      }
    }
  }
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    if (foam.has_bubble(b)) {
      foam.pressure[Foam::size(b)] += pressure_change_[Foam::size(b)] / foam.sides[Foam::size(b)];
    }
  }
  return maxima;
}

/// Figure 3.13: each junction solves against what the ones before it have left.
JunctionEquilibrator::Maxima JunctionEquilibrator::sweep_gauss_seidel(Foam& foam) const {
  Maxima maxima;
  for (Index j = 0; j < foam.junction_capacity(); ++j) {
    if (foam.has_junction(j)) {
      maxima.include(junction::equilibrate_junction(foam, j, options_.junction));
    }
  }
  return maxima;
}

/// Figure 4.3, with the thesis's words where they differ from it: what counts are the changes after
/// each junction's equilibration, another sweep follows if either maximum differs by more than its
/// tolerance from the last sweep's, and it may differ in either direction.
bool JunctionEquilibrator::halt(const Maxima& now, const Maxima& old) const {
  return std::abs(now.pressure - old.pressure) <= options_.junction.pressure_tolerance &&
         std::abs(now.position - old.position) <= options_.junction.position_tolerance;
}

EquilibriumReport JunctionEquilibrator::equilibrate(Foam& foam, double /*t1_length*/,
                                                    const AbortCheck& aborted) {
  const std::vector<Vec2> position = foam.position;
  const std::vector<double> pressure = foam.pressure;
  EquilibriumReport report;
  Maxima now;
  bool halted = false;
  while (!halted && report.iterations < options_.maximum_iterations) {
    if (aborted && aborted()) {
      foam.position = position;
      foam.pressure = pressure;
      throw Aborted();
    }
    const Maxima old = now;
    now = options_.junction.sweep == Sweep::Jacobi ? sweep_jacobi(foam) : sweep_gauss_seidel(foam);
    ++report.iterations;
    halted = halt(now, old);
  }
  write_half_angles(foam);
  report.max_angle_error = max_angle_error(foam);
  report.max_area_error = max_area_error(foam);
  report.residual = std::max(report.max_angle_error, report.max_area_error);
  report.converged =
      halted && now.solvable && std::isfinite(report.residual) && validate_geometry(foam).empty();
  foam.report = report;
  return report;
}

} // namespace foam
