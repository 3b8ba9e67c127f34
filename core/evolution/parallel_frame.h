// SPDX-License-Identifier: GPL-3.0-or-later
//
// FrameCoarsening's frame with TopologicalAlgorithm::Bidding, and Sweep::Jacobi or Newton's method
// for its equilibrium, every step of it in parallel on a machine (parallel/host.h).
#pragma once

#include <cmath>
#include <utility>

#include "equilibrium/parallel_newton.h"
#include "evolution/collapse_bids.h"
#include "evolution/diffusion.h"
#include "evolution/thesis_rules.h"
#include "junction/jacobi_sweep.h"
#include "parallel/kernels.h"

namespace foam {
namespace detail {

/// Over all bubbles.
struct BubbleSums {
  double target_area = 0;
  double at_wall = 0; ///< how many touch the wall
  double rate = 0;    ///< dA^τ/dt
  Index bubbles = 0;

  friend FOAM_HOST_DEVICE BubbleSums operator+(const BubbleSums& a, const BubbleSums& b) {
    return {a.target_area + b.target_area, a.at_wall + b.at_wall, a.rate + b.rate,
            a.bubbles + b.bubbles};
  }
};

/// dA^τ/dt of a bubble (area_rates), cm²/s, but for the share of what a container's total is off.
struct AreaRate {
  FoamView mesh;
  double constant = 0;     ///< von Neumann's K, cm²/s
  double permeability = 0; ///< κ

  FOAM_HOST_DEVICE bool at_wall(Index bubble) const {
    return mesh.boundary == Boundary::Fixed && mesh.bubble_on_world(bubble);
  }

  FOAM_HOST_DEVICE double operator()(Index bubble) const {
    if (!at_wall(bubble)) {
      return constant * (mesh.sides[bubble] - 6);
    }
    double inflow = 0; // −κ·Σ l·Δp (thesis 2.4.1)
    for_each_half(mesh, bubble, [&](Index h) {
      if (!mesh.wall(h)) {
        inflow -= permeability * mesh.length(h) *
                  (mesh.pressure[bubble] - mesh.pressure_of(mesh.right(h)));
      }
    });
    return inflow;
  }
};

struct SumBubble {
  AreaRate rate;

  FOAM_HOST_DEVICE BubbleSums operator()(Index bubble) const {
    const FoamView& mesh = rate.mesh;
    if (!mesh.has_bubble(bubble)) {
      return {};
    }
    return {mesh.target_area[bubble], rate.at_wall(bubble) ? 1.0 : 0.0, rate(bubble), 1};
  }
};

/// A^τ ← A^τ + dA/dt·Δt (3.7.1).
struct Diffuse {
  AreaRate rate;
  double correction = 0; ///< of the rates at the wall, cm²/s
  double time_step = 0;  ///< s

  FOAM_HOST_DEVICE void operator()(Index bubble) const {
    if (rate.mesh.has_bubble(bubble)) {
      const double off = rate.at_wall(bubble) ? correction : 0;
      rate.mesh.target_area[bubble] += (rate(bubble) - off) * time_step;
    }
  }
};

struct IsGone {
  FoamView mesh;
  double t2_area = 0;

  FOAM_HOST_DEVICE bool operator()(Index bubble) const {
    return mesh.has_bubble(bubble) &&
           std::min(mesh.target_area[bubble], mesh.area(bubble)) <= t2_area;
  }
};

struct KeepAbove {
  double* target_area = nullptr;
  double least = 0;

  FOAM_HOST_DEVICE void operator()(Index bubble) const {
    target_area[bubble] = std::max(target_area[bubble], least);
  }
};

struct IsJunction {
  FoamView mesh;

  FOAM_HOST_DEVICE Index operator()(Index junction) const {
    return mesh.has_junction(junction) ? 1 : 0;
  }
};

} // namespace detail

/// What a frame has done.
struct FrameResult {
  bool performed = false; ///< not, if the foam cannot go on
  OperationCount operations;
  EquilibriumReport report;
};

template <class Machine> class ParallelFrame {
public:
  ParallelFrame(Machine& machine, const CoarseningOptions& options)
      : machine_(machine), options_(options), bidding_(machine),
        jacobi_(machine, options.equilibrator.junction), newton_(machine, options.equilibrator) {}

  /// Advances a mesh by one time step. Where it throws Aborted or has not performed the frame, the
  /// mesh is somewhere in between.
  FrameResult advance(const FoamView& mesh, const AbortCheck& aborted) {
    using namespace detail;
    const AreaRate rate{mesh, von_neumann_constant(mesh.surface_tension, options_.permeability),
                        options_.permeability};
    const BubbleSums sums =
        machine_.reduce(mesh.bubbles, BubbleSums{}, SumBubble{rate}, parallel::Add{});
    const Thresholds limit = thresholds_of(mesh, sums.target_area);
    const double mean_area = sums.target_area / sums.bubbles;

    const double correction = sums.at_wall > 0 ? sums.rate / sums.at_wall : 0;
    machine_.for_each(mesh.bubbles, Diffuse{rate, correction, options_.time_step});
    if (mesh.boundary == Boundary::Free && sums.bubbles == 2 &&
        machine_.reduce(mesh.bubbles, false, IsGone{mesh, limit.t2_area}, parallel::Or{})) {
      return {};
    }
    FrameResult result;
    result.performed = true;
    const ThesisRules rules{limit, options_.two_sided_bubbles};
    if (rules.two_sided == TwoSidedBubbles::Slide) {
      bidding_.run(mesh, SlideBids{rules, allowed(mesh.bubbles)});
    }
    result.operations = bidding_.run(mesh, CollapseBids{rules, allowed(mesh.films)});
    machine_.for_each(mesh.bubbles, KeepAbove{mesh.target_area, kLeastTarget * mean_area});

    if (options_.equilibrator.kind == EquilibratorKind::Newton) {
      const newton::NewtonResult found = newton_.equilibrate(mesh, limit.t1_length, aborted);
      result.report = found.report;
      result.operations.t1 += found.t1;
    } else {
      jacobi_.prepare(mesh);
      result.report = junction::sweep_to_rest(machine_, mesh, options_.equilibrator, aborted,
                                              [&] { return jacobi_.sweep(mesh); });
    }
    return result;
  }

private:
  Thresholds thresholds_of(const FoamView& mesh, double total_area) {
    const Index junctions =
        options_.thresholds.relative
            ? machine_.reduce(mesh.junctions, Index{0}, detail::IsJunction{mesh}, parallel::Add{})
            : 0;
    return thresholds(total_area, junctions, options_.thresholds);
  }

  /// Flags that are all set.
  std::uint8_t* allowed(Index size) {
    flags_.resize(FoamView::size(size));
    machine_.for_each(size, parallel::Fill<std::uint8_t>{flags_.data(), 1});
    return flags_.data();
  }

  Machine& machine_;
  CoarseningOptions options_;
  Bidding<Machine> bidding_;
  junction::JacobiSweep<Machine> jacobi_;
  newton::ParallelNewton<Machine> newton_;
  typename Machine::template Array<std::uint8_t> flags_;
};

} // namespace foam
