// SPDX-License-Identifier: GPL-3.0-or-later
//
// Diffusion (diffusion.h) on a machine (parallel/host.h).
#pragma once

#include "coarsening/diffusion.h"
#include "mesh/foam_view.h"
#include "parallel/kernels.h"

namespace foam {

/// dA^τ/dt of a bubble (area_rates), cm²/s, but for the share of what a container's total is off.
struct AreaRate {
  FoamView mesh;
  double constant = 0;     ///< von Neumann's K, cm²/s
  double permeability = 0; ///< κ

  FOAM_HOST_DEVICE double operator()(Index bubble) const {
    return at_wall(mesh, bubble) ? gas_transfer(mesh, bubble, permeability)
                                 : constant * (mesh.sides[bubble] - 6);
  }

  /// Whether the bubble takes a share of what the total is off.
  FOAM_HOST_DEVICE bool evens_out(Index bubble) const { return at_wall(mesh, bubble); }
};

/// Of a foam on a machine. \param permeability κ
inline AreaRate area_rate(const FoamView& mesh, double permeability) {
  return {mesh, von_neumann_constant(mesh.surface_tension, permeability), permeability};
}

/// Over all bubbles.
struct BubbleSums {
  double target_area = 0; ///< cm²
  double rate = 0;        ///< dA^τ/dt, cm²/s
  double even_out = 0;    ///< how many share what the total is off
  Index bubbles = 0;

  double mean_area() const { return target_area / bubbles; }
  friend FOAM_HOST_DEVICE BubbleSums operator+(const BubbleSums& a, const BubbleSums& b) {
    return {a.target_area + b.target_area, a.rate + b.rate, a.even_out + b.even_out,
            a.bubbles + b.bubbles};
  }
};

namespace detail {

template <class Rate> struct SumBubble {
  FoamView mesh;
  Rate rate;

  FOAM_HOST_DEVICE BubbleSums operator()(Index bubble) const {
    if (!mesh.has_bubble(bubble)) {
      return {};
    }
    return {mesh.target_area[bubble], rate(bubble), rate.evens_out(bubble) ? 1.0 : 0.0, 1};
  }
};

/// A^τ ← A^τ + dA/dt·Δt (3.7.1).
template <class Rate> struct Diffuse {
  FoamView mesh;
  Rate rate;
  double excess = 0;    ///< of the rate of each bubble that evens out, cm²/s
  double time_step = 0; ///< s

  FOAM_HOST_DEVICE void operator()(Index bubble) const {
    if (mesh.has_bubble(bubble)) {
      const double off = rate.evens_out(bubble) ? excess : 0;
      mesh.target_area[bubble] += (rate(bubble) - off) * time_step;
    }
  }
};

} // namespace detail

/// \param rate as AreaRate
template <class Machine, class Rate>
BubbleSums sum_bubbles(Machine& machine, const FoamView& mesh, const Rate& rate) {
  return machine.reduce(mesh.bubbles, BubbleSums{}, detail::SumBubble<Rate>{mesh, rate},
                        parallel::Add{});
}

/// Diffusion through a time step (s).
template <class Machine, class Rate>
void diffuse(Machine& machine, const FoamView& mesh, const Rate& rate, const BubbleSums& sums,
             double time_step) {
  const double excess = sums.even_out > 0 ? sums.rate / sums.even_out : 0;
  machine.for_each(mesh.bubbles, detail::Diffuse<Rate>{mesh, rate, excess, time_step});
}

} // namespace foam
