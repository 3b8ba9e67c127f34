// SPDX-License-Identifier: GPL-3.0-or-later
//
// Points in a grid, and how their displacements and its nodes' make each other.
#pragma once

#include <cstdint>

#include "algebra/elastic_grid.h"
#include "parallel/kernels.h"

namespace foam::multigrid {

/// Points by the cells of a grid.
struct CellLists {
  Grid grid;
  const GridPlace* place = nullptr;   ///< by point; its cell is kNone where the point is left out
  const std::uint64_t* key = nullptr; ///< cell and point, ascending
  const Index* first = nullptr;       ///< key of each cell

  /// Calls visit(point) for all points in a cell.
  template <class Visit> FOAM_HOST_DEVICE void for_each_in(Index cell, Visit&& visit) const {
    for (Index i = first[cell]; i < first[cell + 1]; ++i) {
      visit(static_cast<Index>(key[i] & 0xffffffffU));
    }
  }
};

/// The first of some ascending keys that is not below a cell's.
FOAM_HOST_DEVICE inline Index first_key(const std::uint64_t* key, Index keys, Index cell) {
  const auto lowest = static_cast<std::uint64_t>(cell) << 32;
  Index low = 0;
  Index high = keys;
  while (low < high) {
    const Index middle = low + (high - low) / 2;
    (key[middle] < lowest ? low : high) = key[middle] < lowest ? middle + 1 : middle;
  }
  return low;
}

/// On an executor (parallel/host.h).
template <class Executor> class GridPoints {
public:
  explicit GridPoints(Executor& executor) : executor_(executor) {}

  /// Sorts points by the cells of a grid. \param place_of_point place_of_point(point) is where a
  /// point lies; its cell is kNone if it is to be left out.
  template <class PlaceOfPoint>
  void place(const Grid& grid, Index points, const PlaceOfPoint& place_of_point) {
    grid_ = grid;
    points_ = points;
    place_.resize(place_of(points));
    key_.resize(place_of(points));
    first_.resize(place_of(grid.cells()) + 1);
    GridPlace* const place = place_.data();
    std::uint64_t* const key = key_.data();
    Index* const first = first_.data();
    executor_.for_each(
        points, FOAM_KERNEL(Index point) {
          place[point] = place_of_point(point);
          const Index cell = place[point].cell;
          key[point] = (static_cast<std::uint64_t>(cell == kNone ? grid.cells() : cell) << 32) |
                       static_cast<std::uint32_t>(point);
        });
    executor_.sort(key, points);
    executor_.for_each(
        grid.cells() + 1, FOAM_KERNEL(Index cell) { first[cell] = first_key(key, points, cell); });
  }

  CellLists lists() const { return {grid_, place_.data(), key_.data(), first_.data()}; }

  /// nodes ← what each node gathers of the points around it: the transpose of
  /// prolongate_to_points().
  void restrict_to_nodes(const double* points, double* nodes) {
    const CellLists cells = lists();
    executor_.for_each(
        grid_.nodes(), FOAM_KERNEL(Index node) {
          Vec2 sum;
          for (int corner = 0; corner < 4; ++corner) {
            const Index cell = cells.grid.cell_at(node, corner);
            if (cell != kNone) {
              cells.for_each_in(cell, [&](Index point) {
                sum += cells.place[point].weight(corner) * displacement(points, point);
              });
            }
          }
          set_displacement(nodes, node, sum);
        });
  }

  /// points ← points + what the nodes have there.
  void prolongate_to_points(const double* nodes, double* points) {
    const CellLists cells = lists();
    executor_.for_each(
        points_, FOAM_KERNEL(Index point) {
          if (cells.place[point].cell != kNone) {
            const Vec2 v = interpolate(cells.grid, nodes, cells.place[point]);
            set_displacement(points, point, displacement(points, point) + v);
          }
        });
  }

private:
  template <class T> using Array = typename Executor::template Array<T>;

  Executor& executor_;
  Grid grid_;
  Index points_ = 0;
  Array<GridPlace> place_;
  Array<std::uint64_t> key_;
  Array<Index> first_;
};

} // namespace foam::multigrid
