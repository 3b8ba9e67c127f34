// SPDX-License-Identifier: GPL-3.0-or-later
//
// A foam seen from afar: an elastic continuum in bilinear finite elements on a regular grid, for
// the corrections on a large scale (equilibrium/foam_preconditioner.h). Each grid is coarsened to
// one with half as many cells along x and y, whose elements are exactly what the finer ones give
// (Galerkin), as the spaces are nested: all that is kept is the cells' matrices.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "equilibrium/displacements.h"
#include "geometry/vec2.h"
#include "mesh/elements.h"

namespace foam::newton {

/// A symmetric 2 × 2 matrix.
struct Symmetric2 {
  double xx = 0, xy = 0, yy = 0;

  FOAM_HOST_DEVICE Vec2 operator*(Vec2 v) const {
    return {xx * v.x + xy * v.y, xy * v.x + yy * v.y};
  }
  FOAM_HOST_DEVICE void add_square(Vec2 v, double weight) {
    xx += weight * v.x * v.x;
    xy += weight * v.x * v.y;
    yy += weight * v.y * v.y;
  }
  /// Zero where there is no inverse to speak of.
  FOAM_HOST_DEVICE Symmetric2 inverse() const {
    const double determinant = xx * yy - xy * xy;
    if (!(determinant > 1e-12 * (xx + yy) * (xx + yy))) {
      return {};
    }
    return {yy / determinant, -xy / determinant, xx / determinant};
  }
};

/// A rectangle of square-like cells, on a torus or not. Lengths in units of the bubbles' spacing.
struct Grid {
  Index columns = 1, rows = 1; ///< of cells
  bool wraps = false;
  Vec2 origin; ///< the lower left corner
  Vec2 cell;   ///< width and height of a cell

  FOAM_HOST_DEVICE Index cells() const { return columns * rows; }
  FOAM_HOST_DEVICE Index nodes_across() const { return wraps ? columns : columns + 1; }
  FOAM_HOST_DEVICE Index nodes_along() const { return wraps ? rows : rows + 1; }
  FOAM_HOST_DEVICE Index nodes() const { return nodes_across() * nodes_along(); }
  /// Corner k of a cell: 0 lower left, 1 lower right, 2 upper left, 3 upper right.
  FOAM_HOST_DEVICE Index node(Index cell_number, int corner) const {
    const Index i = (cell_number % columns + (corner & 1)) % nodes_across();
    const Index j = (cell_number / columns + (corner >> 1)) % nodes_along();
    return i + nodes_across() * j;
  }
  /// The cell whose corner k is the node; kNone beyond the rim.
  FOAM_HOST_DEVICE Index cell_at(Index node_number, int corner) const {
    Index i = node_number % nodes_across() - (corner & 1);
    Index j = node_number / nodes_across() - (corner >> 1);
    if (wraps) {
      i = (i + columns) % columns;
      j = (j + rows) % rows;
    }
    return i < 0 || i >= columns || j < 0 || j >= rows ? kNone : i + columns * j;
  }

  /// Into one with at least two cells along x and y: the only move of a torus with one node is a
  /// translation, which meets no resistance.
  bool can_be_coarsened() const {
    return columns % 2 == 0 && rows % 2 == 0 && std::min(columns, rows) >= 4;
  }
  Grid coarsened() const { return {columns / 2, rows / 2, wraps, origin, 2 * cell}; }
};

/// A place in a grid: its cell, and where in it, from 0 to 1 along x and y.
struct GridPlace {
  Index cell = 0;
  Vec2 at;

