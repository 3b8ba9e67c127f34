// SPDX-License-Identifier: GPL-3.0-or-later
#include "deformation/flow.h"

namespace foam {
namespace {

/// Of a cell, that a junction may lie outside it, so that none on its edge goes back and forth.
constexpr double kBeyond = 1e-3;

bool is_outside(Vec2 coordinates) {
  const auto outside = [](double x) { return x < -kBeyond || x > 1 + kBeyond; };
  return outside(coordinates.x) || outside(coordinates.y);
}

} // namespace

void strain(Foam& foam, const Tensor& deformation) {
  Lattice& lattice = foam.surroundings.lattice;
  lattice.first = deformation * lattice.first;
  lattice.second = deformation * lattice.second;
  for (Vec2& place : foam.position) {
    place = lattice.origin + deformation * (place - lattice.origin);
  }
}

void make_compact(Foam& foam) {
  Lattice& lattice = foam.surroundings.lattice;
  if (const ReducedLattice compact = reduced(lattice); compact.lattice != lattice) {
    lattice = compact.lattice;
    for (Wrap& wrap : foam.film_wrap) {
      wrap = compact.wrap(wrap);
    }
  }
  for (const Junction j : foam.junction_slots()) {
    if (foam.has_junction(j) && is_outside(lattice.coordinates(foam.position[j]))) {
      const Wrap cell = lattice.cell_of(foam.position[j]);
      foam.position[j] -= lattice.period(cell);
      for (const Half h : foam.junction_half[j]) {
        foam.set_wrap(h, foam.wrap(h) - cell);
      }
    }
  }
}

} // namespace foam
