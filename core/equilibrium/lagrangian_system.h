// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <limits>
#include <memory>
#include <span>
#include <vector>

#include "equilibrium/region.h"
#include "equilibrium/sparse_solver.h"
#include "mesh/foam.h"

namespace foam {

/// A change of a region's unknowns, in the order of its lists.
struct Step {
  std::vector<Vec2> junctions;   ///< cm
  std::vector<double> angles;    ///< rad
  std::vector<double> pressures; ///< N/cm
};

/// Largest dimensionless residuals of the equilibrium's equations in a region.
struct Residual {
  double force = 0;     ///< |Σ tensions|/T at a junction
  double curvature = 0; ///< |2 sin α − q·d/T| of a film
  double area = 0;      ///< |A − A^τ|/A^τ of a bubble
  double largest() const;
};

/// Newton's equations for the stationary point of the Lagrangian (film_lagrangian.h) in a region of
/// a foam: the KKT matrix, sparse, symmetric and indefinite, and its factorisation.
///
/// The half-angle of a film is eliminated where ∂²φ/∂α² is safely positive, and kept as an unknown
/// where it is not: arcs around and beyond 90°, as at the free boundary. Foams have directions in
/// which they move at no cost (translations, rotations, the common pressure of a torus, a two-sided
/// bubble along its film): a regularisation too small to be felt elsewhere holds them.
class LagrangianSystem {
public:
  LagrangianSystem();

  /// Sets up the unknowns for a region of a foam.
  void set_up(const Foam& foam, Region region);
  /// Whether set_up() has been called for a region of this very topology.
  bool fits(const Foam& foam) const { return ready_ && topology_ == foam.topology; }
  const Region& region() const { return region_; }
  /// Forgets everything.
  void reset();

  /// Evaluates the gradient of the Lagrangian.
  Residual evaluate(const Foam& foam);

  /// Assembles and factorises the matrix, shifted until its inertia is that of a minimum under the
  /// area constraints: as many negative pivots as constraints. \param surplus so many more are
  /// taken as well: where the foam is so close to a stationary point, be it a saddle, that Newton's
  /// own step leads there, or where some are known to mean nothing. \returns false if no shift does
  /// it.
  bool factorise(const Foam& foam, Index surplus);
  bool factorised() const { return factorised_; }
  /// Whether the last factorisation needed a shift.
  bool shifted() const { return shift_ > 0; }

  /// Newton's step from the last evaluate() with the last factorise().
  const Step& newton_step(const Foam& foam);

  /// How the equilibrium moves per unit of time while target areas change at the given rates
  /// (cm²/s, by bubble), to first order. The last factorise() serves, be it of another state of the
  /// same topology: what it lacks is made up for by iterative refinement, which begins with the
  /// last response, so that the result is that of the present state to the given accuracy (relative
  /// size of the last correction). \returns nothing if that is not reached; kAnyAccuracy always is.
  const Step* response(const Foam& foam, const std::vector<double>& area_rate, double accuracy);
  static constexpr double kAnyAccuracy = std::numeric_limits<double>::infinity();

  /// How a step changes the chord of a film, cm.
  Vec2 chord_change(const Foam& foam, Index film, const Step& step) const;

private:
  struct FilmUnknowns {
    std::array<Index, 7> unknown{}; ///< numbers of the local unknowns, kNone where held
    std::array<Index, 28> slot{};   ///< of the local lower triangle in the matrix
  };

  Vec2 displacement(Index junction, const Step& step) const;
  void renumber(const Foam& foam);
  void number_unknowns(const Foam& foam);
  void build_pattern();
  bool assemble(const Foam& foam, double shift);
  void subtract_product(std::span<const double> x, std::span<double> from) const;
  void extract(const Foam& foam, Step& step);
  void remove_rigid_motion(const Foam& foam, std::span<double> change) const;
  double pressure_jump(const Foam& foam, Index film) const;

  Region region_;
  std::uint64_t topology_ = 0;
  bool ready_ = false;
  bool analysed_ = false; ///< the symbolic factorisation is that of the pattern
  bool factorised_ = false;
  double shift_ = 0;
  double last_shift_ = 0;

  Index unknowns_ = 0;
  Index pressure_start_ = 0;
  std::vector<Index> junction_unknown_; ///< by junction
  std::vector<Index> bubble_unknown_;   ///< by bubble
  std::vector<char> keep_angle_;        ///< by place in region_.films
  std::vector<FilmUnknowns> films_;
  std::vector<Index> diagonal_;
  SymmetricPattern pattern_;
  std::unique_ptr<SparseSolver> solver_;

  std::vector<double> values_;
  std::vector<double> gradient_;       ///< of the unknowns, not condensed
  std::vector<double> angle_gradient_; ///< by place in region_.films
  std::vector<double> rhs_;
  struct Condensed {
    std::array<double, 6> coupling{};
    double pivot = 1;
  };
  std::vector<Condensed> condensed_; ///< what eliminate_angle() needs again to find α
  Step step_;
  Step response_;
  std::vector<double> last_response_; ///< of the unknowns; empty if there was none
};

} // namespace foam
