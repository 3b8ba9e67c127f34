// SPDX-License-Identifier: GPL-3.0-or-later
#include "mesh/device_foam.h"

namespace foam::cuda {

void DeviceFoam::upload(const Foam& foam) {
  for_each_array([](auto& mine, const auto& its) { mine.upload(its); }, arrays_, foam);
  surroundings_ = foam.surroundings;
  surface_tension_ = foam.surface_tension;
}

void DeviceFoam::download(Foam& foam) const {
  for_each_array([](const auto& mine, auto& its) { mine.download(its); }, arrays_, foam);
}

void DeviceFoam::copy_from(const DeviceFoam& other) {
  for_each_array([](auto& mine, const auto& its) { mine.copy_from(its); }, arrays_, other.arrays_);
  surroundings_ = other.surroundings_;
  surface_tension_ = other.surface_tension_;
}

FoamView DeviceFoam::view() {
  return detail::view_of_arrays<FoamView>(arrays_, surroundings_, surface_tension_);
}

} // namespace foam::cuda
