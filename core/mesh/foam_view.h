// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/foam.h"

namespace foam {

/// A foam's arrays where they lie, in a Foam or on a GPU: what the functions of one element work on
/// wherever they run. Owns nothing; the arrays must outlive it and keep their lengths.
///
/// Events are not counted here, where many may happen at once.
template <template <class, class> class Array>
struct BasicFoamView : FoamArrays<Array>, MeshAccess<BasicFoamView<Array>> {
  Surroundings surroundings;
  double surface_tension = 0;

  Index bubbles = 0;   ///< length of the bubbles' arrays
  Index films = 0;     ///< of the films'; twice that of the half-films'
  Index junctions = 0; ///< of the junctions'
  Index outsides = 0;  ///< of the outsides'

  FOAM_HOST_DEVICE Slots<Bubble> bubble_slots() const { return Slots<Bubble>(bubbles); }
  FOAM_HOST_DEVICE Slots<Film> film_slots() const { return Slots<Film>(films); }
  FOAM_HOST_DEVICE Slots<Junction> junction_slots() const { return Slots<Junction>(junctions); }
  FOAM_HOST_DEVICE Slots<Outside> outside_slots() const { return Slots<Outside>(outsides); }
};

/// To be changed.
using FoamView = BasicFoamView<FieldView>;
/// To be looked at.
using ConstFoamView = BasicFoamView<ConstFieldView>;

namespace detail {

template <class View, class Arrays>
View view_of_arrays(Arrays& arrays, const Surroundings& surroundings, double surface_tension) {
  View view;
  for_each_array(
      [](auto& mine, auto& its) {
        mine = std::remove_reference_t<decltype(mine)>(its.empty() ? nullptr : its.data());
      },
      view, arrays);
  view.surroundings = surroundings;
  view.surface_tension = surface_tension;
  view.bubbles = static_cast<Index>(arrays.bubble_half.size());
  view.films = static_cast<Index>(arrays.film_angle.size());
  view.junctions = static_cast<Index>(arrays.position.size());
  view.outsides = static_cast<Index>(arrays.exterior.size());
  return view;
}

} // namespace detail

/// The view of a foam's own arrays.
inline FoamView view_of(Foam& foam) {
  return detail::view_of_arrays<FoamView>(foam, foam.surroundings, foam.surface_tension);
}
inline ConstFoamView view_of(const Foam& foam) {
  return detail::view_of_arrays<ConstFoamView>(foam, foam.surroundings, foam.surface_tension);
}

/// The same to be looked at.
inline ConstFoamView const_view(const FoamView& mesh) {
  ConstFoamView view;
  for_each_array(
      [](auto& mine, const auto& its) {
        mine = std::remove_reference_t<decltype(mine)>(its.data());
      },
      view, mesh);
  view.surroundings = mesh.surroundings;
  view.surface_tension = mesh.surface_tension;
  view.bubbles = mesh.bubbles;
  view.films = mesh.films;
  view.junctions = mesh.junctions;
  view.outsides = mesh.outsides;
  return view;
}

} // namespace foam
