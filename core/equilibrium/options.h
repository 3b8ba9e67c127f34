// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

namespace foam {

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
  double damping = 0.1;                            ///< τ, in (0, 1]
  double finite_difference_step = 0.01;            ///< h, > 0
  double jacobian_tolerance = 1;                   ///< δ_error, > 0
  double pressure_tolerance = 0.001;               ///< δ_Δp, N/cm², > 0
  double position_tolerance = 0.001;               ///< δ_Δx, cm, > 0
  double minimum_scale = 1e-5;                     ///< δ_scale, in (0, 1)

  friend bool operator==(const JunctionOptions&, const JunctionOptions&) = default;
};

struct EquilibratorOptions {
  EquilibratorKind kind = EquilibratorKind::Newton;
  Device device = Device::Auto;
  /// Newton: largest dimensionless residual of an equilibrium, > 0; below newton::kRounding also
  /// one that rounding lets get no smaller.
  double tolerance = 1e-9;
  int maximum_iterations = 256; ///< > 0
  /// Direct only for Newton with Device::CUDA, in a build with cuDSS.
  LinearSolver linear_solver = LinearSolver::Iterative;
  JunctionOptions junction;

  friend bool operator==(const EquilibratorOptions&, const EquilibratorOptions&) = default;
};

/// \throws FoamError for options out of range.
void check(const EquilibratorOptions& options);

} // namespace foam
