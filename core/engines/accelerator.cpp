// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/accelerator.h"

#include <iostream>
#include <mutex>
#include <optional>

#include "base/error.h"

namespace foam {
namespace {

std::optional<Accelerator>& cuda() {
  static std::optional<Accelerator> accelerator;
  return accelerator;
}

} // namespace

void register_cuda(const Accelerator& accelerator) {
  cuda() = accelerator;
}

const Accelerator* accelerator_for(Device device, const Method& method) {
  const bool demanded = device == Device::CUDA;
  const auto without = [&](const std::string& reason) -> const Accelerator* {
    if (demanded) {
      throw FoamError("Device = CUDA, but " + reason);
    }
    return nullptr;
  };
  if (device == Device::CPU) {
    return nullptr;
  }
  if (!cuda()) {
    return without("this build has no CUDA support");
  }
  if (method.gpu == OnGpu::No || (method.gpu == OnGpu::Asked && !demanded)) {
    return without(method.obstacle);
  }
  const std::string reason = cuda()->unavailable();
  if (!reason.empty()) {
    static std::once_flag said;
    if (!demanded) {
      std::call_once(said, [&] {
        std::clog << "Foam: Device = Auto computes on the CPU: " << reason << std::endl;
      });
    }
    return without(reason);
  }
  return &*cuda();
}

} // namespace foam
