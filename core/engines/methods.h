// SPDX-License-Identifier: GPL-3.0-or-later
//
// What is computed where. Checks, messages and the table in docs/proxies/equilibrator.md follow
// from this one list.
#pragma once

#include <span>

#include "coarsening/options.h"

namespace foam {

/// Whether a GPU computes a method.
enum class OnGpu {
  Yes,   ///< Device = Auto takes one that is there
  Asked, ///< only Device = CUDA does
  No
};

struct Method {
  enum class Work { Equilibrium, Coarsening };

  Work work;
  const char* options;                         ///< that choose it, as a user sets them
  bool (*chosen_by)(const CoarseningOptions&); ///< unless a method before it is
  OnGpu gpu;
  const char* obstacle; ///< why Auto, or any device, does not take a GPU; empty for OnGpu::Yes
};

/// All of them.
std::span<const Method> methods();

/// The method that options choose; for Work::Equilibrium those of the equilibrator alone matter.
const Method& method_for(Method::Work work, const CoarseningOptions& options);

} // namespace foam
