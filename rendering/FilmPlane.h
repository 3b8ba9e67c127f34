// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>

#include "geometry/vec2.h"

namespace foam::rendering {

/// How a plane appears on the screen, as the shaders need it. Matrices are column by column.
struct FilmPlane {
  std::array<float, 16> plane_to_clip; ///< of (x, y, 0, 1), x and y from the view's origin
  std::array<float, 9> pixel_to_plane; ///< of (x, y, 1) in window coordinates, homogeneous
  std::array<float, 2> view_origin;    ///< the middle of the view, from the films' origin (cm)
  std::array<float, 2> viewport_size;  ///< pixels
};

/// The plane z through the films' origin, where model_to_clip (row by row) takes it in a viewport
/// (x, y, width, height in pixels). All matrices are multiplied in double precision, and what the
/// shaders get is relative to the middle of the view: so a film keeps its place to a fraction of a
/// pixel also where one has zoomed in a thousand times.
FilmPlane film_plane(const double model_to_clip[16], Vec2 origin, double z, const int viewport[4]);

} // namespace foam::rendering
