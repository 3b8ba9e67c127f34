// SPDX-License-Identifier: GPL-3.0-or-later
//
// Films as the shaders read them, from a buffer of texels of four floats:
//
//   0      start x, y, end x, y (cm, from the origin)
//   1      tan(half-angle/2); how far Plateau borders reach to the side (cm)
//   2      the ends of the films left and right of the start, then of the end, −1 for none;
//          end 2·film is a film's start, 2·film + 1 its end
//   3 … 6  in a wet foam, the side of the Plateau border towards each of these: x, y, radius (cm)
#pragma once

#include <string>
#include <vector>

#include <vtkSmartPointer.h>

#include "drawing/film_ends.h"

class vtkPolyData;

namespace foam::rendering {

/// What the films' polylines say, checked; or why they are not films.
struct FilmReading {
  std::vector<DrawnFilm> films;
  double z = 0;        ///< of their plane, cm
  std::string problem; ///< empty if the films can be drawn
};

/// Reads each polyline's first and last point, the cell array HalfAngle and, if it is there, the
/// point array JunctionId; without it, films meet where they share points. A stretch of a wall that
/// is no arc is read segment by segment: its first in its place, the others after all films.
FilmReading read_drawn_films(vtkPolyData* polylines);

/// A line of two vertices for each of them, with the polylines' data.
vtkSmartPointer<vtkPolyData> chords_of(vtkPolyData* polylines);

/// Texels of a film in the buffer, for this radius of Plateau borders.
int texels_per_film(double border_radius);

/// Appends films to a buffer, with positions relative to the origin. Films that are there already
/// keep their numbers.
void append_films(const std::vector<DrawnFilm>& films, Vec2 origin, double border_radius,
                  std::vector<float>& buffer);

} // namespace foam::rendering