  /// The bilinear shape function of the cell's corner k.
  FOAM_HOST_DEVICE double weight(int corner) const {
    return ((corner & 1) ? at.x : 1 - at.x) * ((corner >> 1) ? at.y : 1 - at.y);
  }
  /// Its gradient.
  FOAM_HOST_DEVICE Vec2 gradient(int corner, Vec2 size) const {
    const double wx = (corner & 1) ? at.x : 1 - at.x;
    const double wy = (corner >> 1) ? at.y : 1 - at.y;
    return {((corner & 1) ? wy : -wy) / size.x, ((corner >> 1) ? wx : -wx) / size.y};
  }
};

FOAM_HOST_DEVICE inline GridPlace place_in(const Grid& grid, Vec2 position) {
  const double x = (position.x - grid.origin.x) / grid.cell.x;
  const double y = (position.y - grid.origin.y) / grid.cell.y;
  const auto locate = [&](double along, Index count, double& rest) {
    const double whole = std::floor(along);
    rest = along - whole;
    const double lap = std::floor(whole / count);
    return std::clamp(static_cast<Index>(whole - (grid.wraps ? lap * count : 0)), Index{0},
                      count - 1);
  };
  GridPlace place;
  const Index i = locate(x, grid.columns, place.at.x);
  const Index j = locate(y, grid.rows, place.at.y);
  place.cell = i + grid.columns * j;
  return place;
}

/// The stiffness of a cell's four corners, (x, y) after (x, y).
struct Element {
  std::array<std::array<double, 8>, 8> k{};
};

/// What corner k of a cell has to do with a functional that is linear in the gradient of the
/// displacement, Σ_ik c_ik ∂u_i/∂x_k: its factors of the corner's x and y.
/// \param row_x c_xx, c_xy; \param row_y c_yx, c_yy.
FOAM_HOST_DEVICE inline Vec2 share_of_corner(const GridPlace& place, Vec2 size, int corner,
                                             Vec2 row_x, Vec2 row_y) {
  const Vec2 gradient = place.gradient(corner, size);
  return {dot(row_x, gradient), dot(row_y, gradient)};
}

/// The rows of an element's matrix that belong to one of its corners.
struct ElementRows {
  std::array<std::array<double, 8>, 2> k{};

  /// Adds weight·(functional)².
  FOAM_HOST_DEVICE void add_square(const GridPlace& place, Vec2 size, int corner, Vec2 row_x,
                                   Vec2 row_y, double weight) {
    const Vec2 own = weight * share_of_corner(place, size, corner, row_x, row_y);
    for (int other = 0; other < 4; ++other) {
      const Vec2 value = share_of_corner(place, size, other, row_x, row_y);
      const auto o = 2 * static_cast<std::size_t>(other);
      k[0][o] += own.x * value.x;
      k[0][o + 1] += own.x * value.y;
      k[1][o] += own.y * value.x;
      k[1][o + 1] += own.y * value.y;
    }
  }

  FOAM_HOST_DEVICE void write(Element& element, int corner) const {
    const auto c = 2 * static_cast<std::size_t>(corner);
    element.k[c] = k[0];
    element.k[c + 1] = k[1];
  }
};

/// The matrix of a grid: its elements, gathered by nodes.
struct GridMatrix {
  Grid grid;
  const Element* element = nullptr;

  FOAM_HOST_DEVICE Vec2 row(const double* x, Index node) const {
    Vec2 sum;
    for (int corner = 0; corner < 4; ++corner) {
      const Index cell = grid.cell_at(node, corner);
      if (cell == kNone) {
        continue;
      }
      const auto c = 2 * static_cast<std::size_t>(corner);
      const auto& k = element[cell].k;
      for (int other = 0; other < 4; ++other) {
        const Index n = grid.node(cell, other);
        const auto o = 2 * static_cast<std::size_t>(other);
        const Vec2 v = displacement(x, n);
        sum += Vec2{k[c][o] * v.x + k[c][o + 1] * v.y, k[c + 1][o] * v.x + k[c + 1][o + 1] * v.y};
      }
    }
    return sum;
  }

  FOAM_HOST_DEVICE Symmetric2 diagonal(Index node) const {
    Symmetric2 sum;
    for (int corner = 0; corner < 4; ++corner) {
      const Index cell = grid.cell_at(node, corner);
      if (cell != kNone) {
        const auto c = 2 * static_cast<std::size_t>(corner);
        const auto& k = element[cell].k;
        sum.xx += k[c][c];
        sum.xy += k[c][c + 1];
        sum.yy += k[c + 1][c + 1];
      }
    }
    return sum;
  }
};

/// Where in the coarser grid's cell a corner of one of its four cells lies.
FOAM_HOST_DEVICE inline GridPlace corner_in_parent(Index parent, int child, int corner) {
  return {parent, {0.5 * ((child & 1) + (corner & 1)), 0.5 * ((child >> 1) + (corner >> 1))}};
}

/// The elements of the grid that is coarser by one; one index for every pair of an element's
/// corners.
struct CoarsenElement {
  Grid fine, coarse;
  const Element* from = nullptr;
  Element* to = nullptr;

