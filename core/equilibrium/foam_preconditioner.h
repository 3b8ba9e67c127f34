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

#include "algebra/grid_hierarchy.h"
#include "algebra/grid_points.h"
#include "equilibrium/matrix_free.h"
#include "geometry/bounds.h"

namespace foam::newton {

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
    return mesh.freedom(junction).of(sum);
  }

  FOAM_HOST_DEVICE multigrid::Symmetric2 diagonal(Junction junction) const {
    const ConstFoamView& mesh = matrix.mesh;
    multigrid::Symmetric2 sum;
    if (!mesh.moves(junction)) {
      return sum;
    }
    const std::array<Half, 3>& halves = mesh.junction_half[junction];
    for (std::size_t k = 0; k < 3; ++k) {
      const Half h = halves[k];
      const Half next = halves[(k + 1) % 3];
      sum.add_square(across[h.film()], 1);
      if (const Bubble bubble = mesh.left(h); !bubble.is_outside()) {
        sum.add_square(matrix.film[h.film()].start_slope(h) -
                           matrix.film[next.film()].start_slope(next),
                       bulk[bubble]);
      }
    }
    if (const Freedom freedom = mesh.freedom(junction); mesh.on_wall(junction)) {
      const double along = dot(freedom.tangent(), sum * freedom.tangent());
      return {along, 0, along};
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

/// The rows of a cell's element that belong to a corner: the continuum there has half of the films
/// of each of its junctions, and an equal share of each of the bubbles, as if the gradient of the
/// displacement were the same all over them.
FOAM_HOST_DEVICE inline multigrid::ElementRows rows_of(const Solid& solid, const Units& units,
                                                       const multigrid::CellLists& lists,
                                                       Index cell, int corner) {
  const ConstFoamView& mesh = solid.matrix.mesh;
  multigrid::ElementRows sum;
  lists.for_each_in(cell, [&](Index junction) {
    const multigrid::GridPlace& place = lists.place[junction];
    for (const Half h : mesh.junction_half[Junction(junction)]) {
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

/// On an executor (parallel/host.h).
template <class Executor> class FoamPreconditioner {
public:
  explicit FoamPreconditioner(Executor& executor)
      : executor_(executor), junctions_(executor), grids_(executor) {}

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
    find_largest(executor_, solid_, fine_);
    const Lattice cell = cell_of(units);
    const multigrid::Grid grid =
        multigrid::grid_over(cell, mesh.surroundings.periodic(), cell_width(cell));
    place_junctions(grid, units);
    assemble_elements(units, grids_.begin(grid));
    grids_.coarsen();
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
      junctions_.restrict_to_nodes(residual, grids_.load());
      junctions_.prolongate_to_points(grids_.solve(), to);
      keep_to_walls(to);
    });
  }

  // Its parts.

  void keep_to_walls(double* moved) {
    const ConstFoamView& mesh = solid_.matrix.mesh;
    if (mesh.surroundings.has_walls()) {
      executor_.for_each(
          mesh.junction_slots(), FOAM_KERNEL(Junction j) {
            if (mesh.moves(j)) {
              set_displacement(moved, j, mesh.freedom(j).of(displacement(moved, j)));
            }
          });
    }
  }

  void place_junctions(const multigrid::Grid& grid, const Units& units) {
    const ConstFoamView& mesh = solid_.matrix.mesh;
    junctions_.place(
        grid, mesh.junctions, FOAM_KERNEL(Index i) {
          const Junction j(i);
          return mesh.moves(j) ? place_in(grid, (1 / units.length) * mesh.position[j])
                               : multigrid::GridPlace{kNone, {}};
        });
  }

  void assemble_elements(const Units& units, multigrid::Element* element) {
    const Solid& solid = solid_;
    const multigrid::CellLists cells = junctions_.lists();
    executor_.for_each(
        4 * cells.grid.cells(), FOAM_KERNEL(Index i) {
          rows_of(solid, units, cells, i / 4, i % 4).write(element[i / 4], i % 4);
        });
  }

  /// The cell of a torus, or what encloses the junctions, in units of the mean spacing.
  Lattice cell_of(const Units& units) {
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

  static constexpr double kCellWidth = 2;  // of the finest grid, in bubbles
  static constexpr double kMostCells = 16; // for each junction

  /// Of the finest grid: wider where a foam has flown apart on a way that leads nowhere.
  double cell_width(const Lattice& cell) const {
    const double most = kMostCells * solid_.matrix.mesh.junctions;
    return std::max({kCellWidth, std::sqrt(cell.area() / most),
                     std::max(norm(cell.first), norm(cell.second)) / most});
  }

  Executor& executor_;
  Solid solid_;
  Array<Vec2> across_;
  Array<double> bulk_, squeeze_, pressure_;
  multigrid::Smoother<Executor> fine_;
  multigrid::GridPoints<Executor> junctions_;
  multigrid::GridHierarchy<Executor> grids_;
};

} // namespace foam::newton
