// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton's method for a whole foam on an executor (parallel/host.h), every step of it in parallel.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "equilibrium/krylov_solver.h"
#include "equilibrium/newton.h"
#include "equilibrium/options.h"
#include "equilibrium/swaps.h"
#include "physics/equilibrium_measures.h"
#include "topology/operations.h"

namespace foam::newton {

/// What an equilibration did.
struct NewtonResult {
  EquilibriumReport report;
  std::vector<TopologicalOperation> swaps;
  int inner_iterations = 0; ///< of MINRES, all in all
};

/// Notes in a foam what has been done to its arrays.
inline void note(Foam& foam, const NewtonResult& result) {
  note_performed(foam, result.swaps);
  foam.report = result.report;
}

template <class Executor> class WholeFoamNewton {
public:
  /// \param direct see KrylovSolver.
  WholeFoamNewton(Executor& executor, const EquilibratorOptions& options,
                  std::unique_ptr<DirectSolver> direct = nullptr)
      : executor_(executor), options_(options), newton_(executor),
        solver_(executor, std::move(direct)), swaps_(executor) {}

  /// Brings a mesh to equilibrium, swapping films shorter than t1_length (cm) that are pulled shut.
  /// Where it throws Aborted the mesh is somewhere in between.
  NewtonResult equilibrate(const FoamView& mesh, double t1_length, const AbortCheck& aborted) {
    return equilibrate(mesh, t1_length, options_.maximum_iterations, aborted);
  }
  /// The same in so many iterations at most.
  NewtonResult equilibrate(const FoamView& mesh, double t1_length, int most_iterations,
                           const AbortCheck& aborted) {
    Problem problem(executor_, mesh, swaps_, t1_length);
    int iterations = 0;
    const int before = solver_.iterations();
    const Outcome outcome =
        newton_.relax(problem, solver_, options_.tolerance, iterations, most_iterations, aborted);
    const EquilibriumMeasures measures = measure_equilibrium(executor_, const_view(mesh));
    return {.report = {.converged = outcome.converged,
                       .iterations = iterations,
                       .max_angle_error = measures.angle_error,
                       .max_area_error = measures.area_error,
                       .residual = outcome.residual.largest()},
            .swaps = swaps_.take_performed(),
            .inner_iterations = solver_.iterations() - before};
  }

  /// Whether a mesh is so far from equilibrium that some film is in the way of Newton's first step:
  /// relax_compressible() then brings it nearer.
  bool is_far(const FoamView& mesh) {
    Problem problem(executor_, mesh, swaps_, 0);
    return newton_.is_far(problem, solver_);
  }

private:
  /// All of a mesh (equilibrium/newton.h).
  class Problem {
  public:
    Problem(Executor& executor, const FoamView& mesh, SwapsAtOnce<Executor>& swaps,
            double t1_length)
        : mesh_(mesh),
          domain_(whole_mesh(const_view(mesh), mean_spacing(executor, const_view(mesh),
                                                            Elements(mesh.bubble_slots())))),
          swaps_(swaps), t1_length_(t1_length) {
      swaps_.begin(mesh_);
    }

    const FoamView& mesh() const { return mesh_; }
    const FoamView& foam() const { return mesh_; }
    const Domain& domain() const { return domain_; }
    static bool renew() { return false; }
    void mark_closing(const StepView& step) { swaps_.mark(mesh_, step, t1_length_); }
    std::int64_t swap_closing() { return swaps_.perform(mesh_); }

  private:
    FoamView mesh_;
    Domain domain_;
    SwapsAtOnce<Executor>& swaps_;
    double t1_length_;
  };

  Executor& executor_;
  EquilibratorOptions options_;
  Newton<Executor> newton_;
  KrylovSolver<Executor> solver_;
  SwapsAtOnce<Executor> swaps_;
};

} // namespace foam::newton
