// SPDX-License-Identifier: GPL-3.0-or-later
//
// A preconditioner for Newton's equations (matrix_free.h) with which the number of iterations
// does not grow with the foam.
//
// Newton's matrix is K = [A Bᵀ; B −C], with B the gradients of −(A − A^τ). A is highly singular:
// straight films cost nothing to stretch or shorten as long as they meet at 120°, so that bubbles
// can swell against each other. With compressible bubbles, A + BᵀWB, it is an ordinary elastic
// solid, and
//
//   P = [A + BᵀWB  0; 0  W⁻¹ + diag C]
//
// leaves K few distinct eigenvalues (C. Greif, D. Schötzau, Electron. Trans. Numer. Anal. 22, 114,
// 2006). W is the bulk modulus of a gas, T/√A, over the bubble's area. Of A, P has what is positive
// semidefinite wherever the foam is: the films' resistance to being turned.
//
// The solid's inverse is replaced by one symmetric V-cycle: Chebyshev's iteration for the junctions
// (each one's 2 × 2 block is inverted), then for grids two and more bubbles wide
// (algebra/elastic_grid.h), onto which the foam's stiffness is taken junction by junction, as that
// of a continuum.
#pragma once

#include <cstdint>
#include <vector>

#include "algebra/elastic_grid.h"
#include "algebra/multigrid.h"
#include "equilibrium/matrix_free.h"

namespace foam::newton {

/// How a bubble's area grows with its junction between halves k and k + 1 of it.
FOAM_HOST_DEVICE inline Vec2 area_slope(const WholeFoamMatrix& matrix,
                                        const std::array<Half, 3>& halves, std::size_t k) {
  const Half h = halves[k];
  const Half next = halves[(k + 1) % 3];
  return matrix.film[h.film()].start_slope(h) - matrix.film[next.film()].start_slope(next);
}

/// The solid A + BᵀWB.
struct Solid {
  using Place = Junction; ///< of a row

  WholeFoamMatrix matrix;
  FieldView<Film, const Vec2> across;
  FieldView<Bubble, const double> bulk;
  FieldView<Bubble, double> squeeze; ///< WB·x of what row() is asked for

  FOAM_HOST_DEVICE double squeeze_of(Bubble bubble) const {
    return bubble.is_outside() ? 0 : squeeze[bubble];
  }

  FOAM_HOST_DEVICE Vec2 row(const double* x, Junction junction) const {
    const ConstFoamView& mesh = matrix.mesh;
    Vec2 sum;
    if (!mesh.moves(junction)) {
      return sum;
    }
    const Vec2 own = displacement(x, junction);
    for (const Half h : mesh.junction_half[junction]) {
      const Film f = h.film();
      sum += dot(across[f], own - displacement(x, mesh.end(h))) * across[f] +
             (squeeze_of(mesh.left(h)) - squeeze_of(mesh.right(h))) * matrix.film[f].start_slope(h);
    }
    return sum;
  }

