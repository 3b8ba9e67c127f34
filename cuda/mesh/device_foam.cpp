// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/device_foam.h"

namespace foam::cuda {

void DeviceFoam::upload(const Foam& foam) {
  bubble_half_.upload(foam.bubble_half);
  sides_.upload(foam.sides);
  pressure_.upload(foam.pressure);
  target_area_.upload(foam.target_area);
  half_junction_.upload(foam.half_junction);
  half_bubble_.upload(foam.half_bubble);
  film_angle_.upload(foam.film_angle);
  film_wrap_.upload(foam.film_wrap);
  position_.upload(foam.position);
  junction_half_.upload(foam.junction_half);
  boundary_ = foam.boundary;
  box_ = foam.box;
  surface_tension_ = foam.surface_tension;
}

void DeviceFoam::download(Foam& foam) const {
  bubble_half_.download(foam.bubble_half);
  sides_.download(foam.sides);
  pressure_.download(foam.pressure);
  target_area_.download(foam.target_area);
  half_junction_.download(foam.half_junction);
  half_bubble_.download(foam.half_bubble);
  film_angle_.download(foam.film_angle);
  film_wrap_.download(foam.film_wrap);
  position_.download(foam.position);
  junction_half_.download(foam.junction_half);
}

void DeviceFoam::copy_from(const DeviceFoam& other) {
  bubble_half_.copy_from(other.bubble_half_);
  sides_.copy_from(other.sides_);
  pressure_.copy_from(other.pressure_);
  target_area_.copy_from(other.target_area_);
  half_junction_.copy_from(other.half_junction_);
  half_bubble_.copy_from(other.half_bubble_);
  film_angle_.copy_from(other.film_angle_);
  film_wrap_.copy_from(other.film_wrap_);
  position_.copy_from(other.position_);
  junction_half_.copy_from(other.junction_half_);
  boundary_ = other.boundary_;
  box_ = other.box_;
  surface_tension_ = other.surface_tension_;
}

FoamView DeviceFoam::view() {
  FoamView view;
  view.bubble_half = bubble_half_.data();
  view.sides = sides_.data();
  view.pressure = pressure_.data();
  view.target_area = target_area_.data();
  view.half_junction = half_junction_.data();
  view.half_bubble = half_bubble_.data();
  view.film_angle = film_angle_.data();
  view.film_wrap = film_wrap_.data();
  view.position = position_.data();
  view.junction_half = junction_half_.data();
  view.boundary = boundary_;
  view.box = box_;
  view.surface_tension = surface_tension_;
  view.bubbles = static_cast<Index>(bubble_half_.size());
  view.films = static_cast<Index>(film_angle_.size());
  view.junctions = static_cast<Index>(position_.size());
  return view;
}

} // namespace foam::cuda
