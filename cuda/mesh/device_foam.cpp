// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/device_foam.h"

namespace foam::cuda {
namespace {

/// Calls visit(array of mine, array of the other's) for each of a foam's arrays.
template <class Mine, class Other, class Visit>
void for_each_array(Mine& mine, Other& other, const Visit& visit) {
  visit(mine.bubble_half, other.bubble_half);
  visit(mine.sides, other.sides);
  visit(mine.pressure, other.pressure);
  visit(mine.target_area, other.target_area);
  visit(mine.half_junction, other.half_junction);
  visit(mine.half_bubble, other.half_bubble);
  visit(mine.film_angle, other.film_angle);
  visit(mine.film_wrap, other.film_wrap);
  visit(mine.position, other.position);
  visit(mine.junction_half, other.junction_half);
}

} // namespace

void DeviceFoam::upload(const Foam& foam) {
  for_each_array(arrays_, foam, [](auto& mine, const auto& its) { mine.upload(its); });
  boundary_ = foam.boundary;
  box_ = foam.box;
  surface_tension_ = foam.surface_tension;
}

void DeviceFoam::download(Foam& foam) const {
  for_each_array(arrays_, foam, [](const auto& mine, auto& its) { mine.download(its); });
}

void DeviceFoam::copy_from(const DeviceFoam& other) {
  for_each_array(arrays_, other.arrays_, [](auto& mine, const auto& its) { mine.copy_from(its); });
  boundary_ = other.boundary_;
  box_ = other.box_;
  surface_tension_ = other.surface_tension_;
}

FoamView DeviceFoam::view() {
  FoamView view;
  for_each_array(arrays_, view, [](auto& mine, auto& its) { its = mine.data(); });
  view.boundary = boundary_;
  view.box = box_;
  view.surface_tension = surface_tension_;
  view.bubbles = static_cast<Index>(arrays_.bubble_half.size());
  view.films = static_cast<Index>(arrays_.film_angle.size());
  view.junctions = static_cast<Index>(arrays_.position.size());
  return view;
}

} // namespace foam::cuda
