// SPDX-License-Identifier: GPL-3.0-or-later
//
// A preconditioner for Newton's equations (whole_foam_system.h) with which the number of iterations
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
// (each one's 2 × 2 block is inverted), then for grids two and more bubbles wide (elastic_grid.h),
// onto which the foam's stiffness is taken junction by junction, as that of a continuum.
#pragma once

#include <cstdint>
#include <vector>

#include "equilibrium/elastic_grid.h"
#include "equilibrium/minimal_residual.h"
#include "equilibrium/whole_foam_system.h"
#include "parallel/kernels.h"

namespace foam::newton {
namespace detail {

/// How a bubble's area grows with its junction between halves k and k + 1 of it.
FOAM_HOST_DEVICE inline Vec2 area_slope(const WholeFoamMatrix& matrix,
                                        const std::array<Index, 3>& halves, std::size_t k) {
  const Index h = halves[k];
  const Index next = halves[(k + 1) % 3];
  return matrix.film[FoamView::film_of(h)].start_slope(h) -
         matrix.film[FoamView::film_of(next)].start_slope(next);
}

/// W of a bubble.
struct TakeBulk {
  FoamView mesh;
  Units units;
  double* bulk = nullptr;

  FOAM_HOST_DEVICE void operator()(Index bubble) const {
    const double area =
        mesh.has_bubble(bubble) ? std::max(mesh.area(bubble), mesh.target_area[bubble]) : 0;
    const double size = std::sqrt(area) / units.length;
    bulk[bubble] = area > 0 ? 1 / (size * size * size) : 0;
  }
};

/// The pressure's block of P, inverted.
struct TakePressureBlock {
  WholeFoamMatrix matrix;
  const double* bulk = nullptr;
  double* inverse = nullptr;

  FOAM_HOST_DEVICE void operator()(Index bubble) const {
    if (bulk[bubble] == 0) {
      inverse[bubble] = 0;
      return;
    }
    double compliance = 0;
    for_each_half(matrix.mesh, bubble, [&](Index h) {
      compliance += std::abs(matrix.film[FoamView::film_of(h)].compliance);
    });
    inverse[bubble] = 1 / (1 / bulk[bubble] + compliance);
  }
};

/// A film's resistance to being turned is (across·ΔD)².
struct TakeAcross {
  FoamView mesh;
  Units units;
  Vec2* across = nullptr;

  FOAM_HOST_DEVICE void operator()(Index film) const {
    if (!bends(mesh, film)) {
      across[film] = {};
      return;
    }
    const Vec2 chord = (1 / units.length) * mesh.chord(2 * film);
    const double d = norm(chord);
    across[film] = (1 / (d * std::sqrt(d))) * left_normal(chord);
  }
};

/// The solid A + BᵀWB.
struct Solid {
  WholeFoamMatrix matrix;
  const Vec2* across = nullptr; ///< by film
  const double* bulk = nullptr; ///< by bubble
  double* squeeze = nullptr;    ///< WB·x, by bubble, of what row() is asked for

  FOAM_HOST_DEVICE double squeeze_of(Index bubble) const {
    return bubble == kWorld ? 0 : squeeze[bubble];
  }

  FOAM_HOST_DEVICE Vec2 row(const double* x, Index junction) const {
    const FoamView& mesh = matrix.mesh;
    Vec2 sum;
    if (!moves(mesh, junction)) {
      return sum;
    }
    const Vec2 own = displacement(x, junction);
    for (const Index h : mesh.junction_half[FoamView::size(junction)]) {
      const Index f = FoamView::film_of(h);
      sum += dot(across[f], own - displacement(x, mesh.end(h))) * across[f] +
             (squeeze_of(mesh.left(h)) - squeeze_of(mesh.right(h))) * matrix.film[f].start_slope(h);
    }
    return sum;
  }

