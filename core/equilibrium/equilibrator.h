// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>
#include <memory>

#include "mesh/foam.h"

namespace foam {

/// Thrown out of long work when its abort check says so.
class Aborted : public std::runtime_error {
public:
  Aborted() : std::runtime_error("aborted") {}
};

/// Asked often during long work; true ends it with Aborted.
using AbortCheck = std::function<bool()>;

enum class EquilibratorKind {
  Newton,  ///< all junctions, arcs and pressures at once, to machine precision
  Junction ///< the thesis's own method, junction by junction
};

enum class Device { Auto, CPU, CUDA };

/// How Newton's systems are solved on a device.
enum class LinearSolver {
  Iterative, ///< MINRES, with a preconditioner that does not feel the foam's size
  Direct     ///< a sparse factorisation, where the build has one for the device
};

enum class Sweep { Jacobi, GaussSeidel };

/// What a junction's films shall meet besides its bubbles' areas.
enum class RootSearch {
  Angles,  ///< 120° between them (thesis 3.1)
  Energies ///< target energies (thesis 7.1.1)
};

/// E^τ, the target energies of a junction's films: the thesis's two suggestions (7.1.1).
enum class EnergyTarget {
  Zero,    ///< 0, the global minimum
  Straight ///< those of straight films from where their sum is least, the local minimum
};

/// Constants of the thesis's method; defaults of its Figure 4.19.
struct JunctionOptions {
  Sweep sweep = Sweep::Jacobi;
  RootSearch root_search = RootSearch::Angles;
  EnergyTarget energy_target = EnergyTarget::Zero; ///< of RootSearch::Energies
  bool energy_decay = true;                        ///< Energy Decay Constraint (3.5.2)
  bool orientation_invariant = false;              ///< Orientation Invariant Constraint (3.5.1)
  double damping = 0.1;                            ///< τ
  double finite_difference_step = 0.01;            ///< h
  double jacobian_tolerance = 1;                   ///< δ_error
  double pressure_tolerance = 0.001;               ///< δ_Δp, N/cm²
  double position_tolerance = 0.001;               ///< δ_Δx, cm
  double minimum_scale = 1e-5;                     ///< δ_scale
};

struct EquilibratorOptions {
  EquilibratorKind kind = EquilibratorKind::Newton;
  Device device = Device::Auto;
  double tolerance = 1e-9;      ///< Newton: largest dimensionless residual of an equilibrium, > 0
  int maximum_iterations = 256; ///< > 0
  /// Direct only for Newton with Device::CUDA, in a build with cuDSS.
  LinearSolver linear_solver = LinearSolver::Iterative;
  JunctionOptions junction;
};

/// Finds a foam's equilibrium.
class Equilibrator {
public:
  Equilibrator() = default;
  Equilibrator(const Equilibrator&) = delete;
  Equilibrator& operator=(const Equilibrator&) = delete;
  virtual ~Equilibrator() = default;

  /// Brings the foam to equilibrium. A method that swaps films on the way (T1) swaps those that are
  /// shorter than t1_length (cm) and pulled shut.
  /// \returns what was reached, which is also left in foam.report: a foam that did not reach
  /// equilibrium is not `converged`.
  /// \throws Aborted, with the foam as it was or on its way, and foam.report accordingly
  virtual EquilibriumReport equilibrate(Foam& foam, double t1_length,
                                        const AbortCheck& aborted) = 0;

  /// Drops all that is kept from earlier calls, so that the next result depends on the foam alone.
  virtual void forget() = 0;
};

/// \throws FoamError for options out of range that any equilibrator has.
void check_options(const EquilibratorOptions& options);

/// \throws FoamError for options out of range, or a device that is not there.
std::unique_ptr<Equilibrator> make_equilibrator(const EquilibratorOptions& options);

/// Largest deviation from 120° at junctions that may move (rad).
double max_angle_error(const Foam& foam);

/// Largest |A − A^τ|/A^τ.
double max_area_error(const Foam& foam);

} // namespace foam
