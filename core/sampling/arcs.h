// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <vector>

#include "mesh/foam.h"

namespace foam {

/// Appends the points of a half-film's arc from its start, which lies at `start`, to its end: both
/// ends and as many points between as keep the polyline within chord_error (cm) of the arc.
void sample_arc(const Foam& foam, Index half, Vec2 start, double chord_error,
                std::vector<Vec2>& points);

/// The closed outline of a bubble, sampled like its films, counter-clockwise, in one piece also on
/// a torus; the first point is not repeated.
std::vector<Vec2> sample_bubble(const Foam& foam, Index bubble, double chord_error);

} // namespace foam
