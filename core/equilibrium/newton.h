// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton's method for the stationary point of the Lagrangian (physics/film_lagrangian.h): one loop,
// whoever holds the foam and however its linear equations are solved.
//
// Steps are globalised by energy: each is a direction for the exact penalty function T·Σl + μ·Σ|A −
// A^τ| with μ above the largest pressure (J. Nocedal, S. J. Wright, Numerical Optimization, 2nd
// ed., 2006, ch. 18); no film shrinks or turns by more than half of its length in one step, no arc
// by more than half a radian. Films that are short and pulled shut are swapped on the way.
//
// A problem has
//   mesh(), domain()      what is relaxed, and what of it may change,
//   foam()                the same mesh as its solver wants it,
//   renew()               makes the domain anew if the topology has changed; whether it has,
//   mark_closing(step)    notes the films that a step closes, and
//   swap_closing()        swaps those of them that may be: how many.
//
// A solver has
//   begin(far)            that an equilibration begins, be it far from equilibrium,
//   reuse(foam, domain, state, residual, tolerance)
//                         a step from what is left of an earlier one; null if there is nothing,
//   find(foam, domain, state, residual)
//                         Newton's step; null if there is none,
//   convexify()           makes the next step more of a descent, after one that led nowhere:
//                         whether it can, and
//   took(fraction)        that so much of a step was taken.
#pragma once

#include <cmath>
#include <limits>

#include "base/abort.h"
#include "equilibrium/evaluation.h"
#include "equilibrium/zero_modes.h"

