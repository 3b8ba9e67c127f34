// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/foam.h"

namespace foam {

/// Gives bubbles the pressures that hold the films' arcs best: what they have more than the world
/// around, times one factor for all, the least squares' one over the films that bend, of Laplace
/// and Young's law as curvature_error has it: 2 sin α = factor·q·d/T. The outsides keep theirs,
/// which are given. \returns the factor, 1 if there are no differences of pressure
double fit_bubble_pressures(Foam& foam);

/// Takes the areas that bubbles have as their targets, and the pressures that go with the films as
/// they are, by fit_bubble_pressures(). So a foam that was scaled by s, whose pressures are those
/// of the other size, gets their differences divided by s and is in equilibrium as it was. Those of
/// outsides other than the world are scaled with them.
void take_measured_targets(Foam& foam);

} // namespace foam
