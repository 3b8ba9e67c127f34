// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>

#include "mesh/film_set.h"

class vtkDataObject;
class vtkPolyData;

namespace foam::filters {

/// What is connected, if it can be films. \throws FoamError saying what it is.
vtkPolyData* films_in(vtkDataObject* input);

/// The films that write_films wrote, checked one by one: reading what was written gives the same
/// list, bit for bit.
/// \throws FoamError naming the cause and the offending value.
FilmSet read_films(vtkPolyData* films);

/// The foam of films that write_films wrote, to be measured: single bubbles may be inside out, as a
/// frame that did not converge may have them, but not all together. Its report is what the films
/// say of themselves.
/// \throws FoamError naming the cause and the offending value.
Foam read_foam(vtkPolyData* films);

/// The foam of a list of films, if every bubble has an area.
/// \throws FoamError naming the cause and the offending value.
Foam checked_foam(const FilmSet& films);

/// How far the coordinates of films, or what their half-angles stand for, may be off by rounding,
/// cm.
double coordinate_rounding(vtkPolyData* films);

/// What is wrong with a report that films give of themselves, with what was found by measuring;
/// empty if it was confirmed.
std::string doubt(const EquilibriumReport& given, const EquilibriumReport& found);

/// The time (s) that films carry; 0 if they carry none.
double read_time(vtkPolyData* films);

/// Why the run ended whose last frame these films or bubbles are; empty if it did not.
std::string read_end(vtkPolyData* data);

} // namespace foam::filters
