// SPDX-License-Identifier: GPL-3.0-or-later
//
// FrameCoarsening's frame with TopologicalAlgorithm::Simultaneous and Sweep::Jacobi, every step of
// it in parallel on a machine (parallel/host.h).
#pragma once

#include "coarsening/frame_result.h"
#include "coarsening/options.h"
#include "parallel/flags.h"
#include "parallel/kernels.h"
#include "physics/gas.h"
#include "thesis/jacobi_sweep.h"
#include "thesis/one_tension.h"
#include "thesis/rules.h"
#include "topology/collapse_bids.h"

namespace foam {
namespace thesis::detail {

struct IsGone {
  ConstFoamView mesh;
  double t2_area = 0;

  FOAM_HOST_DEVICE bool operator()(Bubble bubble) const {
    return mesh.has_bubble(bubble) &&
           std::min(mesh.target_area[bubble], mesh.area(bubble)) <= t2_area;
  }
};

struct KeepAbove {
  FieldView<Bubble, double> target_area;
  double least = 0;

  FOAM_HOST_DEVICE void operator()(Bubble bubble) const {
    target_area[bubble] = std::max(target_area[bubble], least);
  }
};

} // namespace thesis::detail

template <class Machine> class ParallelFrame {
public:
  ParallelFrame(Machine& machine, const CoarseningOptions& options)
      : machine_(machine), options_(options), bidding_(machine),
        jacobi_(machine, options.equilibrator.junction), allowed_(machine) {}

  /// Advances a mesh by one time step.
  /// \param begin called as begin(), gives the mesh as it was before the frame. Where the frame
  /// throws Aborted or is not performed, the mesh is somewhere in between.
  template <class Begin> FrameResult advance(const Begin& begin, const AbortCheck& aborted) {
    using namespace thesis::detail;
    const FoamView mesh = begin();
    thesis::require_one_tension(mesh);
    const AreaRate rate = area_rate(const_view(mesh), options_.permeability);
    const BubbleSums sums = sum_bubbles(machine_, rate.mesh, rate);
    const Thresholds limit = thresholds(machine_, mesh, sums.target_area, options_.thresholds);
    diffuse(machine_, mesh, rate, sums, options_.time_step);
    if (!mesh.surroundings.closed() && sums.bubbles == 2 &&
        machine_.reduce(mesh.bubble_slots(), false, IsGone{rate.mesh, limit.t2_area},
                        parallel::Or{})) {
      return {};
    }
    FrameResult result;
    result.performed = true;
    const ThesisRules rules{limit, options_.two_sided_bubbles};
    if (rules.two_sided_bubbles == TwoSidedBubbles::Slide) {
      bidding_.run(mesh, SlideBids{rules.two_sided(), allowed_.all_set(mesh.bubble_slots())});
    }
    result.operations =
        bidding_.run(mesh, CollapseBids<ThesisRules>{rules, allowed_.all_set(mesh.film_slots())});
    machine_.for_each(mesh.bubble_slots(),
                      KeepAbove{mesh.target_area, kLeastTarget * sums.mean_area()});
    jacobi_.prepare(mesh);
    result.report = thesis::sweep_to_rest(machine_, mesh, options_.equilibrator, aborted,
                                          [&] { return jacobi_.sweep(mesh); });
    return result;
  }

private:
  Machine& machine_;
  CoarseningOptions options_;
  Bidding<Machine> bidding_;
  thesis::JacobiSweep<Machine> jacobi_;
  parallel::Flags<Machine> allowed_;
};

} // namespace foam
