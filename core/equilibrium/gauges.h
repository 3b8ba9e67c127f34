// SPDX-License-Identifier: GPL-3.0-or-later
//
// What costs a foam nothing: in a closed container a common pressure, as only differences of
// pressure act there; and moves of the whole, which nothing but a wall resists, on a torus but for
// turning. On a machine (parallel/host.h), of vectors as whole_foam_system.h has them.
#pragma once

#include "equilibrium/whole_foam_system.h"
#include "parallel/kernels.h"

namespace foam::newton {

/// What holds that where a matrix is factorised: too small to be felt elsewhere, in units of T/ℓ
/// for positions, and with the other sign of ℓ³/T for pressures.
inline constexpr double kRegularisation = 1e-8;

namespace detail {

/// A sum of vectors or, in x, of numbers, and of how many.
struct Total {
  Vec2 sum;
  double count = 0;

  Vec2 mean() const { return count > 0 ? (1 / count) * sum : Vec2{}; }
  friend FOAM_HOST_DEVICE Total operator+(const Total& a, const Total& b) {
    return {a.sum + b.sum, a.count + b.count};
  }
};

struct TotalPressure {
  FoamView mesh;
  const double* vector = nullptr;

  FOAM_HOST_DEVICE Total operator()(Index bubble) const {
    return mesh.has_bubble(bubble) ? Total{{pressure_in(mesh, vector, bubble), 0}, 1} : Total{};
  }
};

struct TotalDisplacement {
  FoamView mesh;
  const double* vector = nullptr;

  FOAM_HOST_DEVICE Total operator()(Index junction) const {
    return moves(mesh, junction) ? Total{displacement(vector, junction), 1} : Total{};
  }
};

struct TotalPosition {
  FoamView mesh;

  FOAM_HOST_DEVICE Total operator()(Index junction) const {
    return moves(mesh, junction) ? Total{mesh.position[junction], 1} : Total{};
  }
};

/// In x the moment of all displacements about a centre, in y the moment of inertia.
struct TotalMoment {
  FoamView mesh;
  Vec2 centre;
  const double* vector = nullptr;

  FOAM_HOST_DEVICE Total operator()(Index junction) const {
    if (!moves(mesh, junction)) {
      return {};
    }
    const Vec2 r = mesh.position[junction] - centre;
    return {{cross(r, displacement(vector, junction)), dot(r, r)}, 1};
  }
};

struct ShiftPressure {
  FoamView mesh;
  double by = 0;
  double* vector = nullptr;

  FOAM_HOST_DEVICE void operator()(Index bubble) const {
    if (mesh.has_bubble(bubble)) {
      vector[2 * mesh.junctions + bubble] += by;
    }
  }
};

/// Takes a rigid motion out of all displacements.
struct HoldJunction {
  FoamView mesh;
  Vec2 translation;
  double rotation = 0;
  Vec2 centre; ///< of the rotation, cm
  double* vector = nullptr;

  FOAM_HOST_DEVICE void operator()(Index junction) const {
    if (moves(mesh, junction)) {
      const Vec2 r = mesh.position[junction] - centre;
      const Vec2 rigid = translation + rotation * left_normal(r);
      set_displacement(vector, junction, displacement(vector, junction) - rigid);
    }
  }
};

template <class Machine, class Map>
Total sum_junctions(Machine& machine, const FoamView& mesh, const Map& map) {
  return machine.reduce(mesh.junctions, Total{}, map, parallel::Add{});
}

} // namespace detail

/// Takes the mean out of a vector's pressures.
template <class Machine>
void level_pressures(Machine& machine, const FoamView& mesh, double* vector) {
  using namespace detail;
  const Total total =
      machine.reduce(mesh.bubbles, Total{}, TotalPressure{mesh, vector}, parallel::Add{});
  machine.for_each(mesh.bubbles, ShiftPressure{mesh, -total.mean().x, vector});
}

/// Takes out of a solution what costs nothing.
template <class Machine> void remove_gauges(Machine& machine, const FoamView& mesh, double* x) {
  using namespace detail;
  if (mesh.boundary != Boundary::Free) {
    level_pressures(machine, mesh, x);
  }
  if (mesh.boundary == Boundary::Fixed) {
    return;
  }
  HoldJunction hold{
      mesh, sum_junctions(machine, mesh, TotalDisplacement{mesh, x}).mean(), 0, {}, x};
  if (mesh.boundary == Boundary::Free) {
    hold.centre = sum_junctions(machine, mesh, TotalPosition{mesh}).mean();
    const Vec2 moment = sum_junctions(machine, mesh, TotalMoment{mesh, hold.centre, x}).sum;
    hold.rotation = moment.x / moment.y;
  }
  machine.for_each(mesh.junctions, hold);
}

} // namespace foam::newton
