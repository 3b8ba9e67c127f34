// SPDX-License-Identifier: GPL-3.0-or-later
//
// The shapes of containers.
#pragma once

#include <optional>
#include <span>
#include <vector>

#include "mesh/foam.h"

namespace foam {

/// Walls with the foam on their left, the outermost first, and of a channel its period.
struct Container {
  std::vector<Wall> walls;
  double period = 0; ///< along x, cm; 0 where there is none
};

/// Bounds xmin, xmax, ymin, ymax of containers, cm. All throw a FoamError that names them if they
/// enclose nothing.
struct ContainerBounds {
  double xmin = 0, xmax = 0, ymin = 0, ymax = 0;
};

Container rectangle(const ContainerBounds& bounds, WallContact contact);
/// The largest disc in the bounds, in their middle.
Container disc(const ContainerBounds& bounds, WallContact contact);
/// The same round an obstacle. \param inner_radius of that, cm
Container annulus(const ContainerBounds& bounds, double inner_radius, WallContact contact);
/// Periodic along x, walls along y.
Container channel(const ContainerBounds& bounds, WallContact contact);
/// Of closed polygons, in any order and walked either way: the one that lies in no other is the
/// container, those in it are obstacles. Corners stay corners. \param polygons their vertices, cm,
/// without the first again. \throws FoamError for one that crosses itself or another, that has
/// fewer than three corners, and for an obstacle outside of the container or inside of another
Container outline(std::span<const std::vector<Vec2>> polygons, WallContact contact);

enum class ContainerShape { Rectangle, Disc, Annulus, Channel, Outline };

struct ContainerOptions {
  ContainerShape shape = ContainerShape::Rectangle;
  WallContact contact = WallContact::Slip;
  std::optional<ContainerBounds> bounds;   ///< without any: round the points
  double inner_radius = 1;                 ///< of an annulus, cm
  std::vector<std::vector<Vec2>> outlines; ///< see outline()
};

/// The container for points, which has room for half of their mean spacing beside the outermost
/// where no bounds are given.
Container make_container(const ContainerOptions& options, std::span<const Vec2> points);

/// Whether a point lies inside of the walls.
bool is_inside(const Container& container, Vec2 point);

} // namespace foam