  FOAM_HOST_DEVICE multigrid::Symmetric2 diagonal(Junction junction) const {
    const ConstFoamView& mesh = matrix.mesh;
    multigrid::Symmetric2 sum;
    if (!mesh.moves(junction)) {
      return sum;
    }
    const std::array<Half, 3>& halves = mesh.junction_half[junction];
    for (std::size_t k = 0; k < 3; ++k) {
      sum.add_square(across[halves[k].film()], 1);
      const Bubble bubble = mesh.left(halves[k]);
      if (!bubble.is_outside()) {
        sum.add_square(area_slope(matrix, halves, k), bulk[bubble]);
      }
    }
    return sum;
  }
};

/// squeeze ← WB·x
template <class Executor> void before_row(Executor& executor, const Solid& solid, const double* x) {
  executor.for_each(
      solid.matrix.mesh.bubble_slots(), FOAM_KERNEL(Bubble b) {
        const ConstFoamView& mesh = solid.matrix.mesh;
        double growth = 0;
        if (mesh.has_bubble(b)) {
          for_each_half(mesh, b, [&](Half h) {
            const FilmStiffness& f = solid.matrix.film[h.film()];
            growth += dot(f.start_slope(h), displacement(x, mesh.start(h))) +
                      dot(f.end_slope(h), displacement(x, mesh.end(h)));
          });
        }
        solid.squeeze[b] = solid.bulk[b] * growth;
      });
}

/// W of a bubble.
FOAM_HOST_DEVICE inline double bulk_of(const ConstFoamView& mesh, const Units& units,
                                       Bubble bubble) {
  const double area =
      mesh.has_bubble(bubble) ? std::max(mesh.area(bubble), mesh.target_area[bubble]) : 0;
  const double size = std::sqrt(area) / units.length;
  return area > 0 ? 1 / (size * size * size) : 0;
}

/// A film's resistance to being turned is (across·ΔD)².
FOAM_HOST_DEVICE inline Vec2 across_of(const ConstFoamView& mesh, const Units& units, Film film) {
  if (!mesh.bends(film)) {
    return {};
  }
  const Vec2 chord = (1 / units.length) * mesh.chord(film.half());
  const double d = norm(chord);
  return (std::sqrt(mesh.relative_tension(film)) / (d * std::sqrt(d))) * left_normal(chord);
}

/// The pressure's block of P, inverted.
FOAM_HOST_DEVICE inline double inverse_pressure_block(const Solid& solid, Bubble bubble) {
  if (solid.bulk[bubble] == 0) {
    return 0;
  }
  double compliance = 0;
  for_each_half(solid.matrix.mesh, bubble,
                [&](Half h) { compliance += std::abs(solid.matrix.film[h.film()].compliance); });
  return 1 / (1 / solid.bulk[bubble] + compliance);
}

/// Junctions by cells.
struct CellLists {
  multigrid::Grid grid;
  FieldView<Junction, const multigrid::GridPlace> place;
  const std::uint64_t* key = nullptr;
  const Index* first = nullptr;

  template <class Visit> FOAM_HOST_DEVICE void for_each_in(Index cell, Visit&& visit) const {
    for (Index i = first[cell]; i < first[cell + 1]; ++i) {
      visit(Junction(static_cast<Index>(key[i] & 0xffffffffU)));
    }
  }
};

/// The rows of a cell's element that belong to a corner: the continuum there has half of the films
/// of each of its junctions, and an equal share of each of the bubbles, as if the gradient of the
/// displacement were the same all over them.
FOAM_HOST_DEVICE inline multigrid::ElementRows
rows_of(const Solid& solid, const Units& units, const CellLists& lists, Index cell, int corner) {
  const ConstFoamView& mesh = solid.matrix.mesh;
  multigrid::ElementRows sum;
  lists.for_each_in(cell, [&](Junction junction) {
    const multigrid::GridPlace& place = lists.place[junction];
    for (const Half h : mesh.junction_half[junction]) {
      const Vec2 across = solid.across[h.film()];
      const Vec2 chord = (1 / units.length) * mesh.chord(h);
      sum.add_square(place, lists.grid, corner, across.x * chord, across.y * chord, 0.5);
      const Bubble bubble = mesh.left(h);
      if (!bubble.is_outside()) {
        const double area = mesh.area(bubble) / units.area();
        sum.add_square(place, lists.grid, corner, {1, 0}, {0, 1},
                       solid.bulk[bubble] * area * area / mesh.sides[bubble]);
      }
    }
  });
  return sum;
}

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

struct Bounds {
  Vec2 low{1e300, 1e300};
  Vec2 high{-1e300, -1e300};

