// SPDX-License-Identifier: GPL-3.0-or-later
//
// The gas that films let through: one law for bubbles wherever they lie, for a whole foam, and on
// an executor (parallel/host.h).
#pragma once

#include <numbers>
#include <span>

#include "mesh/element_measures.h"
#include "mesh/foam_view.h"
#include "parallel/kernels.h"

namespace foam {

/// Von Neumann's rate of growth per side beyond six (thesis 2.4.5), K = (2π/3)γκ, cm²/s.
double von_neumann_constant(double surface_tension, double kappa);

/// What a film lets through per length and pressure difference: κ, and nothing if it is a piece of
/// a wall.
template <class Mesh> FOAM_HOST_DEVICE double permeability(const Mesh& mesh, Half h, double kappa) {
  return mesh.wall(h) ? 0 : kappa;
}

/// dA/dt of a bubble from the gas that its films let through, −Σ κ·l·Δp (thesis 2.4.1), cm²/s.
template <class Mesh>
FOAM_APART double gas_transfer(const Mesh& mesh, Bubble bubble, double kappa) {
  double inflow = 0;
  for_each_half(mesh, bubble, [&](Half h) {
    inflow -= permeability(mesh, h, kappa) * mesh.length(h) * mesh.pressure_difference(h);
  });
  return inflow;
}

/// The gas transfer of a bubble with no wall beside it, in equilibrium, cm²/s. There l·Δp is T·2α
/// of a film, and all the films turn by 2π − Σ(π − θ) with the angles θ of Neumann's triangles, so
/// that with their mean tension T̄ it is −κ(T̄(2π − Σ(π − θ)) + Σ(T − T̄)·2α). What is measured is
/// the second sum alone, so that little is felt of an equilibrium that is not quite reached.
template <class Mesh>
FOAM_HOST_DEVICE double balanced_gas_transfer(const Mesh& mesh, Bubble bubble, double kappa) {
  constexpr double kPi = std::numbers::pi;
  double mean = 0;
  for_each_half(mesh, bubble, [&](Half h) { mean += mesh.tension(h.film()) / mesh.sides[bubble]; });
  double turn = 2 * kPi;
  double rest = 0;
  for_each_half(mesh, bubble, [&](Half h) {
    const double tension = mesh.tension(h.film());
    const Film before = mesh.next_around_junction(h).film();
    const Film outer = mesh.previous_around_junction(h).film();
    turn -= kPi - neumann_angle(tension, mesh.tension(before), mesh.tension(outer));
    rest += (tension - mean) * 2 * mesh.half_angle(h);
  });
  return -kappa * (mean * turn + rest);
}

/// Von Neumann's law for a bubble on walls on which films slip, in units of K: with k films, and m
/// stretches of walls that turn to the left by φ in all as they are walked with the bubble on the
/// left, corners included, k + 2m − 6 + (3/π)φ. For of the full turn of 2π its corners take π/2 at
/// either end of a stretch and π/3 at each of the other k − m, and films let through κT for each
/// radian by which they turn.
template <class Mesh> FOAM_HOST_DEVICE double growth_on_walls(const Mesh& mesh, Bubble bubble) {
  double growth = -6;
  for_each_half(mesh, bubble, [&](Half h) {
    growth += mesh.wall(h) ? 2 + 3 / std::numbers::pi * mesh.stretch(h).turn : 1;
  });
  return growth;
}

/// The rate at which a bubble's target area changes, cm²/s. Where all films have one tension it is
/// von Neumann's K(n − 6) (thesis 2.4.5), also on the free boundary, where n counts the outer film,
/// and on walls on which films slip. Where films do not meet at such angles all around the bubble,
/// where they are pinned or with tensions of their own, it is the gas transfer itself, measured as
/// far as it has to be.
struct AreaRate {
  ConstFoamView mesh;
  double constant = 0; ///< K, cm²/s
  double kappa = 0;

  FOAM_HOST_DEVICE double operator()(Bubble bubble) const {
    return everywhere_alike() ? constant * (mesh.sides[bubble] - 6) : rate_of(bubble);
  }

  /// Whether the bubble takes a share, as large as its gas, of what the total is off, in a closed
  /// foam, where no gas is lost: those do whose rate is measured.
  FOAM_HOST_DEVICE bool takes_a_share(Bubble bubble) const {
    return mesh.surroundings.closed() && measured(bubble);
  }

  /// Whether the rate changes as the bubble does; von Neumann's stays while topology does, but for
  /// bubbles that come to cover more or less of a curved wall.
  FOAM_HOST_DEVICE bool measured(Bubble bubble) const {
    return !everywhere_alike() && is_measured(bubble);
  }

private:
  /// Of walls beside a bubble.
  struct Beside {
    bool wall = false;
    bool pinned = false; ///< films end there that do not slip
    bool curved = false; ///< where a film ends
  };