  FOAM_HOST_DEVICE static Index size(const Grid& coarse) { return 16 * coarse.cells(); }

  FOAM_HOST_DEVICE void operator()(Index i) const {
    const Index cell = i / 16;
    const int row = (i / 4) % 4;
    const int column = i % 4;
    double xx = 0, xy = 0, yx = 0, yy = 0;
    for (int child = 0; child < 4; ++child) {
      const Index x = 2 * (cell % coarse.columns) + (child & 1);
      const Index y = 2 * (cell / coarse.columns) + (child >> 1);
      const auto& k = from[x + fine.columns * y].k;
      for (int a = 0; a < 4; ++a) {
        for (int b = 0; b < 4; ++b) {
          const double weight = corner_in_parent(cell, child, a).weight(row) *
                                corner_in_parent(cell, child, b).weight(column);
          const auto r = 2 * static_cast<std::size_t>(a);
          const auto c = 2 * static_cast<std::size_t>(b);
          xx += weight * k[r][c];
          xy += weight * k[r][c + 1];
          yx += weight * k[r + 1][c];
          yy += weight * k[r + 1][c + 1];
        }
      }
    }
    const auto r = 2 * static_cast<std::size_t>(row);
    const auto c = 2 * static_cast<std::size_t>(column);
    to[cell].k[r][c] = xx;
    to[cell].k[r][c + 1] = xy;
    to[cell].k[r + 1][c] = yx;
    to[cell].k[r + 1][c + 1] = yy;
  }
};

/// Where a node lies in the grid that is coarser by one.
FOAM_HOST_DEVICE inline GridPlace place_of_node(const Grid& fine, const Grid& coarse, Index node) {
  const Index i = node % fine.nodes_across();
  const Index j = node / fine.nodes_across();
  const Index column = std::min(i / 2, coarse.columns - 1);
  const Index row = std::min(j / 2, coarse.rows - 1);
  return {column + coarse.columns * row, {0.5 * (i - 2 * column), 0.5 * (j - 2 * row)}};
}

/// x at a place, between the nodes.
FOAM_HOST_DEVICE inline Vec2 interpolate(const Grid& grid, const double* x,
                                         const GridPlace& place) {
  Vec2 sum;
  for (int corner = 0; corner < 4; ++corner) {
    const Index n = grid.node(place.cell, corner);
    sum += place.weight(corner) * displacement(x, n);
  }
  return sum;
}

/// x_fine ← x_fine + what the coarser grid has there.
struct ProlongateGrid {
  Grid fine, coarse;
  const double* from = nullptr;
  double* x = nullptr;

  FOAM_HOST_DEVICE void operator()(Index node) const {
    const Vec2 v = interpolate(coarse, from, place_of_node(fine, coarse, node));
    set_displacement(x, node, displacement(x, node) + v);
  }
};

/// The transpose: a node gathers the residuals of the finer nodes around it.
struct RestrictGrid {
  Grid fine, coarse;
  const double* from = nullptr;
  double* to = nullptr;

  FOAM_HOST_DEVICE void operator()(Index node) const {
    const Index i = 2 * (node % coarse.nodes_across());
    const Index j = 2 * (node / coarse.nodes_across());
    Vec2 sum;
    for (Index dj = -1; dj <= 1; ++dj) {
      for (Index di = -1; di <= 1; ++di) {
        Index x = i + di;
        Index y = j + dj;
        if (fine.wraps) {
          x = (x + fine.columns) % fine.columns;
          y = (y + fine.rows) % fine.rows;
        }
        if (x >= 0 && x < fine.nodes_across() && y >= 0 && y < fine.nodes_along()) {
          const Index n = x + fine.nodes_across() * y;
          sum += (di == 0 ? 1 : 0.5) * (dj == 0 ? 1 : 0.5) * displacement(from, n);
        }
      }
    }
    set_displacement(to, node, sum);
  }
};

} // namespace foam::newton
