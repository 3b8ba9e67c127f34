// SPDX-License-Identifier: GPL-3.0-or-later
//
// A foam as VTK data sets: its films, which carry its whole state, and its bubbles, to look at.
#pragma once

#include <span>

#include "mesh/topological_event.h"
#include "sampling/sampled_foam.h"

class vtkPolyData;

namespace foam::filters {

/// Version of the films' arrays. Version 1 has no FilmTension, PeriodVectors or OutsidePressure.
inline constexpr int kFormatVersion = 2;

/// Writes a foam's films: FilmPolylines, and the foam's state.
void write_films(const SampledFoam& foam, vtkPolyData* films);

/// Writes a foam's bubbles: BubblePolygons.
void write_bubbles(const SampledFoam& foam, vtkPolyData* bubbles);

/// Writes topological operations: a vertex for each, with their Kind, Time, Strain and Bubbles.
void write_events(std::span<const TopologicalEvent> events, vtkPolyData* vertices);

} // namespace foam::filters