  FOAM_HOST_DEVICE Symmetric2 diagonal(Index junction) const {
    const FoamView& mesh = matrix.mesh;
    Symmetric2 sum;
    if (!moves(mesh, junction)) {
      return sum;
    }
    const std::array<Index, 3>& halves = mesh.junction_half[FoamView::size(junction)];
    for (std::size_t k = 0; k < 3; ++k) {
      sum.add_square(across[FoamView::film_of(halves[k])], 1);
      const Index bubble = mesh.left(halves[k]);
      if (bubble != kWorld) {
        sum.add_square(area_slope(matrix, halves, k), bulk[bubble]);
      }
    }
    return sum;
  }
};

/// squeeze ← WB·x
struct Squeeze {
  Solid solid;
  const double* x = nullptr;

  FOAM_HOST_DEVICE void operator()(Index bubble) const {
    const FoamView& mesh = solid.matrix.mesh;
    double growth = 0;
    if (mesh.has_bubble(bubble)) {
      for_each_half(mesh, bubble, [&](Index h) {
        const FilmStiffness& f = solid.matrix.film[FoamView::film_of(h)];
        growth += dot(f.start_slope(h), displacement(x, mesh.start(h))) +
                  dot(f.end_slope(h), displacement(x, mesh.end(h)));
      });
    }
    solid.squeeze[bubble] = solid.bulk[bubble] * growth;
  }
};

template <class Matrix> struct InvertDiagonal {
  Matrix matrix;
  Symmetric2* inverse = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const { inverse[i] = matrix.diagonal(i).inverse(); }
};

/// r ← b − M·x
template <class Matrix> struct SubtractProduct {
  Matrix matrix;
  const double* b = nullptr;
  const double* x = nullptr;
  double* r = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    set_displacement(r, i, displacement(b, i) - matrix.row(x, i));
  }
};

/// d ← by_last·d + by_residual·D⁻¹·r, x ← x + d
struct ChebyshevStep {
  const Symmetric2* inverse = nullptr;
  const double* r = nullptr;
  double by_last = 0, by_residual = 1;
  double* d = nullptr;
  double* x = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    const Vec2 step =
        by_last * displacement(d, i) + by_residual * (inverse[i] * displacement(r, i));
    set_displacement(d, i, step);
    set_displacement(x, i, displacement(x, i) + step);
  }
};

/// Where a junction lies in the grid, and a key to sort junctions by cells.
struct PlaceJunction {
  FoamView mesh;
  Units units;
  Grid grid;
  GridPlace* place = nullptr;
  std::uint64_t* key = nullptr;

  FOAM_HOST_DEVICE void operator()(Index junction) const {
    const bool counts = moves(mesh, junction);
    if (counts) {
      place[junction] = place_in(grid, (1 / units.length) * mesh.position[junction]);
    }
    const auto cell = static_cast<std::uint64_t>(counts ? place[junction].cell : grid.cells());
    key[junction] = (cell << 32) | static_cast<std::uint32_t>(junction);
  }
};

/// The first key of every cell, and one beyond.
struct FindCell {
  const std::uint64_t* key = nullptr;
  Index keys = 0;
  Index* first = nullptr;

  FOAM_HOST_DEVICE void operator()(Index cell) const {
    const auto lowest = static_cast<std::uint64_t>(cell) << 32;
    Index low = 0;
    Index high = keys;
    while (low < high) {
      const Index middle = low + (high - low) / 2;
      (key[middle] < lowest ? low : high) = key[middle] < lowest ? middle + 1 : middle;
    }
    first[cell] = low;
  }
};

/// Junctions by cells.
struct CellLists {
  Grid grid;
  const GridPlace* place = nullptr;
  const std::uint64_t* key = nullptr;
  const Index* first = nullptr;

  template <class Visit> FOAM_HOST_DEVICE void for_each_in(Index cell, Visit&& visit) const {
    for (Index i = first[cell]; i < first[cell + 1]; ++i) {
      visit(static_cast<Index>(key[i] & 0xffffffffU));
    }
  }
};

