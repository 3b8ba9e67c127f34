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
  /// Under Foam's and FoamView's names.
  struct Arrays {
    DeviceArray<Index> bubble_half, sides;
    DeviceArray<double> pressure, target_area;
    DeviceArray<Index> half_junction, half_bubble;
    DeviceArray<double> film_angle;
    DeviceArray<Wrap> film_wrap;
    DeviceArray<Vec2> position;
    DeviceArray<std::array<Index, 3>> junction_half;
  };

  Arrays arrays_;
  Boundary boundary_ = Boundary::Free;
  Box box_;
  double surface_tension_ = 0;
};

} // namespace foam::cuda
