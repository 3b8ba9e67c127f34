// SPDX-License-Identifier: GPL-3.0-or-later
//
// FrameCoarsening's frame with TopologicalAlgorithm::Simultaneous and Sweep::Jacobi, every step of
// it in parallel on an executor (parallel/host.h).
#pragma once

#include <algorithm>
#include <limits>

#include "coarsening/frame_result.h"
#include "coarsening/options.h"
#include "parallel/flags.h"
#include "parallel/kernels.h"
#include "physics/gas.h"
#include "thesis/jacobi_sweep.h"
#include "thesis/one_tension.h"
#include "thesis/rules.h"
#include "topology/collapse_operations.h"

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

/// The smallest area of bubbles that are not to vanish, and whose it is.
struct SmallestArea {
  double area = std::numeric_limits<double>::infinity(); ///< cm²
  Bubble bubble = kNone;

  friend FOAM_HOST_DEVICE SmallestArea operator+(const SmallestArea& a, const SmallestArea& b) {
    return b.area < a.area ? b : a;
  }
};

struct AreaToStay {
  ConstFoamView mesh;
  double t2_area = 0;

  FOAM_HOST_DEVICE SmallestArea operator()(Bubble bubble) const {
    return mesh.has_bubble(bubble) && mesh.target_area[bubble] > t2_area
               ? SmallestArea{mesh.area(bubble), bubble}
               : SmallestArea{};
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

template <class Executor> class ParallelFrame {
public:
  ParallelFrame(Executor& executor, const CoarseningOptions& options)
      : executor_(executor), options_(options), reservations_(executor),
        jacobi_(executor, options.equilibrator.junction), allowed_(executor) {}

  /// Advances a mesh by one time step.
  /// \param begin called as begin(), gives the mesh as it was before the frame. Where the frame
  /// throws Aborted or is not performed, the mesh is somewhere in between.
  template <class Begin> FrameResult advance(const Begin& begin, const AbortCheck& aborted) {
    using namespace thesis::detail;
    const FoamView mesh = begin();
    thesis::require_one_tension(mesh);
    const AreaRate rate = area_rate(const_view(mesh), options_.permeability);
    const BubbleSums sums = sum_bubbles(executor_, rate.mesh, rate);
    const Thresholds limit = limits(mesh, sums);
    FrameResult result;
    result.limit = limit;
    diffuse(executor_, mesh, rate, sums, options_.time_step);
    if (!mesh.surroundings.closed() && sums.bubbles == 2 &&
        executor_.reduce(mesh.bubble_slots(), false, IsGone{rate.mesh, limit.t2_area},
                         parallel::Or{})) {
      result.end = Obstacle{End::Cause::LastTwo};
      return result;
    }
    const ThesisRules rules{limit, options_.two_sided_bubbles};
    if (rules.two_sided_bubbles == TwoSidedBubbles::Slide) {
      reservations_.run(mesh,
                        SlideOperations{rules.two_sided(), allowed_.all_set(mesh.bubble_slots())});
    }
    reservations_.run(mesh,
                      CollapseOperations<ThesisRules>{rules, allowed_.all_set(mesh.film_slots())});
    result.add(reservations_.take_performed(), options_.time_step);
    executor_.for_each(mesh.bubble_slots(),
                       KeepAbove{mesh.target_area, kLeastTarget * sums.mean_area()});
    jacobi_.prepare(mesh);
    result.report = thesis::sweep_to_rest(executor_, mesh, options_.equilibrator, aborted,
                                          [&] { return jacobi_.sweep(mesh); });
    const Thresholds ahead = limits(mesh);
    const SmallestArea smallest =
        executor_.reduce(mesh.bubble_slots(), SmallestArea{},
                         AreaToStay{const_view(mesh), ahead.t2_area}, parallel::Add{});
    if (smallest.area < 0) {
      result.end = Obstacle{End::Cause::NoEquilibrium, smallest.bubble, smallest.area};
    } else {
      result.limit = ahead;
    }
    return result;
  }

  /// The thresholds in force for a mesh.
  Thresholds limits(const FoamView& mesh) {
    const AreaRate rate = area_rate(const_view(mesh), options_.permeability);
    return limits(mesh, sum_bubbles(executor_, rate.mesh, rate));
  }

private:
  Thresholds limits(const FoamView& mesh, const BubbleSums& sums) {
    return thresholds(executor_, mesh, sums.target_area, sums.bubbles, options_.thresholds);
  }

  Executor& executor_;
  CoarseningOptions options_;
  Reservations<Executor> reservations_;
  thesis::JacobiSweep<Executor> jacobi_;
  parallel::Flags<Executor> allowed_;
};

} // namespace foam