  /// Whether films meet everywhere at the same angles: there are no walls, and one tension.
  FOAM_HOST_DEVICE bool everywhere_alike() const {
    return !mesh.surroundings.has_walls() && mesh.has_uniform_tension();
  }
  FOAM_APART double rate_of(Bubble bubble) const {
    const Beside beside = what_is_beside(bubble);
    if (beside.pinned) {
      return gas_transfer(mesh, bubble, kappa);
    }
    if (!mesh.has_uniform_tension()) {
      return beside.wall ? gas_transfer(mesh, bubble, kappa)
                         : balanced_gas_transfer(mesh, bubble, kappa);
    }
    return constant * (beside.wall ? growth_on_walls(mesh, bubble) : mesh.sides[bubble] - 6);
  }
  FOAM_APART bool is_measured(Bubble bubble) const {
    const Beside beside = what_is_beside(bubble);
    return !mesh.has_uniform_tension() || beside.pinned || beside.curved;
  }
  FOAM_HOST_DEVICE Beside what_is_beside(Bubble bubble) const {
    Beside beside;
    if (mesh.surroundings.has_walls()) {
      for_each_half(mesh, bubble, [&](Half h) {
        const Junction j = mesh.start(h);
        if (mesh.on_wall(j)) {
          const Freedom freedom = mesh.freedom(j);
          beside.wall = true;
          beside.pinned = beside.pinned || !freedom.any();
          beside.curved = beside.curved || freedom.curvature() != 0;
        }
      });
    }
    return beside;
  }
};

AreaRate area_rate(const ConstFoamView& mesh, double kappa);

/// Over all bubbles.
struct BubbleSums {
  double target_area = 0; ///< cm²
  double rate = 0;        ///< dA^τ/dt, cm²/s
  double sharing = 0;     ///< target area of those that share what the total is off, cm²
  Index bubbles = 0;

  double mean_area() const { return target_area / bubbles; }
  /// What the total is off, per gas of the bubbles that take a share, 1/s: rounding, and what the
  /// equilibrium's tolerance leaves.
  double excess() const { return sharing > 0 ? rate / sharing : 0; }

  friend FOAM_HOST_DEVICE BubbleSums operator+(const BubbleSums& a, const BubbleSums& b) {
    return {a.target_area + b.target_area, a.rate + b.rate, a.sharing + b.sharing,
            a.bubbles + b.bubbles};
  }
};

namespace detail {

template <class Rate> struct SumBubble {
  ConstFoamView mesh;
  Rate rate;

  FOAM_HOST_DEVICE BubbleSums operator()(Bubble bubble) const {
    if (!mesh.has_bubble(bubble)) {
      return {};
    }
    const double gas = mesh.target_area[bubble];
    return {gas, rate(bubble), rate.takes_a_share(bubble) ? gas : 0, 1};
  }
};

/// A bubble's rate without its share of the excess (see BubbleSums).
template <class Mesh, class Rate>
FOAM_HOST_DEVICE double balanced(const Mesh& mesh, const Rate& rate, Bubble bubble, double excess) {
  return rate(bubble) - (rate.takes_a_share(bubble) ? excess * mesh.target_area[bubble] : 0);
}

/// A^τ ← A^τ + dA/dt·Δt (3.7.1).
template <class Rate> struct Diffuse {
  FoamView mesh;
  Rate rate;
  double excess = 0;    ///< see BubbleSums
  double time_step = 0; ///< s

  FOAM_HOST_DEVICE void operator()(Bubble bubble) const {
    if (mesh.has_bubble(bubble)) {
      mesh.target_area[bubble] += balanced(mesh, rate, bubble, excess) * time_step;
    }
  }
};

} // namespace detail

/// \param rate as AreaRate
template <class Executor, class Rate>
BubbleSums sum_bubbles(Executor& executor, const ConstFoamView& mesh, const Rate& rate) {
  return executor.reduce(mesh.bubble_slots(), BubbleSums{}, detail::SumBubble<Rate>{mesh, rate},
                         parallel::Add{});
}

/// Diffusion through a time step (s). A rate may depend on its bubble's target area, on no other's.
template <class Executor, class Rate>
void diffuse(Executor& executor, const FoamView& mesh, const Rate& rate, const BubbleSums& sums,
             double time_step) {
  executor.for_each(mesh.bubble_slots(),
                    detail::Diffuse<Rate>{mesh, rate, sums.excess(), time_step});
}

/// The rates of all bubbles, 0 for those that are gone; a closed foam's total is conserved.
Field<Bubble, double> area_rates(const Foam& foam, double kappa);

/// Whether there are bubbles whose rates change between topological events.
bool area_rates_change(const Foam& foam);

/// How fast the rates of a foam in equilibrium change as it moves, cm²/s². What films let through
/// there is κ·T·2α. \param angle_rates of films, rad/s
Field<Bubble, double> area_rate_changes(const Foam& foam, double kappa,
                                        std::span<const double> angle_rates);

} // namespace foam
