// SPDX-License-Identifier: GPL-3.0-or-later
//
// A foam seen from afar: an elastic continuum in bilinear finite elements on a regular grid, for
// the corrections on a large scale (the preconditioner of Newton's equations). Each grid is
// coarsened to one with half as many cells along x and y, whose elements are exactly what the finer
// ones give (Galerkin), as the spaces are nested: all that is kept is the cells' matrices.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

#include "algebra/displacements.h"
#include "geometry/lattice.h"

namespace foam::multigrid {

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

/// A parallelogram of cells, on a torus or not. Lengths in units of the bubbles' spacing.
struct Grid {
  Index columns = 1, rows = 1; ///< of cells
  bool wraps = false;
  Vec2 origin;        ///< the corner of the first cell
  Vec2 across, along; ///< the sides of a cell, counter-clockwise

  FOAM_HOST_DEVICE Index cells() const { return columns * rows; }
  FOAM_HOST_DEVICE Index nodes_across() const { return wraps ? columns : columns + 1; }
  FOAM_HOST_DEVICE Index nodes_along() const { return wraps ? rows : rows + 1; }
  FOAM_HOST_DEVICE Index nodes() const { return nodes_across() * nodes_along(); }
  /// Corner k of a cell: 0 at its origin, 1 across from it, 2 along from it, 3 opposite.
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

  /// Into one with at least two cells either way: the only move of a torus with one node is a
  /// translation, which meets no resistance.
  bool can_be_coarsened() const {
    return columns % 2 == 0 && rows % 2 == 0 && std::min(columns, rows) >= 4;
  }
  Grid coarsened() const { return {columns / 2, rows / 2, wraps, origin, 2 * across, 2 * along}; }
};

/// A grid over a cell, on a torus or not, with cells as wide as asked for, or a little less or
/// more: so many that they can be halved until less than eight are left along the shorter side.
inline Grid grid_over(const Lattice& cell, bool wraps, double width) {
  const double across = norm(cell.first);
  const double along = norm(cell.second);
  Index halvings = 0;
  for (double shorter = std::min(across, along) / width; shorter >= 8; shorter /= 2) {
    ++halvings;
  }
  const auto count = [&](double length) {
    const double cells = length / width / std::exp2(halvings);
    return std::max(Index{2}, static_cast<Index>(std::lround(cells))) << halvings;
  };
  const Index columns = count(across);
  const Index rows = count(along);
  return {
      columns, rows, wraps, cell.origin, (1.0 / columns) * cell.first, (1.0 / rows) * cell.second};
}

/// A place in a grid: its cell, and where in it, from 0 to 1 across and along.
struct GridPlace {
  Index cell = 0;
  Vec2 at;

  /// The bilinear shape function of the cell's corner k.
  FOAM_HOST_DEVICE double weight(int corner) const {
    return ((corner & 1) ? at.x : 1 - at.x) * ((corner >> 1) ? at.y : 1 - at.y);
  }
  /// Its gradient.
  FOAM_HOST_DEVICE Vec2 gradient(int corner, const Grid& grid) const {
    const double wx = (corner & 1) ? at.x : 1 - at.x;
    const double wy = (corner >> 1) ? at.y : 1 - at.y;
    const double by_across = (corner & 1) ? wy : -wy;
    const double by_along = (corner >> 1) ? wx : -wx;
    const double area = cross(grid.across, grid.along);
    return {(by_across * grid.along.y - by_along * grid.across.y) / area,
            (by_along * grid.across.x - by_across * grid.along.x) / area};
  }
};

FOAM_HOST_DEVICE inline GridPlace place_in(const Grid& grid, Vec2 position) {
  const Vec2 r = position - grid.origin;
  const double area = cross(grid.across, grid.along);
  const auto locate = [&](double way, Index count, double& rest) {
    const double whole = std::floor(way);
    rest = way - whole;
    const double lap = std::floor(whole / count);
    return std::clamp(static_cast<Index>(whole - (grid.wraps ? lap * count : 0)), Index{0},
                      count - 1);
  };
  GridPlace place;
  const Index i = locate(cross(r, grid.along) / area, grid.columns, place.at.x);
  const Index j = locate(cross(grid.across, r) / area, grid.rows, place.at.y);
  place.cell = i + grid.columns * j;
  return place;
}

/// The stiffness of a cell's four corners, (x, y) after (x, y).
struct Element {
  std::array<std::array<double, 8>, 8> k{};
};

/// The rows of an element's matrix that belong to one of its corners.
struct ElementRows {
  std::array<std::array<double, 8>, 2> k{};

