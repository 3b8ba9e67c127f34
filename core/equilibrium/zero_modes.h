// SPDX-License-Identifier: GPL-3.0-or-later
//
// What costs a foam nothing: in closed surroundings a common pressure, as only differences of
// pressure act there; and motions of the whole, which nothing but a wall resists, and that only
// where it does not take the wall to itself; on a torus but for rotations. On an executor
// (parallel/host.h).
#pragma once

#include "algebra/displacements.h"
#include "equilibrium/domain.h"
#include "parallel/kernels.h"

namespace foam::newton {

/// What holds them where a matrix is factorised: too small to be felt elsewhere, in units of T/ℓ
/// for positions, and with the other sign of ℓ³/T for pressures.
inline constexpr double kRegularisation = 1e-8;

/// Takes the mean out of the pressures of some bubbles, where it means nothing.
template <class Executor>
void remove_common_pressure(Executor& executor, const ConstFoamView& mesh,
                            const Elements<Bubble>& bubbles,
                            const FieldView<Bubble, double>& pressure) {
  if (!mesh.surroundings.closed()) {
    return;
  }
  const Vec2 sum = executor.reduce( // in x that of the pressures, in y how many
      bubbles, Vec2{},
      FOAM_KERNEL(Bubble b) {
        return mesh.has_bubble(b) ? Vec2{pressure[b], 1} : Vec2{};
      },
      parallel::Add{});
  const double mean = sum.x / sum.y;
  executor.for_each(
      bubbles, FOAM_KERNEL(Bubble b) {
        if (mesh.has_bubble(b)) {
          pressure[b] -= mean;
        }
      });
}

/// Means over a foam's junctions.
struct RigidMeans {
  Vec2 translation, centre;

  friend FOAM_HOST_DEVICE RigidMeans operator+(const RigidMeans& a, const RigidMeans& b) {
    return {a.translation + b.translation, a.centre + b.centre};
  }
};

/// Takes motions of the whole foam out of displacements, x and y of each junction of the domain in
/// turn: rounding decides how much of them there is.
template <class Executor>
void remove_rigid_motion(Executor& executor, const ConstFoamView& mesh, const Domain& domain,
                         double* moved) {
  const Surroundings& around = mesh.surroundings;
  if (!domain.whole || !(around.translates_along_x() || around.rotates())) {
    return;
  }
  const Elements<Junction> junctions = domain.junctions;
  const Index size = junctions.size();
  const double share =
      1 / executor.reduce(
              size, 0.0, FOAM_KERNEL(Index i) { return mesh.moves(junctions[i]) ? 1.0 : 0.0; },
              parallel::Add{});
  const RigidMeans means = executor.reduce(
      size, RigidMeans{},
      FOAM_KERNEL(Index i) {
        const Junction j = junctions[i];
        return mesh.moves(j) ? RigidMeans{share * displacement(moved, i), share * mesh.position[j]}
                             : RigidMeans{};
      },
      parallel::Add{});
  const Vec2 translation{around.translates_along_x() ? means.translation.x : 0,
                         around.translates_along_y() ? means.translation.y : 0};
  const Vec2 centre = around.has_walls() ? around.centre : means.centre;
  double rotation = 0;
  if (around.rotates()) {
    // In x the moment of all displacements, in y the moment of inertia.
    const Vec2 moment = executor.reduce(
        size, Vec2{},
        FOAM_KERNEL(Index i) {
          const Junction j = junctions[i];
          const Vec2 r = mesh.position[j] - centre;
          return mesh.moves(j) ? Vec2{cross(r, displacement(moved, i)), dot(r, r)} : Vec2{};
        },
        parallel::Add{});
    rotation = moment.x / moment.y;
  }
  executor.for_each(
      size, FOAM_KERNEL(Index i) {
        const Junction j = junctions[i];
        if (mesh.moves(j)) {
          const Vec2 r = mesh.position[j] - centre;
          const Vec2 rigid = translation + rotation * left_normal(r);
          set_displacement(moved, i, displacement(moved, i) - rigid);
        }
      });
}

} // namespace foam::newton