  friend FOAM_HOST_DEVICE Bounds operator+(const Bounds& a, const Bounds& b) {
    return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
            {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
  }
};

/// A grid over a cell with cells as wide as asked for, or a little less or more: so many that they
/// can be halved until less than eight are left along the shorter side.
inline multigrid::Grid grid_over(const Lattice& box, bool wraps, double width) {
  const double across = norm(box.first);
  const double along = norm(box.second);
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
  return {columns, rows, wraps, box.origin, (1.0 / columns) * box.first, (1.0 / rows) * box.second};
}

/// On an executor (parallel/host.h).
template <class Executor> class FoamPreconditioner {
public:
  explicit FoamPreconditioner(Executor& executor) : executor_(executor) {}

  /// Makes the preconditioner for a state of the foam; both the mesh and the matrix's films have to
  /// stay as they are while it is used.
  void set_up(const WholeFoamMatrix& matrix, const Units& units) {
    const ConstFoamView& mesh = matrix.mesh;
    across_.resize(place_of(mesh.films));
    for (auto* array : {&bulk_, &squeeze_, &pressure_}) {
      array->resize(place_of(mesh.bubbles));
    }
    const FieldView<Film, Vec2> across(across_.data());
    const FieldView<Bubble, double> bulk(bulk_.data());
    const FieldView<Bubble, double> pressure(pressure_.data());
    const Solid solid{matrix, FieldView<Film, const Vec2>(across_.data()),
                      FieldView<Bubble, const double>(bulk_.data()),
                      FieldView<Bubble, double>(squeeze_.data())};
    executor_.for_each(
        mesh.film_slots(), FOAM_KERNEL(Film f) { across[f] = across_of(mesh, units, f); });
    executor_.for_each(
        mesh.bubble_slots(), FOAM_KERNEL(Bubble b) { bulk[b] = bulk_of(mesh, units, b); });
    executor_.for_each(
        mesh.bubble_slots(),
        FOAM_KERNEL(Bubble b) { pressure[b] = inverse_pressure_block(solid, b); });
    solid_ = solid;
    prepare(executor_, solid_, fine_, mesh.junctions);
    find_largest_of(solid_, fine_);
    make_grids(units);
  }

  /// to ← P⁻¹·from
  void apply(const double* from, double* to) {
    const ConstFoamView& mesh = solid_.matrix.mesh;
    const FieldView<Bubble, const double> inverse(pressure_.data());
    const FieldView<Bubble, const double> right = pressures_of(mesh, from);
    const FieldView<Bubble, double> left = pressures_of(mesh, to);
    executor_.for_each(
        mesh.bubble_slots(), FOAM_KERNEL(Bubble b) { left[b] = inverse[b] * right[b]; });
    cycle(executor_, solid_, fine_, from, to, [&](const double* residual) {
      restrict_junctions(residual);
      solve_on(0);
      prolongate_to_junctions(to);
    });
  }

  // Its parts.

  /// Each node gathers the residuals of the junctions around it.
  void restrict_junctions(const double* from) {
    const CellLists cells = lists();
    double* const to = levels_.front().b.data();
    executor_.for_each(
        cells.grid.nodes(), FOAM_KERNEL(Index node) {
          Vec2 sum;
          for (int corner = 0; corner < 4; ++corner) {
            const Index cell = cells.grid.cell_at(node, corner);
            if (cell != kNone) {
              cells.for_each_in(cell, [&](Junction j) {
                sum += cells.place[j].weight(corner) * displacement(from, j);
              });
            }
          }
          set_displacement(to, node, sum);
        });
  }

  void prolongate_to_junctions(double* x) {
    const ConstFoamView& mesh = solid_.matrix.mesh;
    const CellLists cells = lists();
    const double* const from = levels_.front().x.data();
    executor_.for_each(
        mesh.junction_slots(), FOAM_KERNEL(Junction j) {
          if (mesh.moves(j)) {
            set_displacement(x, j,
                             displacement(x, j) + interpolate(cells.grid, from, cells.place[j]));
          }
        });
  }

  /// Sorts the junctions by the cells of the finest grid.
  void place_junctions(const multigrid::Grid& grid, const Units& units) {
    const ConstFoamView& mesh = solid_.matrix.mesh;
    place_.resize(place_of(mesh.junctions));
    key_.resize(place_of(mesh.junctions));
    first_.resize(place_of(grid.cells()) + 1);
    const FieldView<Junction, multigrid::GridPlace> place(place_.data());
    std::uint64_t* const key = key_.data();
    Index* const first = first_.data();
    executor_.for_each(
        mesh.junction_slots(), FOAM_KERNEL(Junction j) {
          const bool counts = mesh.moves(j);
          if (counts) {
            place[j] = place_in(grid, (1 / units.length) * mesh.position[j]);
          }
          const auto cell = static_cast<std::uint64_t>(counts ? place[j].cell : grid.cells());
          key[j.index()] = (cell << 32) | static_cast<std::uint32_t>(j.index());
        });
    executor_.sort(key, mesh.junctions);
    const Index keys = mesh.junctions;
    executor_.for_each(
        grid.cells() + 1, FOAM_KERNEL(Index cell) { first[cell] = first_key(key, keys, cell); });
  }

  void assemble_elements(const Units& units, multigrid::Element* element) {
    const Solid& solid = solid_;
    const CellLists cells = lists();
    executor_.for_each(
        4 * cells.grid.cells(), FOAM_KERNEL(Index i) {
          rows_of(solid, units, cells, i / 4, i % 4).write(element[i / 4], i % 4);
        });
  }

  /// The cell of a torus, or what encloses the junctions, in units of the mean spacing.
  Lattice box_of(const Units& units) {
    const ConstFoamView& mesh = solid_.matrix.mesh;
    Lattice box;
    if (mesh.surroundings.periodic()) {
      box = reduced(mesh.surroundings.lattice).lattice;
    } else {
      const Bounds bounds = executor_.reduce(
          mesh.junction_slots(), Bounds{},
          FOAM_KERNEL(Junction j) {
            return mesh.has_junction(j) ? Bounds{mesh.position[j], mesh.position[j]} : Bounds{};
          },
          parallel::Add{});
      const double margin = 0.5 * units.length;
      box = Lattice::rectangle(bounds.low.x - margin, bounds.high.x + margin, bounds.low.y - margin,
                               bounds.high.y + margin);
    }
    const double scale = 1 / units.length;
    return {scale * box.origin, scale * box.first, scale * box.second};
  }

private:
  template <class T> using Array = typename Executor::template Array<T>;

  struct Level {
    multigrid::Grid grid;
    Array<multigrid::Element> element;
    multigrid::Smoother<Executor> smoother;
    Array<double> b, x;

    multigrid::GridMatrix matrix() const { return {grid, element.data()}; }
  };

  static constexpr double kCellWidth = 2;  // of the finest grid, in bubbles
  static constexpr double kMostCells = 16; // for each junction
  static constexpr int kCoarsestSteps = 16;
  static constexpr double kCoarsestRatio = 80;
  /// An element's matrix is at most four times its corners' own blocks (Cauchy and Schwarz), and so
  /// is their sum. So many steps would go astray where an eigenvalue was beyond an estimate.
  static constexpr double kLargestOfElements = 4;

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

  template <class Matrix>
  void find_largest_of(const Matrix& matrix, multigrid::Smoother<Executor>& smoother) {
    for (auto* array : {&trial_, &zero_}) {
      array->resize(std::max(array->size(), 2 * place_of(smoother.size)));
    }
    find_largest(executor_, matrix, smoother, trial_.data(), zero_.data());
  }

  CellLists lists() const {
    return {levels_.front().grid, FieldView<Junction, const multigrid::GridPlace>(place_.data()),
            key_.data(), first_.data()};
  }

  Level& use_level(const multigrid::Grid& grid) {
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

  /// Of the finest grid: wider where a foam has flown apart on a way that leads nowhere.
  double cell_width(const Lattice& box) const {
    const double junctions = solid_.matrix.mesh.junctions;
    return std::max({kCellWidth, std::sqrt(box.area() / (kMostCells * junctions)),
                     std::max(norm(box.first), norm(box.second)) / (kMostCells * junctions)});
  }

  void make_grids(const Units& units) {
    const Lattice box = box_of(units);
    const multigrid::Grid finest =
        grid_over(box, solid_.matrix.mesh.surroundings.periodic(), cell_width(box));
    place_junctions(finest, units);
    used_ = 0;
    Level& first = use_level(finest);
    assemble_elements(units, first.element.data());
    prepare(executor_, first.matrix(), first.smoother, finest.nodes());
    while (levels_[used_ - 1].grid.can_be_coarsened()) {
      const multigrid::Grid grid = levels_[used_ - 1].grid.coarsened();
      Level& coarse = use_level(grid);
      Level& fine = levels_[used_ - 2];
      find_largest_of(fine.matrix(), fine.smoother);
      coarsen_elements(executor_, fine.grid, grid, fine.element.data(), coarse.element.data());
      prepare(executor_, coarse.matrix(), coarse.smoother, grid.nodes());
    }
    levels_[used_ - 1].smoother.largest = kLargestOfElements;
  }

  Executor& executor_;
  Solid solid_;
  Array<Vec2> across_;
  Array<double> bulk_, squeeze_, pressure_;
  multigrid::Smoother<Executor> fine_;
  Array<multigrid::GridPlace> place_;
  Array<std::uint64_t> key_; ///< cell and junction, ascending
  Array<Index> first_;       ///< key of each cell
  std::vector<Level> levels_;
  std::size_t used_ = 0; ///< of the levels
  Array<double> trial_, zero_;
};

} // namespace foam::newton
