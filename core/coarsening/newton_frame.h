// SPDX-License-Identifier: GPL-3.0-or-later
//
// A frame of coarsening in which Newton's method finds the equilibria, every step of it in parallel
// on an executor (parallel/host.h).
//
// The frame goes in equal steps, so short that no bubble above the thresholds loses more than half
// of its gas in one, but in no more than kMostSteps. In a step those bubbles give way whose end has
// come (NewtonRules), gas diffuses, and the foam finds its equilibrium. A bubble that would have to
// give way and cannot, because a neighbour has two sides, say, keeps its gas until it can; in a
// closed container what it does not give is taken from all others in proportion to their gas. So
// gas is conserved, and none is made.
#pragma once

#include <algorithm>
#include <cmath>
#include <functional>
#include <memory>
#include <utility>

#include "coarsening/frame_result.h"
#include "coarsening/newton_rules.h"
#include "coarsening/options.h"
#include "equilibrium/whole_foam_newton.h"
#include "parallel/flags.h"
#include "topology/collapse_operations.h"

namespace foam {
namespace detail {

/// dA^τ/dt, cm²/s, but for bubbles that would lose more gas than they can.
struct AdmissibleRate {
  NewtonRules rules;

  FOAM_HOST_DEVICE double operator()(Bubble bubble) const {
    return admissible(bubble) ? rules.rate(bubble) : 0;
  }
  FOAM_HOST_DEVICE bool takes_a_share(Bubble bubble) const {
    return admissible(bubble) &&
           (mesh().surroundings.periodic() || rules.rate.takes_a_share(bubble));
  }

private:
  FOAM_HOST_DEVICE const ConstFoamView& mesh() const { return rules.rate.mesh; }
  FOAM_HOST_DEVICE bool admissible(Bubble bubble) const {
    return mesh().target_area[bubble] >= rules.needed(bubble);
  }
};

/// In how many steps the bubble can go through the time step of the rules.
struct StepsOf {
  NewtonRules rules;

  FOAM_HOST_DEVICE double operator()(Bubble bubble) const {
    const ConstFoamView& mesh = rules.rate.mesh;
    return mesh.has_bubble(bubble) ? rules.needed(bubble) / std::max(mesh.target_area[bubble],
                                                                     rules.end_area(mesh, bubble))
                                   : 0;
  }
};

struct AreaOf {
  ConstFoamView mesh;

  FOAM_HOST_DEVICE double operator()(Bubble bubble) const {
    return mesh.has_bubble(bubble) ? mesh.target_area[bubble] : 0;
  }
};

struct Vanishes {
  NewtonRules rules;

