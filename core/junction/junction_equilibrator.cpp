// SPDX-License-Identifier: GPL-3.0-or-later
#include "junction/junction_equilibrator.h"

#include <cmath>
#include <string>

#include "mesh/number.h"

namespace foam {
namespace {

void require(bool holds, const std::string& name, const std::string& range, double value) {
  if (!holds) {
    throw FoamError(name + " must be " + range + ", but is " + number(value));
  }
}

/// Figure 3.13: each junction solves against what the ones before it have left.
junction::Maxima sweep_gauss_seidel(Foam& foam, const JunctionOptions& options) {
  junction::Maxima maxima;
  for (Index j = 0; j < foam.junction_capacity(); ++j) {
    if (foam.has_junction(j)) {
      maxima.include(junction::equilibrate_junction(foam, j, options));
    }
  }
  return maxima;
}

} // namespace

void check_junction_options(const EquilibratorOptions& options) {
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

JunctionEquilibrator::JunctionEquilibrator(const EquilibratorOptions& options, int threads)
    : options_(options), host_(threads), jacobi_(host_, options.junction) {
  check_junction_options(options);
}

EquilibriumReport JunctionEquilibrator::equilibrate(Foam& foam, double /*t1_length*/,
                                                    const AbortCheck& aborted) {
  const std::vector<Vec2> position = foam.position;
  const std::vector<double> pressure = foam.pressure;
  const FoamView mesh = view_of(foam);
  const bool jacobi = options_.junction.sweep == Sweep::Jacobi;
  if (jacobi) {
    jacobi_.prepare(mesh);
  }
  try {
    foam.report = junction::sweep_to_rest(host_, mesh, options_, aborted, [&] {
      return jacobi ? jacobi_.sweep(mesh) : sweep_gauss_seidel(foam, options_.junction);
    });
  } catch (const Aborted&) {
    foam.position = position;
    foam.pressure = pressure;
    throw;
  }
  return foam.report;
}

} // namespace foam