  /// Adds weight·(Σ_ik c_ik ∂u_i/∂x_k)², the square of a functional that is linear in the gradient
  /// of the displacement. \param row_x c_xx, c_xy; \param row_y c_yx, c_yy.
  FOAM_HOST_DEVICE void add_square(const GridPlace& place, const Grid& grid, int corner, Vec2 row_x,
                                   Vec2 row_y, double weight) {
    const Vec2 slope = place.gradient(corner, grid);
    const Vec2 own{weight * dot(row_x, slope), weight * dot(row_y, slope)};
    for (int other = 0; other < 4; ++other) {
      const Vec2 gradient = place.gradient(other, grid);
      const Vec2 value{dot(row_x, gradient), dot(row_y, gradient)};
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
  using Place = Index; ///< of a row: a node

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

/// What an element of the coarser grid has for corners `row` and `column`: x and y of either.
FOAM_HOST_DEVICE inline std::array<double, 4> coarse_entry(const Grid& fine, const Grid& coarse,
                                                           const Element* from, Index cell, int row,
                                                           int column) {
  std::array<double, 4> sum{}; // xx, xy, yx, yy
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
        sum[0] += weight * k[r][c];
        sum[1] += weight * k[r][c + 1];
        sum[2] += weight * k[r + 1][c];
        sum[3] += weight * k[r + 1][c + 1];
      }
    }
  }
  return sum;
}

/// The elements of the grid that is coarser by one; one index for every pair of an element's
/// corners.
template <class Executor>
void coarsen_elements(Executor& executor, const Grid& fine, const Grid& coarse, const Element* from,
                      Element* to) {
  executor.for_each(
      16 * coarse.cells(), FOAM_KERNEL(Index i) {
        const int row = (i / 4) % 4;
        const int column = i % 4;
        const auto entry = coarse_entry(fine, coarse, from, i / 16, row, column);
        auto& k = to[i / 16].k;
        const auto r = 2 * static_cast<std::size_t>(row);
        const auto c = 2 * static_cast<std::size_t>(column);
        k[r][c] = entry[0];
        k[r][c + 1] = entry[1];
        k[r + 1][c] = entry[2];
        k[r + 1][c + 1] = entry[3];
      });
}

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

/// x ← x + what the coarser grid has there.
template <class Executor>
void prolongate(Executor& executor, const Grid& fine, const Grid& coarse, const double* from,
                double* x) {
  executor.for_each(
      fine.nodes(), FOAM_KERNEL(Index node) {
        const Vec2 v = interpolate(coarse, from, place_of_node(fine, coarse, node));
        set_displacement(x, node, displacement(x, node) + v);
      });
}

/// What a node of the coarser grid gathers of the finer nodes around it: the transpose of
/// prolongate().
FOAM_HOST_DEVICE inline Vec2 gathered(const Grid& fine, const Grid& coarse, const double* from,
                                      Index node) {
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
  return sum;
}

template <class Executor>
void restrict_to(Executor& executor, const Grid& coarse, const Grid& fine, const double* from,
                 double* to) {
  executor.for_each(
      coarse.nodes(),
      FOAM_KERNEL(Index node) { set_displacement(to, node, gathered(fine, coarse, from, node)); });
}

} // namespace foam::multigrid