  FOAM_HOST_DEVICE bool operator()(Bubble bubble) const {
    const ConstFoamView& mesh = rules.rate.mesh;
    return mesh.has_bubble(bubble) && rules.vanishes(mesh, bubble);
  }
};

} // namespace detail

template <class Executor> class NewtonFrame {
public:
  /// \param direct see newton::KrylovSolver.
  NewtonFrame(Executor& executor, const CoarseningOptions& options,
              std::unique_ptr<DirectSolver> direct = nullptr)
      : executor_(executor), options_(options), reservations_(executor),
        newton_(executor, options.equilibrator, std::move(direct)), allowed_(executor) {}

  /// Another way to an equilibrium of the mesh, with T1s of films shorter than this (cm).
  using Equilibrate = std::function<newton::NewtonResult(double t1_length)>;

  /// Advances a mesh by one time step. Where no equilibrium is found it is done once more with
  /// care: in four times as many steps, and with T1s of films up to a tenth of the bubbles'
  /// spacing. \param begin called as begin(), gives the mesh as it was before the frame. Where the
  /// frame throws Aborted or is not performed, the mesh is somewhere in between. \param in_need
  /// finds the equilibria then, if there is one
  template <class Begin>
  FrameResult advance(const Begin& begin, const AbortCheck& aborted,
                      const Equilibrate& in_need = {}) {
    const auto on_its_own = [&](const FoamView& mesh) -> Equilibrate {
      return [&, mesh](double t1_length) { return newton_.equilibrate(mesh, t1_length, aborted); };
    };
    FoamView mesh = begin();
    FrameResult result = try_to_advance(mesh, false, on_its_own(mesh));
    if (result.performed() && result.report.converged) {
      return result;
    }
    mesh = begin();
    return try_to_advance(mesh, true, in_need ? in_need : on_its_own(mesh));
  }

  /// The thresholds in force for a mesh.
  Thresholds limits(const FoamView& mesh) {
    const AreaRate rate = area_rate(const_view(mesh), options_.permeability);
    return limits(mesh, sum_bubbles(executor_, rate.mesh, rate));
  }

private:
  static constexpr double kMostSteps = 16;
  static constexpr double kFallbackSteps = 4; // times as many steps
  static constexpr double kFallbackT1 = 0.1;  // of the mean spacing

  FrameResult try_to_advance(const FoamView& mesh, bool fallback, const Equilibrate& equilibrate) {
    FrameResult result;
    NewtonRules rules = rules_of(mesh, fallback, result);
    const double needed =
        executor_.reduce(mesh.bubble_slots(), 0.0, detail::StepsOf{rules}, parallel::Larger{});
    const double steps =
        (fallback ? kFallbackSteps : 1) * std::clamp(std::ceil(needed), 1.0, kMostSteps);
    rules.time_step /= steps;
    for (int step = 0; step < steps && result.performed(); ++step) {
      take_step(mesh, rules, step * rules.time_step, equilibrate, result);
    }
    if (result.performed()) {
      result.limit = limits(mesh);
    }
    return result;
  }

  Thresholds limits(const FoamView& mesh, const BubbleSums& sums) {
    return newton_thresholds(
        thresholds(executor_, mesh, sums.target_area, sums.bubbles, options_.thresholds),
        std::sqrt(sums.mean_area()));
  }

  /// \param result for the thresholds in force, which a fallback goes beyond, and the end where
  /// they leave nothing.
  NewtonRules rules_of(const FoamView& mesh, bool fallback, FrameResult& result) {
    const AreaRate rate = area_rate(const_view(mesh), options_.permeability);
    const BubbleSums sums = sum_bubbles(executor_, rate.mesh, rate);
    const double spacing = std::sqrt(sums.mean_area());
    Thresholds limit = limits(mesh, sums);
    result.limit = limit;
    const double largest =
        executor_.reduce(mesh.bubble_slots(), 0.0, detail::AreaOf{rate.mesh}, parallel::Larger{});
    if (sums.bubbles > 2 && largest <= limit.t2_area) {
      result.end = Obstacle{End::Cause::AllVanish};
    }
    limit.t1_length = std::max(limit.t1_length, fallback ? kFallbackT1 * spacing : 0);
    return {.limit = limit,
            .two_sided = {options_.two_sided_bubbles, limit.t1_length},
            .many_sided_area = std::max(limit.t2_area, kManySidedArea * sums.mean_area()),
            .rate = rate,
            .time_step = options_.time_step};
  }

  /// \param begin from the frame's on, s
  void take_step(const FoamView& mesh, NewtonRules rules, double begin,
                 const Equilibrate& equilibrate, FrameResult& result) {
    if (rules.two_sided.fate == TwoSidedBubbles::Slide) {
      reservations_.run(mesh,
                        SlideOperations{rules.two_sided, allowed_.all_set(mesh.bubble_slots())});
    }
    const FieldView<Film, std::uint8_t> swappable = allowed_.all_set(mesh.film_slots());
    rules.swappable = ConstFieldView<Film, std::uint8_t>(swappable.data());
    reservations_.run(mesh, CollapseOperations<NewtonRules>{rules, swappable});
    result.add(reservations_.take_performed(), begin);

    const detail::AdmissibleRate rate{rules};
    const BubbleSums sums = sum_bubbles(executor_, rules.rate.mesh, rate);
    if (!mesh.surroundings.has_images() && sums.bubbles == 2 &&
        executor_.reduce(mesh.bubble_slots(), false, detail::Vanishes{rules}, parallel::Or{})) {
      result.end = Obstacle{End::Cause::LastTwo};
      return;
    }
    diffuse(executor_, mesh, rate, sums, rules.time_step);

    const newton::NewtonResult found = equilibrate(rules.limit.t1_length);
    const int iterations = result.report.iterations + found.report.iterations;
    result.report = found.report;
    result.report.iterations = iterations;
    result.add(found.swaps, begin + rules.time_step);
    if (!(found.report.residual < kNearlyConverged) ||
        !measure_equilibrium(executor_, const_view(mesh)).possible) {
      result.end = Obstacle{End::Cause::NoEquilibrium};
    }
  }

  Executor& executor_;
  CoarseningOptions options_;
  Reservations<Executor> reservations_;
  newton::WholeFoamNewton<Executor> newton_;
  parallel::Flags<Executor> allowed_;
};

} // namespace foam
