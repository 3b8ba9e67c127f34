// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/foam.h"

namespace foam {

/// A foam's arrays where they lie, in a Foam or on a GPU: what the functions of one element work on
/// wherever they run. Owns nothing; the arrays must outlive it and keep their lengths.
///
/// Events are not counted here, where many may happen at once.
struct FoamView : MeshAccess<FoamView> {
  Index* bubble_half = nullptr;
  Index* sides = nullptr;
  double* pressure = nullptr;
  double* target_area = nullptr;

  Index* half_junction = nullptr;
  Index* half_bubble = nullptr;

  double* film_angle = nullptr;
  Wrap* film_wrap = nullptr;

  Vec2* position = nullptr;
  std::array<Index, 3>* junction_half = nullptr;

  Boundary boundary = Boundary::Free;
  Box box;
  double surface_tension = 0;

  Index bubbles = 0;   ///< length of the bubbles' arrays
  Index films = 0;     ///< of the films'; twice that of the half-films'
  Index junctions = 0; ///< of the junctions'
};

/// The view of a foam's own arrays.
inline FoamView view_of(Foam& foam) {
  FoamView view;
  view.bubble_half = foam.bubble_half.data();
  view.sides = foam.sides.data();
  view.pressure = foam.pressure.data();
  view.target_area = foam.target_area.data();
  view.half_junction = foam.half_junction.data();
  view.half_bubble = foam.half_bubble.data();
  view.film_angle = foam.film_angle.data();
  view.film_wrap = foam.film_wrap.data();
  view.position = foam.position.data();
  view.junction_half = foam.junction_half.data();
  view.boundary = foam.boundary;
  view.box = foam.box;
  view.surface_tension = foam.surface_tension;
  view.bubbles = foam.bubble_capacity();
  view.films = foam.film_capacity();
  view.junctions = foam.junction_capacity();
  return view;
}

/// The view of a foam that is only looked at.
inline FoamView view_of(const Foam& foam) {
  return view_of(const_cast<Foam&>(foam));
}

} // namespace foam
