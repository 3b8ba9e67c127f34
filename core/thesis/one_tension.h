// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "base/error.h"

namespace foam::thesis {

/// The thesis knows one tension, 2γ. \throws FoamError if films of the mesh have their own.
template <class Mesh> void require_one_tension(const Mesh& mesh) {
  if (!mesh.has_uniform_tension()) {
    throw FoamError("Equilibrator = Junction knows one tension for all films, but here films have "
                    "their own, which takes Equilibrator = Newton");
  }
}

} // namespace foam::thesis
