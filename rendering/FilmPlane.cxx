// SPDX-License-Identifier: GPL-3.0-or-later
#include "FilmPlane.h"

#include <algorithm>
#include <cmath>

#include <vtkMatrix3x3.h>

namespace foam::rendering {
namespace {

/// From the plane, (x, y, 1) relative to a point of it, to the clip coordinates x, y, z and w.
using PlaneToClip = std::array<std::array<double, 3>, 4>;

PlaneToClip plane_to_clip(const double* model_to_clip, Vec2 origin, double z) {
  PlaneToClip m{};
  for (std::size_t row = 0; row < 4; ++row) {
    const double* r = model_to_clip + 4 * row;
    m[row] = {r[0], r[1], r[0] * origin.x + r[1] * origin.y + r[2] * z + r[3]};
  }
  return m;
}

/// From window coordinates (x, y, 1) to the plane; not finite where the plane is seen edge-on.
std::array<double, 9> pixel_to_plane(const PlaneToClip& m, const int* viewport) {
  std::array<double, 9> plane_to_pixel{};
  for (std::size_t column = 0; column < 3; ++column) {
    for (std::size_t row = 0; row < 2; ++row) {
      const double half = 0.5 * viewport[row + 2];
      plane_to_pixel[3 * row + column] =
          half * m[row][column] + (half + viewport[row]) * m[3][column];
    }
    plane_to_pixel[6 + column] = m[3][column];
  }
  std::array<double, 9> inverse{};
  vtkMatrix3x3::Invert(plane_to_pixel.data(), inverse.data());
  return inverse;
}

} // namespace

FilmPlane film_plane(const double model_to_clip[16], Vec2 origin, double z, const int viewport[4]) {
  const auto from_origin = pixel_to_plane(plane_to_clip(model_to_clip, origin, z), viewport);
  const double middle[] = {viewport[0] + 0.5 * viewport[2], viewport[1] + 0.5 * viewport[3]};
  const auto row = [&](std::size_t i) {
    return from_origin[3 * i] * middle[0] + from_origin[3 * i + 1] * middle[1] +
           from_origin[3 * i + 2];
  };
  FilmPlane plane{};
  plane.view_origin = {static_cast<float>(row(0) / row(2)), static_cast<float>(row(1) / row(2))};
  if (!std::isfinite(plane.view_origin[0] + plane.view_origin[1])) {
    plane.view_origin = {0, 0};
  }
  const Vec2 view_origin = origin + Vec2{plane.view_origin[0], plane.view_origin[1]};
  const PlaneToClip m = plane_to_clip(model_to_clip, view_origin, z);
  const auto from_view = pixel_to_plane(m, viewport);
  for (std::size_t i = 0; i < 4; ++i) {
    plane.plane_to_clip[i] = static_cast<float>(m[i][0]);
    plane.plane_to_clip[4 + i] = static_cast<float>(m[i][1]);
    plane.plane_to_clip[12 + i] = static_cast<float>(m[i][2]);
  }
  // Homogeneous, so of any size; a size of one keeps it within single precision.
  const auto largest = std::max_element(from_view.begin(), from_view.end(), [](double a, double b) {
    return std::abs(a) < std::abs(b);
  });
  for (std::size_t r = 0; r < 3; ++r) {
    for (std::size_t column = 0; column < 3; ++column) {
      plane.pixel_to_plane[3 * column + r] =
          static_cast<float>(from_view[3 * r + column] / std::abs(*largest));
    }
  }
  plane.viewport_size = {static_cast<float>(viewport[2]), static_cast<float>(viewport[3])};
  return plane;
}

} // namespace foam::rendering
