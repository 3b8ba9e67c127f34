// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/foam_view.h"
#include "parallel/device_array.h"

namespace foam::cuda {

/// A foam's arrays on the device, and no more of it: names, time and counts stay with the Foam.
class DeviceFoam {
public:
  void upload(const Foam& foam);
  /// Into the foam that was uploaded.
  void download(Foam& foam) const;
  void copy_from(const DeviceFoam& other);

  /// Valid until the next upload or copy.
  FoamView view();

private:
  DeviceArray<Index> bubble_half_, sides_;
  DeviceArray<double> pressure_, target_area_;
  DeviceArray<Index> half_junction_, half_bubble_;
  DeviceArray<double> film_angle_;
  DeviceArray<Wrap> film_wrap_;
  DeviceArray<Vec2> position_;
  DeviceArray<std::array<Index, 3>> junction_half_;

  Boundary boundary_ = Boundary::Free;
  Box box_;
  double surface_tension_ = 0;
};

} // namespace foam::cuda
