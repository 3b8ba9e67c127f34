// SPDX-License-Identifier: GPL-3.0-or-later
//
// A foam's figures as tables.
#pragma once

#include "mesh/foam.h"
#include "statistics/statistics.h"

class vtkTable;

namespace foam::filters {

/// One row: Time (s), Bubbles, MeanSides, Mu2, MeanArea (cm²), AreaSecondMoment, Energy (N),
/// AboavA, StressXX, StressYY, StressXY, NormalStressDifference (N/cm²), T1Count, T2Count, T3Count,
/// Iterations, MaxAngleError (rad), MaxAreaError.
void write_summary(const Foam& foam, const FoamStatistics& figures, vtkTable* table);

/// Adds to the summary the modulus of simple shear at the strain that the foam has, N/cm².
void write_shear_modulus(double modulus, vtkTable* table);

/// One row per number of sides: Sides, Count, Fraction, MeanNeighbourSides, AboavProduct,
/// AboavIdeal, MeanArea.
void write_by_sides(const FoamStatistics& figures, vtkTable* table);

} // namespace foam::filters
