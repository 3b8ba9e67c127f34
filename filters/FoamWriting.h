// SPDX-License-Identifier: GPL-3.0-or-later
//
// A foam as VTK data sets: its films, which carry its whole state, and its bubbles, to look at.
#pragma once

#include "mesh/foam.h"

class vtkPolyData;

namespace foam::filters {

/// Version of the films' arrays.
inline constexpr int kFormatVersion = 1;

/// Writes a foam to its two data sets.
/// \param chord_error largest distance between an arc and its polyline, cm; 0 stands for 1/200 of
/// the mean spacing.
void write_foam(const Foam& foam, double chord_error, vtkPolyData* films, vtkPolyData* bubbles);

/// One polyline per film, in the order of film_set(foam). The first points are the junctions, which
/// films share. A film that crosses the border of the torus ends in a point of its own, a whole
/// number of periods from its junction. Points inside arcs follow, each of one film alone.
/// \param chord_error cm, > 0.
void write_films(const Foam& foam, double chord_error, vtkPolyData* films);

/// One polygon per bubble in ascending order of BubbleId, in one piece and, on a torus, with its
/// centroid in the box. Each begins where a fan of triangles covers it best.
/// \param chord_error cm, > 0.
void write_bubbles(const Foam& foam, double chord_error, vtkPolyData* bubbles);

} // namespace foam::filters
