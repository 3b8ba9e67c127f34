// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <vector>

#include "algebra/multigrid.h"

namespace foam::multigrid {

/// An elastic continuum on a grid and on coarser and coarser ones, on an executor
/// (parallel/host.h): its displacements under a load are found to within the accuracy of one
/// symmetric V-cycle.
template <class Executor> class GridHierarchy {
public:
  explicit GridHierarchy(Executor& executor) : executor_(executor) {}

  /// Begins anew. \returns the finest grid's elements, which are to be filled in before coarsen().
  Element* begin(const Grid& finest) {
    used_ = 0;
    return use_level(finest).element.data();
  }

  /// Makes the coarser grids of the finest.
  void coarsen() {
    prepare_level(levels_.front());
    while (levels_[used_ - 1].grid.can_be_coarsened()) {
      Level& coarse = use_level(levels_[used_ - 1].grid.coarsened());
      Level& fine = levels_[used_ - 2];
      find_largest(executor_, fine.matrix(), fine.smoother);
      coarsen_elements(executor_, fine.grid, coarse.grid, fine.element.data(),
                       coarse.element.data());
      prepare_level(coarse);
    }
    levels_[used_ - 1].smoother.largest = kLargestOfElements;
  }

  /// On the nodes of the finest grid.
  double* load() { return levels_.front().b.data(); }
  /// Displacements under load(). \returns those of the nodes of the finest grid.
  const double* solve() {
    solve_on(0);
    return levels_.front().x.data();
  }

private:
  template <class T> using Array = typename Executor::template Array<T>;

  struct Level {
    Grid grid;
    Array<Element> element;
    Smoother<Executor> smoother;
    Array<double> b, x;

    GridMatrix matrix() const { return {grid, element.data()}; }
  };

  static constexpr int kCoarsestSteps = 16;
  static constexpr double kCoarsestRatio = 80;
  /// An element's matrix is at most four times its corners' own blocks (Cauchy and Schwarz), and so
  /// is their sum. So many steps would go astray where an eigenvalue was beyond an estimate.
  static constexpr double kLargestOfElements = 4;

  Level& use_level(const Grid& grid) {
    if (used_ == levels_.size()) {
      levels_.emplace_back();
    }
    Level& level = levels_[used_++];
    level.grid = grid;
    level.element.resize(place_of(grid.cells()));
    level.b.resize(2 * place_of(grid.nodes()));
    level.x.resize(2 * place_of(grid.nodes()));
    return level;
  }

  void prepare_level(Level& level) {
    prepare(executor_, level.matrix(), level.smoother, level.grid.nodes());
  }

  void solve_on(std::size_t k) {
    Level& level = levels_[k];
    if (k + 1 == used_) {
      smooth(executor_, level.matrix(), level.smoother, level.b.data(), level.x.data(), true,
             kCoarsestSteps, kCoarsestRatio);
      return;
    }
    Level& coarser = levels_[k + 1];
    cycle(executor_, level.matrix(), level.smoother, level.b.data(), level.x.data(),
          [&](const double* residual) {
            restrict_to(executor_, coarser.grid, level.grid, residual, coarser.b.data());
            solve_on(k + 1);
            prolongate(executor_, level.grid, coarser.grid, coarser.x.data(), level.x.data());
          });
  }

  Executor& executor_;
  std::vector<Level> levels_; ///< the finest first
  std::size_t used_ = 0;      ///< of them
};

} // namespace foam::multigrid
