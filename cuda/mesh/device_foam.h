// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/foam_view.h"
#include "parallel/device_array.h"

namespace foam::cuda {

/// A value for each element of a kind, in the device's memory.
template <class Element, class T> class DeviceField : public DeviceArray<T> {};

/// A foam's arrays on the device, and no more of it: time and counts stay with the Foam.
class DeviceFoam {
public:
  void upload(const Foam& foam);
  /// Into the foam that was uploaded.
  void download(Foam& foam) const;
  void copy_from(const DeviceFoam& other);

  /// Valid until the next upload or copy.
  FoamView view();

private:
  FoamArrays<DeviceField> arrays_;
  Surroundings surroundings_;
  double surface_tension_ = 0;
};

} // namespace foam::cuda