/// The continuum in a cell: half of the films of each of its junctions, and an equal share of each
/// of the bubbles there, as if the gradient of the displacement were the same all over them. One
/// index for every corner of a cell.
struct AssembleElement {
  Solid solid;
  Units units;
  CellLists lists;
  Element* element = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    const FoamView& mesh = solid.matrix.mesh;
    const Index cell = i / 4;
    const int corner = i % 4;
    ElementRows sum;
    lists.for_each_in(cell, [&](Index junction) {
      const GridPlace& place = lists.place[junction];
      for (const Index h : mesh.junction_half[FoamView::size(junction)]) {
        const Vec2 across = solid.across[FoamView::film_of(h)];
        const Vec2 chord = (1 / units.length) * mesh.chord(h);
        sum.add_square(place, lists.grid.cell, corner, across.x * chord, across.y * chord, 0.5);
        const Index bubble = mesh.left(h);
        if (bubble != kWorld) {
          const double area = mesh.area(bubble) / (units.length * units.length);
          sum.add_square(place, lists.grid.cell, corner, {1, 0}, {0, 1},
                         solid.bulk[bubble] * area * area / mesh.sides[bubble]);
        }
      }
    });
    sum.write(element[cell], corner);
  }
};

/// A node gathers the residuals of the junctions around it.
struct RestrictJunctions {
  CellLists lists;
  const double* from = nullptr;
  double* to = nullptr;

  FOAM_HOST_DEVICE void operator()(Index node) const {
    Vec2 sum;
    for (int corner = 0; corner < 4; ++corner) {
      const Index cell = lists.grid.cell_at(node, corner);
      if (cell != kNone) {
        lists.for_each_in(cell, [&](Index junction) {
          sum += lists.place[junction].weight(corner) * displacement(from, junction);
        });
      }
    }
    set_displacement(to, node, sum);
  }
};

struct ProlongateToJunctions {
  FoamView mesh;
  Grid grid;
  const GridPlace* place = nullptr;
  const double* from = nullptr;
  double* x = nullptr;

  FOAM_HOST_DEVICE void operator()(Index junction) const {
    if (moves(mesh, junction)) {
      set_displacement(x, junction,
                       displacement(x, junction) + interpolate(grid, from, place[junction]));
    }
  }
};

struct ScalePressure {
  FoamView mesh;
  const double* inverse = nullptr;
  const double* from = nullptr;
  double* to = nullptr;

  FOAM_HOST_DEVICE void operator()(Index bubble) const {
    const Index i = 2 * mesh.junctions + bubble;
    to[i] = inverse[bubble] * from[i];
  }
};

/// Something other than zero everywhere, and smooth nowhere.
struct FillRoughly {
  double* x = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    x[i] = static_cast<double>((static_cast<std::uint32_t>(i) * 2654435761U) >> 8) / 0x1p24 - 0.5;
  }
};

struct Bounds {
  Vec2 low{1e300, 1e300};
  Vec2 high{-1e300, -1e300};
};

struct BoundsOf {
  FoamView mesh;

  FOAM_HOST_DEVICE Bounds operator()(Index junction) const {
    return mesh.has_junction(junction) ? Bounds{mesh.position[junction], mesh.position[junction]}
                                       : Bounds{};
  }
};

struct Enclose {
  FOAM_HOST_DEVICE Bounds operator()(const Bounds& a, const Bounds& b) const {
    return {{std::min(a.low.x, b.low.x), std::min(a.low.y, b.low.y)},
            {std::max(a.high.x, b.high.x), std::max(a.high.y, b.high.y)}};
  }
};

