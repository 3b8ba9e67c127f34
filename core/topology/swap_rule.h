// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/foam.h"

namespace foam {

/// Whether the films at the ends of a short film pull it shut, and would pull the swapped film
/// open: the physics of a T1, which a rule of length alone misses.
///
/// With unit tangents t₁, t₂ at one end and t₃, t₄ at the other, t₁ and t₄ on the same side, the
/// film's own tension 1 is overcome by the pairs across it if |t₁ + t₄| > 1, and they pull harder
/// than those along it if |t₁ + t₄| > |t₁ + t₂|. The same must hold on the other side and at the
/// other end. A film that ends on the wall of a container is pulled shut by whatever shortens it.
bool pulled_shut(const Foam& foam, Index film);

/// Whether the bubbles along a film have more than three sides, so that a swap leaves each three or
/// more: three-sided bubbles vanish by T2. Beside a container's wall two are enough, the wall and a
/// film.
bool spares_sides(const Foam& foam, Index film);

} // namespace foam
