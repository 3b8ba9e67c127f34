// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/foam.h"

namespace foam {

/// The factor with which pressures hold the films' arcs best: the least squares' one over the films
/// that bend, of Laplace and Young's law as curvature_error has it: 2 sin α = factor·q·d/T. 1 if
/// there are no differences of pressure.
double pressure_factor(const Foam& foam);

/// Takes the areas that bubbles have as their targets, and the pressures that go with the films as
/// they are: those there are times pressure_factor(). So a foam that was scaled by s, whose
/// pressures are those of the other size, gets them divided by s and is in equilibrium as it was.
/// Those of the outsides are scaled with them.
void take_measured_targets(Foam& foam);

} // namespace foam