/// A grid over a box with cells as wide as asked for, or a little less or more: so many that they
/// can be halved until less than eight are left along the shorter side.
inline Grid grid_over(Vec2 origin, Vec2 extent, bool wraps, double width) {
  Index halvings = 0;
  double shorter = std::min(extent.x, extent.y) / width;
  for (; shorter >= 8; shorter /= 2) {
    ++halvings;
  }
  const auto count = [&](double length) {
    const double cells = length / width / std::exp2(halvings);
    return std::max(Index{2}, static_cast<Index>(std::lround(cells))) << halvings;
  };
  const Index columns = count(extent.x);
  const Index rows = count(extent.y);
  return {columns, rows, wraps, origin, {extent.x / columns, extent.y / rows}};
}

} // namespace detail

/// On a machine (parallel/host.h).
template <class Machine> class FoamPreconditioner {
public:
  explicit FoamPreconditioner(Machine& machine) : machine_(machine) {}

  /// Makes the preconditioner for a state of the foam; both the mesh and the matrix's films have to
  /// stay as they are while it is used.
  void set_up(const WholeFoamMatrix& matrix, const Units& units) {
    using namespace detail;
    const FoamView& mesh = matrix.mesh;
    across_.resize(FoamView::size(mesh.films));
    bulk_.resize(FoamView::size(mesh.bubbles));
    squeeze_.resize(FoamView::size(mesh.bubbles));
    pressure_.resize(FoamView::size(mesh.bubbles));
    machine_.for_each(mesh.films, TakeAcross{mesh, units, across_.data()});
    machine_.for_each(mesh.bubbles, TakeBulk{mesh, units, bulk_.data()});
    machine_.for_each(mesh.bubbles, TakePressureBlock{matrix, bulk_.data(), pressure_.data()});
    solid_ = {matrix, across_.data(), bulk_.data(), squeeze_.data()};
    prepare(solid_, fine_, mesh.junctions);
    find_largest(solid_, fine_);
    make_grids(units);
  }

  /// to ← P⁻¹·from
  void apply(const double* from, double* to) {
    using namespace detail;
    const FoamView& mesh = solid_.matrix.mesh;
    machine_.for_each(mesh.bubbles, ScalePressure{mesh, pressure_.data(), from, to});
    const CellLists cells = lists();
    Level& grid = levels_.front();
    cycle(
        solid_, fine_, from, to,
        [&](const double* residual) {
          machine_.for_each(grid.grid.nodes(), RestrictJunctions{cells, residual, grid.b.data()});
        },
        [&] {
          solve_on(0);
          machine_.for_each(mesh.junctions, ProlongateToJunctions{mesh, grid.grid, place_.data(),
                                                                  grid.x.data(), to});
        });
  }

private:
  template <class T> using Array = typename Machine::template Array<T>;

  /// What smoothing on a level needs.
  struct Smoother {
    Index size = 0;
    double largest = 1; ///< eigenvalue of D⁻¹·M, or a little more
    Array<Symmetric2> inverse;
    Array<double> r, d;
  };
  struct Level {
    Grid grid;
    Array<Element> element;
    Smoother smoother;
    Array<double> b, x;

    GridMatrix matrix() const { return {grid, element.data()}; }
  };

  static constexpr double kCellWidth = 2; // of the finest grid, in bubbles
  static constexpr int kPowerSteps = 10;
  static constexpr double kMargin = 1.25; // for what the power iteration falls short of
  static constexpr int kSteps = 2;        // of Chebyshev's iteration before and after, …
  static constexpr double kRatio = 4;     // … for so large a part of the spectrum
  static constexpr int kCoarsestSteps = 16;
  static constexpr double kCoarsestRatio = 80;
  /// An element's matrix is at most four times its corners' own blocks (Cauchy and Schwarz), and so
  /// is their sum. So many steps would go astray where an eigenvalue was beyond an estimate.
  static constexpr double kLargestOfElements = 4;

  void before_row(const GridMatrix& /*matrix*/, const double* /*x*/) {}
  void before_row(const detail::Solid& solid, const double* x) {
    machine_.for_each(solid.matrix.mesh.bubbles, detail::Squeeze{solid, x});
  }

  template <class Matrix>
  void residual(const Matrix& matrix, Smoother& s, const double* b, const double* x) {
    before_row(matrix, x);
    machine_.for_each(s.size, detail::SubtractProduct<Matrix>{matrix, b, x, s.r.data()});
  }

  template <class Matrix> void prepare(const Matrix& matrix, Smoother& s, Index size) {
    using namespace detail;
    s.size = size;
    s.inverse.resize(static_cast<std::size_t>(size));
    s.r.resize(2 * static_cast<std::size_t>(size));
    s.d.resize(2 * static_cast<std::size_t>(size));
    zero_.resize(std::max(zero_.size(), 2 * static_cast<std::size_t>(size)));
    machine_.for_each(size, InvertDiagonal<Matrix>{matrix, s.inverse.data()});
  }

  /// Power iteration: x ← D⁻¹·M·x, with −M·x from residual().
  template <class Matrix> void find_largest(const Matrix& matrix, Smoother& s) {
    using namespace detail;
    const Index size = s.size;
    trial_.resize(2 * static_cast<std::size_t>(size));
    double* const x = trial_.data();
    double* const r = s.r.data();
    machine_.for_each(2 * size, parallel::Fill<double>{zero_.data(), 0});
    machine_.for_each(2 * size, parallel::Fill<double>{s.d.data(), 0});
    machine_.for_each(2 * size, FillRoughly{x});
    for (int step = 0; step < kPowerSteps; ++step) {
      const double norm =
          std::sqrt(machine_.reduce(2 * size, 0.0, DotProduct{x, x}, parallel::Add{}));
      s.largest = step == 0 ? 1 : kMargin * norm;
      machine_.for_each(2 * size, Rescale{x, norm > 0 ? 1 / norm : 0});
      residual(matrix, s, zero_.data(), x);
      machine_.for_each(2 * size, parallel::Fill<double>{x, 0});
      machine_.for_each(size, ChebyshevStep{s.inverse.data(), r, 0, -1, s.d.data(), x});
    }
  }

  /// Chebyshev's iteration for the eigenvalues of D⁻¹M from largest/ratio on (Y. Saad, Iterative
  /// Methods for Sparse Linear Systems, 2nd ed., 2003, algorithm 12.1). \param fresh x is zero.
  template <class Matrix>
  void smooth(const Matrix& matrix, Smoother& s, const double* b, double* x, bool fresh, int steps,
              double ratio) {
    const double centre = 0.5 * s.largest * (1 + 1 / ratio);
    const double radius = 0.5 * s.largest * (1 - 1 / ratio);
    const double sigma = centre / radius;
    double rho = 1 / sigma;
    double by_last = 0;
    double by_residual = 1 / centre;
    for (int step = 0; step < steps; ++step) {
      const bool first = step == 0 && fresh;
      if (first) {
        machine_.for_each(2 * s.size, parallel::Fill<double>{x, 0});
        machine_.for_each(2 * s.size, parallel::Copy<double>{b, s.r.data()});
      } else {
        residual(matrix, s, b, x);
      }
      machine_.for_each(s.size, detail::ChebyshevStep{s.inverse.data(), s.r.data(), by_last,
                                                      by_residual, s.d.data(), x});
      const double next = 1 / (2 * sigma - rho);
      by_last = next * rho;
      by_residual = 2 * next / radius;
      rho = next;
    }
  }

  template <class Matrix, class Restrict, class Correct>
  void cycle(const Matrix& matrix, Smoother& s, const double* b, double* x,
             const Restrict& restrict_residual, const Correct& correct) {
    smooth(matrix, s, b, x, true, kSteps, kRatio);
    residual(matrix, s, b, x);
    restrict_residual(s.r.data());
    correct();
    smooth(matrix, s, b, x, false, kSteps, kRatio);
  }

  void solve_on(std::size_t k) {
    using namespace detail;
    Level& level = levels_[k];
    if (k + 1 == used_) {
      smooth(level.matrix(), level.smoother, level.b.data(), level.x.data(), true, kCoarsestSteps,
             kCoarsestRatio);
      return;
    }
    Level& coarser = levels_[k + 1];
    cycle(
        level.matrix(), level.smoother, level.b.data(), level.x.data(),
        [&](const double* r) {
          machine_.for_each(coarser.grid.nodes(),
                            RestrictGrid{level.grid, coarser.grid, r, coarser.b.data()});
        },
        [&] {
          solve_on(k + 1);
          machine_.for_each(level.grid.nodes(), ProlongateGrid{level.grid, coarser.grid,
                                                               coarser.x.data(), level.x.data()});
        });
  }

  detail::CellLists lists() const {
    return {levels_.front().grid, place_.data(), key_.data(), first_.data()};
  }

  Grid finest_grid(const Units& units) {
    const FoamView& mesh = solid_.matrix.mesh;
    const bool wraps = mesh.boundary == Boundary::Periodic;
    detail::Bounds box;
    if (wraps) {
      box = {{mesh.box.xmin, mesh.box.ymin}, {mesh.box.xmax, mesh.box.ymax}};
    } else {
      box = machine_.reduce(mesh.junctions, box, detail::BoundsOf{mesh}, detail::Enclose{});
      const Vec2 margin{0.5 * units.length, 0.5 * units.length};
      box = {box.low - margin, box.high + margin};
    }
    return detail::grid_over((1 / units.length) * box.low,
                             (1 / units.length) * (box.high - box.low), wraps, kCellWidth);
  }

  Level& use_level(const Grid& grid) {
    if (used_ == levels_.size()) {
      levels_.emplace_back();
    }
    Level& level = levels_[used_++];
    level.grid = grid;
    level.element.resize(static_cast<std::size_t>(grid.cells()));
    level.b.resize(2 * static_cast<std::size_t>(grid.nodes()));
    level.x.resize(2 * static_cast<std::size_t>(grid.nodes()));
    return level;
  }

  void make_grids(const Units& units) {
    using namespace detail;
    const FoamView& mesh = solid_.matrix.mesh;
    const Grid finest = finest_grid(units);
    place_.resize(FoamView::size(mesh.junctions));
    key_.resize(FoamView::size(mesh.junctions));
    first_.resize(static_cast<std::size_t>(finest.cells()) + 1);
    machine_.for_each(mesh.junctions,
                      PlaceJunction{mesh, units, finest, place_.data(), key_.data()});
    machine_.sort(key_.data(), mesh.junctions);
    machine_.for_each(finest.cells() + 1, FindCell{key_.data(), mesh.junctions, first_.data()});
    used_ = 0;
    Level& first = use_level(finest);
    machine_.for_each(4 * finest.cells(),
                      AssembleElement{solid_, units, lists(), first.element.data()});
    prepare(first.matrix(), first.smoother, finest.nodes());
    while (levels_[used_ - 1].grid.can_be_coarsened()) {
      Level& fine = levels_[used_ - 1];
      find_largest(fine.matrix(), fine.smoother);
      const Grid grid = fine.grid.coarsened();
      Level& coarse = use_level(grid);
      machine_.for_each(CoarsenElement::size(grid),
                        CoarsenElement{levels_[used_ - 2].grid, grid,
                                       levels_[used_ - 2].element.data(), coarse.element.data()});
      prepare(coarse.matrix(), coarse.smoother, grid.nodes());
    }
    levels_[used_ - 1].smoother.largest = kLargestOfElements;
  }

  Machine& machine_;
  detail::Solid solid_;
  Array<Vec2> across_;
  Array<double> bulk_, squeeze_, pressure_;
  Smoother fine_;
  Array<GridPlace> place_;
  Array<std::uint64_t> key_; ///< cell and junction, ascending
  Array<Index> first_;       ///< key of each cell
  std::vector<Level> levels_;
  std::size_t used_ = 0; ///< of the levels
  Array<double> trial_, zero_;
};

} // namespace foam::newton