namespace foam::newton {

inline constexpr double kFar = 0.5;          // residual that Newton's method may not be up to
inline constexpr double kShortStart = 0.25;  // part of its first step that can be taken then
inline constexpr double kContraction = 0.25; // what a reused step must achieve
inline constexpr double kClose = 1e-6;       // residual from which on no progress is the end …
inline constexpr int kLongestStall = 24;     // … after so many iterations
inline constexpr double kRounding = 1e-11;   // residual that rounding of coordinates may leave
inline constexpr double kSmallestFraction = 1e-4; // of a line search

/// Whether iterations get on.
class Progress {
public:
  bool stalled(double residual) {
    since_best_ = residual < 0.5 * best_ ? 0 : since_best_ + 1;
    best_ = std::min(best_, residual);
    return !std::isfinite(residual) || (best_ < kClose && since_best_ > kLongestStall);
  }
  /// Whether they are as near as rounding lets them come, whatever the tolerance: a step of
  /// Newton's from so near would square the residual.
  bool at_rounding() const { return best_ < kRounding && since_best_ > 0; }

private:
  double best_ = std::numeric_limits<double>::infinity();
  int since_best_ = 0;
};

struct Outcome {
  bool converged = false;
  Residual residual;
};

/// On an executor (parallel/host.h).
template <class Executor> class Newton {
public:
  explicit Newton(Executor& executor) : executor_(executor) {}

  /// Brings a problem to equilibrium, to a tolerance of dimensionless residuals.
  /// \param iterations counts on from what it is, up to the most. \throws Aborted, with the mesh
  /// somewhere in between
  template <class Problem, class Solver>
  Outcome relax(Problem& problem, Solver& solver, double tolerance, int& iterations, int most,
                const AbortCheck& aborted) {
    Progress progress;
    Residual residual;
    bool evaluated = false;
    bool begun = false;
    while (true) {
      if (aborted && aborted()) {
        throw Aborted();
      }
      if (problem.renew() || !evaluated) {
        if (!begun) {
          remove_gained_pressure(problem);
        }
        residual = evaluate(problem);
        evaluated = true;
      }
      if (!begun) {
        solver.begin(residual.largest() > kFar);
        begun = true;
      }
      if (residual.largest() < tolerance) {
        return {true, residual};
      }
      if (progress.stalled(residual.largest()) || iterations >= most) {
        return {false, residual};
      }
      if (progress.at_rounding()) {
        return {true, residual};
      }
      ++iterations;
      if (reuse(problem, solver, tolerance, residual)) {
        continue;
      }
      const StepView* const step = solver.find(problem.foam(), problem.domain(), state_, residual);
      if (step == nullptr) {
        return {false, residual};
      }
      problem.mark_closing(*step);
      const double taken = search_line(problem, *step, residual);
      const bool swapped = problem.swap_closing() > 0;
      evaluated = taken > 0 && !swapped;
      if (taken > 0 || swapped) {
        solver.took(taken);
      } else if (!solver.convexify()) {
        return {false, residual};
      }
    }
  }

  /// Whether a problem is so far from equilibrium that some film is in the way of the first step.
  template <class Problem, class Solver> bool is_far(Problem& problem, Solver& solver) {
    problem.renew();
    const Residual residual = evaluate(problem);
    if (!(residual.largest() > kFar)) {
      return false;
    }
    solver.begin(false);
    const StepView* const step = solver.find(problem.foam(), problem.domain(), state_, residual);
    return step != nullptr && longest_step_of(problem, *step) < kShortStart;
  }

  template <class Problem> Residual evaluate(const Problem& problem) {
    return state_.evaluate(executor_, const_view(problem.mesh()), problem.domain());
  }
  /// The state that was evaluated last.
  const Evaluation<Executor>& state() const { return state_; }

private:
  /// Steps leave the mean pressure as it is, but bubbles that vanish take theirs with them, and
  /// what is left can come to outweigh the differences, which alone count.
  template <class Problem> void remove_gained_pressure(const Problem& problem) {
    const Domain& domain = problem.domain();
    if (domain.whole) {
      const FoamView& mesh = problem.mesh();
      remove_common_pressure(executor_, const_view(mesh), domain.bubbles, mesh.pressure);
    }
  }

  template <class Problem> double longest_step_of(const Problem& problem, const StepView& step) {
    return longest_step(executor_, const_view(problem.mesh()), problem.domain(), step);
  }

  /// One step of a solver's from before, undone unless it contracts.
  template <class Problem, class Solver>
  bool reuse(Problem& problem, Solver& solver, double tolerance, Residual& residual) {
    const StepView* const step =
        solver.reuse(problem.foam(), problem.domain(), state_, residual, tolerance);
    if (step == nullptr || longest_step_of(problem, *step) < 1) {
      return false;
    }
    remember(problem);
    walk(executor_, problem.mesh(), problem.domain(), before_.view(), *step, 1);
    const Residual after = evaluate(problem);
    if (after.largest() < kContraction * residual.largest() || after.largest() < tolerance) {
      residual = after;
      return true;
    }
    restore(executor_, problem.mesh(), problem.domain(), before_.view());
    residual = evaluate(problem);
    return false;
  }

  /// Takes the step, or as much of it everywhere as can be taken there, or backtracks along it,
  /// until the residual is halved or the merit function falls. \returns the fraction taken; 0, with
  /// the mesh as it was, if there is none.
  template <class Problem>
  double search_line(Problem& problem, const StepView& step, Residual& residual) {
    const FoamView& mesh = problem.mesh();
    const Domain& domain = problem.domain();
    Merit<Executor> merit{executor_, const_view(mesh), domain};
    merit.weigh(state_, step);
    const double before = merit(state_);
    remember(problem);
    const auto improves = [&](const StepView& direction, double fraction) {
      walk(executor_, mesh, domain, before_.view(), direction, fraction);
      const Residual after = evaluate(problem);
      if (after.largest() < 0.5 * residual.largest() || merit(state_) < before) {
        residual = after;
        return true;
      }
      return false;
    };
    const double longest = longest_step_of(problem, step);
    if (longest < 1 && domain.whole) {
      limited_.fit(const_view(mesh));
      limit_step(executor_, const_view(mesh), domain, step, limited_.view());
      if (improves(limited_.view(), 1)) {
        return longest;
      }
      restore(executor_, mesh, domain, before_.view());
    }
    for (double fraction = longest; fraction > kSmallestFraction * longest; fraction *= 0.5) {
      if (improves(step, fraction)) {
        return fraction;
      }
    }
    restore(executor_, mesh, domain, before_.view());
    return 0;
  }

  template <class Problem> void remember(const Problem& problem) {
    before_.fit(const_view(problem.mesh()));
    save(executor_, problem.mesh(), problem.domain(), before_.view());
  }

  Executor& executor_;
  Evaluation<Executor> state_;
  Step<Executor> before_, limited_;
};

} // namespace foam::newton
