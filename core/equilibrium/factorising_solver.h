// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <span>
#include <vector>

#include "equilibrium/domain.h"
#include "equilibrium/evaluation.h"
#include "equilibrium/newton_matrix.h"
#include "equilibrium/reused_factorisation.h"
#include "geometry/tensor.h"
#include "parallel/host.h"
#include "physics/rates.h"

namespace foam::newton {

/// Solves Newton's equations in a region of a foam (equilibrium/newton.h) by a factorisation of
/// their matrix, which goes on serving as long as it can.
///
/// The matrix is shifted until its inertia is that of a minimum under the area constraints: as many
/// negative pivots as constraints. Close to the solution an old factorisation preconditions an
/// iteration in place of a new one.
class FactorisingSolver {
public:
  /// Sets up the unknowns for a region of a foam. If it is the whole foam, as before, the
  /// factorisation at hand is kept, to be adapted before it serves.
  void set_up(const Foam& foam, Region region);
  /// Whether set_up() has been called for a region of this very topology.
  bool fits(const Foam& foam) const { return topology_ == foam.topology; }
  bool factorised() const { return factorised_; }
  const Region& region() const { return region_; }
  /// Forgets everything.
  void reset();

  // What the loop asks for (equilibrium/newton.h).
  void begin(bool far);
  const StepView* reuse(const Foam& foam, const Domain& domain, const Evaluation<Host>& state,
                        const Residual& residual, double tolerance);
  const StepView* find(const Foam& foam, const Domain& domain, const Evaluation<Host>& state,
                       const Residual& residual);
  /// The inertia is right already.
  static bool convexify() { return false; }
  static void took(double /*fraction*/) {}

  /// How the equilibrium moves per unit of time while target areas change at the given rates
  /// (cm²/s, by bubble), to first order. The factorisation at hand serves, be it of another state:
  /// what it lacks is made up for by an iteration until the foam would leave its equilibrium no
  /// faster than at `drift` (1/s, of dimensionless residuals, areas in units of the mean); where
  /// that takes too long, the present matrix is factorised and its solution taken as it is.
  /// \param expected how what is held moves, and with what the iteration begins
  /// \param flow velocity gradient, without a trace, 1/s, with which a torus is strained meanwhile:
  /// the rates of junctions are then those beside what it moves them by
  /// \returns nothing if the foam has no definite response.
  const StepView* response(const Foam& foam, const Field<Bubble, double>& area_rate,
                           const Rates& expected, double drift, const Tensor& flow = {});

private:
  bool assemble(const Foam& foam, double shift);
  bool factorise(const Foam& foam, Index surplus);
  bool adapt(const Foam& foam);
  std::vector<double> angle_gradient(const Evaluation<Host>& state) const;
  std::vector<double> load(const Foam& foam, const Evaluation<Host>& state) const;
  bool solve(const Foam& foam, std::span<double> change, std::vector<double>& rest, double limit);
  const StepView* respond(const Foam& foam, const Field<Bubble, double>& area_rate,
                          const Rates& expected, double drift, const Tensor& flow);
  void add_strain(const Foam& foam, const Tensor& flow, std::span<double> load,
                  std::span<double> angle_load) const;
  std::vector<double> weights(const Foam& foam) const;
  void extract(const Foam& foam, std::span<double> change, std::span<const double> angle_gradient,
               const Rates& held, Step<Host>& step);

  static constexpr double kAnyDrift = std::numeric_limits<double>::infinity();

  Host host_;
  Region region_;
  std::optional<std::uint64_t> topology_; ///< of the foam; none before set_up()
  bool assembled_ = false;                ///< the matrix is that of the state at hand, not shifted
  bool factorised_ = false; ///< the factorisation is one of a matrix with the right inertia
  bool adapted_ = false;    ///< it has been adapted since the equilibration began, or is new
  double shift_ = 0;        ///< of the last one

  NewtonMatrix matrix_;
  ReusedFactorisation factorisation_;
  Step<Host> step_, response_;
  StepView view_;
};

} // namespace foam::newton
