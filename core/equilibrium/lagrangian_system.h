// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <limits>
#include <span>
#include <vector>

#include "equilibrium/factorisation.h"
#include "equilibrium/newton_matrix.h"
#include "equilibrium/rates.h"
#include "equilibrium/region.h"
#include "mesh/foam.h"

namespace foam {

/// A change of a region's unknowns, in the order of its lists.
struct Step {
  std::vector<Vec2> junctions;   ///< cm
  std::vector<double> angles;    ///< rad
  std::vector<double> pressures; ///< N/cm²
};

/// Largest dimensionless residuals of the equilibrium's equations in a region.
struct Residual {
  double force = 0;     ///< |Σ tensions|/T at a junction
  double curvature = 0; ///< |2 sin α − q·d/T| of a film
  double area = 0;      ///< |A − A^τ|/A^τ of a bubble
  double largest() const;
};

/// Newton's equations for the stationary point of the Lagrangian (film_lagrangian.h) in a region of
/// a foam, and their solution.
class LagrangianSystem {
public:
  /// Sets up the unknowns for a region of a foam. If it is the whole foam, as before, the
  /// factorisation at hand is kept, to be adapted before it serves.
  void set_up(const Foam& foam, Region region);
  /// Whether set_up() has been called for a region of this very topology.
  bool fits(const Foam& foam) const { return ready_ && topology_ == foam.topology; }
  const Region& region() const { return region_; }
  /// Forgets everything.
  void reset();

  /// Evaluates the gradient of the Lagrangian. What follows is for this state of the foam, or for
  /// that of set_up().
  Residual evaluate(const Foam& foam);
  /// The bubbles at which the dimensionless residuals of the last evaluate() exceed a limit.
  std::vector<Index> rough_bubbles(const Foam& foam, double limit) const;

  /// Assembles and factorises the matrix, shifted until its inertia is that of a minimum under the
  /// area constraints: as many negative pivots as constraints. \param surplus so many more are
  /// taken as well: where the foam is so close to a stationary point, be it a saddle, that Newton's
  /// own step leads there, or where some are known to mean nothing. \returns false if no shift does
  /// it.
  bool factorise(const Foam& foam, Index surplus);
  bool factorised() const { return factorised_; }
  /// Makes the last factorisation of a whole foam serve for where it has moved since. \returns
  /// false if that is too far.
  bool adapt(const Foam& foam);
  /// Whether the last factorisation needed a shift.
  bool shifted() const { return shift_ > 0; }

  /// Newton's step from the last evaluate() with the last factorise().
  const Step& newton_step(const Foam& foam);
  /// The same after adapt(), inexact: the factorisation preconditions an iteration until the step
  /// leaves a hundredth of the load or a limit of dimensionless residuals (R. S. Dembo, S. C.
  /// Eisenstat, T. Steihaug, SIAM J. Numer. Anal. 19 (1982) 400). \returns nothing if that takes
  /// too long.
  const Step* newton_step(const Foam& foam, double limit);

  /// How the equilibrium moves per unit of time while target areas change at the given rates
  /// (cm²/s, by bubble), to first order. The last factorise() serves, be it of another state: what
  /// it lacks is made up for by an iteration until the foam would leave its equilibrium no faster
  /// than at `drift` (1/s, of dimensionless residuals, areas in units of the mean).
  /// \param expected how what is held moves, and with what the iteration begins
  /// \returns nothing if that is not reached. kAnyDrift always is, by the last factorise() alone.
  const Step* response(const Foam& foam, const std::vector<double>& area_rate,
                       const Rates& expected, double drift);
  static constexpr double kAnyDrift = std::numeric_limits<double>::infinity();

  /// How a step changes the chord of a film, cm.
  Vec2 chord_change(const Foam& foam, Index film, const Step& step) const;

private:
  Vec2 displacement(Index junction, const Step& step) const;
  void renumber(const Foam& foam);
  bool assemble(const Foam& foam, double shift);
  std::vector<double> load() const;
  bool solve(const Foam& foam, std::span<double> change, std::vector<double>& rest, double limit);
  Residual units(const Foam& foam) const;
  double largest(const Foam& foam, std::span<const double> rest) const;
  void extract(const Foam& foam, std::span<double> change, std::span<const double> angle_gradient,
               const Rates& held, Step& step) const;
  void remove_rigid_motion(const Foam& foam, std::span<double> change) const;

  Region region_;
  std::uint64_t topology_ = 0;
  bool ready_ = false;
  bool assembled_ = false; ///< the matrix is that of the state last evaluated
  bool analysed_ = false;  ///< the symbolic factorisation is that of the matrix
  bool factorised_ = false;
  double shift_ = 0;
  double last_shift_ = 0;

  std::vector<char> keep_angle_; ///< by place in region_.films
  NewtonMatrix matrix_;
  Factorisation factorisation_;

  std::vector<double> gradient_;       ///< of the unknowns, not condensed
  std::vector<double> angle_gradient_; ///< by place in region_.films
  std::vector<double> segments_; ///< of films as seen from half-film 2f, cm²; of region_'s alone
  Step step_;
  Step response_;
};

} // namespace foam
