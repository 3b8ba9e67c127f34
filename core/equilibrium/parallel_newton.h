// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton's method for a whole foam, every step of it in parallel on a machine (parallel/host.h):
// the equations, the penalty function and the limits of NewtonEquilibrator; its systems solved by
// MINRES (minimal_residual.h) with a preconditioner that does not feel the foam's size
// (foam_preconditioner.h), its T1s by bidding (topology/bidding.h).
//
// Nothing is factorised, so that no inertia tells whether a step leads to a minimum. Far from
// equilibrium, and where the penalty function does not fall along a step, films are stiffened
// (film_derivatives) until it does: they resist being stretched, as springs do. From where that
// does not help, relax_compressible() does, on the processor: ask hemmed_in().
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include "equilibrium/equilibrator.h"
#include "equilibrium/film_step.h"
#include "equilibrium/foam_preconditioner.h"
#include "equilibrium/minimal_residual.h"
#include "equilibrium/parallel_measures.h"
#include "topology/bidding.h"
#include "topology/local_operations.h"
#include "topology/swap_rule.h"

namespace foam::newton {

/// Largest dimensionless residuals of the equilibrium's equations, as LagrangianSystem has them.
struct LargestResiduals {
  double force = 0, curvature = 0, area = 0;

  double largest() const { return std::max({force, curvature, area}); }
};

/// A change of a foam's unknowns, by element.
struct StepView {
  Vec2* junction = nullptr;   ///< cm
  double* angle = nullptr;    ///< rad, by film
  double* pressure = nullptr; ///< N/cm², by bubble

  FOAM_HOST_DEVICE Vec2 chord_change(const FoamView& mesh, Index film) const {
    return junction[mesh.end(2 * film)] - junction[mesh.start(2 * film)];
  }
};

namespace detail {

inline constexpr double kLargestMove = 0.3; // of a junction's shortest film, in a limited step

struct ForceAt {
  FoamView mesh;
  Units units;

  FOAM_HOST_DEVICE double operator()(Index junction) const {
    if (!moves(mesh, junction)) {
      return 0;
    }
    Vec2 sum;
    for (const Index h : mesh.junction_half[FoamView::size(junction)]) {
      const Vec2 chord = mesh.chord(h);
      const double d = norm(chord);
      const double q = mesh.pressure_of(mesh.left(h)) - mesh.pressure_of(mesh.right(h));
      const FilmForces forces =
          film_forces(chord, (1 / d) * chord, d, arc_shape(mesh.half_angle(h)), q, units.tension);
      sum += Vec2{forces.ends[0], forces.ends[1]};
    }
    return norm(sum) / units.tension;
  }
};

struct CurvatureOf {
  FoamView mesh;
  Units units;

  FOAM_HOST_DEVICE double operator()(Index film) const {
    if (!bends(mesh, film)) {
      return 0;
    }
    const Index h = 2 * film;
    const double q = mesh.pressure_of(mesh.left(h)) - mesh.pressure_of(mesh.right(h));
    return std::abs(2 * std::sin(mesh.half_angle(h)) - q * norm(mesh.chord(h)) / units.tension);
  }
};

struct AreaErrorOf {
  FoamView mesh;

  FOAM_HOST_DEVICE double operator()(Index bubble) const {
    return mesh.has_bubble(bubble) ? area_error(mesh, bubble) : 0;
  }
};

/// Not-a-number wins, so that it is seen.
struct Larger {
  FOAM_HOST_DEVICE double operator()(double a, double b) const { return a >= b || a != a ? a : b; }
};

struct Smaller {
  FOAM_HOST_DEVICE double operator()(double a, double b) const { return b < a ? b : a; }
};

/// A sum of vectors or, in x, of numbers, and of how many.
struct Total {
  Vec2 sum;
  double count = 0;

  Vec2 mean() const { return count > 0 ? (1 / count) * sum : Vec2{}; }
  friend FOAM_HOST_DEVICE Total operator+(const Total& a, const Total& b) {
    return {a.sum + b.sum, a.count + b.count};
  }
};

struct TargetArea {
  FoamView mesh;

  FOAM_HOST_DEVICE Total operator()(Index bubble) const {
    return mesh.has_bubble(bubble) ? Total{{mesh.target_area[bubble], 0}, 1} : Total{};
  }
};

struct TotalPressure {
  FoamView mesh;
  const double* vector = nullptr;

  FOAM_HOST_DEVICE Total operator()(Index bubble) const {
    return mesh.has_bubble(bubble) ? Total{{pressure_in(mesh, vector, bubble), 0}, 1} : Total{};
  }
};

struct TotalDisplacement {
  FoamView mesh;
  const double* vector = nullptr;

  FOAM_HOST_DEVICE Total operator()(Index junction) const {
    return moves(mesh, junction) ? Total{displacement(vector, junction), 1} : Total{};
  }
};

struct TotalPosition {
  FoamView mesh;

  FOAM_HOST_DEVICE Total operator()(Index junction) const {
    return moves(mesh, junction) ? Total{mesh.position[junction], 1} : Total{};
  }
};

/// In x the moment of all displacements about a centre, in y the moment of inertia.
struct TotalMoment {
  FoamView mesh;
  Vec2 centre;
  const double* vector = nullptr;

  FOAM_HOST_DEVICE Total operator()(Index junction) const {
    if (!moves(mesh, junction)) {
      return {};
    }
    const Vec2 r = mesh.position[junction] - centre;
    return {{cross(r, displacement(vector, junction)), dot(r, r)}, 1};
  }
};

struct ShiftPressure {
  FoamView mesh;
  double by = 0;
  double* vector = nullptr;

  FOAM_HOST_DEVICE void operator()(Index bubble) const {
    if (mesh.has_bubble(bubble)) {
      vector[2 * mesh.junctions + bubble] += by;
    }
  }
};

/// Takes a rigid motion out of all displacements.
struct HoldJunction {
  FoamView mesh;
  Vec2 translation;
  double rotation = 0;
  Vec2 centre; ///< of the rotation, cm
  double* vector = nullptr;

  FOAM_HOST_DEVICE void operator()(Index junction) const {
    if (moves(mesh, junction)) {
      const Vec2 r = mesh.position[junction] - centre;
      const Vec2 rigid = translation + rotation * left_normal(r);
      set_displacement(vector, junction, displacement(vector, junction) - rigid);
    }
  }
};

/// A solution with its units.
struct TakeJunctionStep {
  Units units;
  const double* solution = nullptr;
  StepView step;

  FOAM_HOST_DEVICE void operator()(Index junction) const {
    step.junction[junction] = units.length * displacement(solution, junction);
  }
};

struct TakePressureStep {
  FoamView mesh;
  Units units;
  const double* solution = nullptr;
  StepView step;

  FOAM_HOST_DEVICE void operator()(Index bubble) const {
    step.pressure[bubble] = units.pressure() * pressure_in(mesh, solution, bubble);
  }
};

struct TakeAngleStep {
  FoamView mesh;
  Units units;
  double stiffening = 0;
  const double* solution = nullptr;
  StepView step;

  FOAM_HOST_DEVICE void operator()(Index film) const {
    step.angle[film] =
        bends(mesh, film) ? angle_change(mesh, film, units, stiffening, solution) : 0;
  }
};

/// The fraction of a step that the film can take.
struct LongestStep {
  FoamView mesh;
  StepView step;

  FOAM_HOST_DEVICE double operator()(Index film) const {
    return bends(mesh, film)
               ? longest_film_step(mesh.chord(2 * film), step.chord_change(mesh, film),
                                   mesh.half_angle(2 * film), step.angle[film])
               : 1;
  }
};

/// No junction moves by more than a part of its shortest film (limited_step).
struct LimitJunction {
  FoamView mesh;
  StepView step;

  FOAM_HOST_DEVICE void operator()(Index junction) const {
    if (!moves(mesh, junction)) {
      return;
    }
    double shortest = std::numeric_limits<double>::infinity();
    for (const Index h : mesh.junction_half[FoamView::size(junction)]) {
      shortest = std::min(shortest, norm(mesh.chord(h)));
    }
    const double length = norm(step.junction[junction]);
    if (length > kLargestMove * shortest) {
      step.junction[junction] = (kLargestMove * shortest / length) * step.junction[junction];
    }
  }
};

/// No arc turns by more than half a radian (limited_step).
struct LimitAngle {
  FoamView mesh;
  StepView step;

  FOAM_HOST_DEVICE void operator()(Index film) const {
    const double largest = largest_turn(mesh.film_angle[film], step.angle[film]);
    step.angle[film] = std::clamp(step.angle[film], -largest, largest);
  }
};

/// to[i] ← from[i] + fraction·step[i]
template <class T> struct Walk {
  const T* from = nullptr;
  const T* step = nullptr;
  double fraction = 0;
  T* to = nullptr;

  FOAM_HOST_DEVICE void operator()(Index i) const { to[i] = from[i] + fraction * step[i]; }
};

struct LengthOf {
  FoamView mesh;

  FOAM_HOST_DEVICE double operator()(Index film) const {
    return bends(mesh, film) ? mesh.length(2 * film) : 0;
  }
};

struct ViolationOf {
  FoamView mesh;

  FOAM_HOST_DEVICE double operator()(Index bubble) const {
    return mesh.has_bubble(bubble) ? std::abs(mesh.area(bubble) - mesh.target_area[bubble]) : 0;
  }
};

struct LargestPressure {
  FoamView mesh;
  StepView step;

  FOAM_HOST_DEVICE double operator()(Index bubble) const {
    if (!mesh.has_bubble(bubble)) {
      return 0;
    }
    const double p = mesh.pressure[bubble];
    return std::max(std::abs(p), std::abs(p + step.pressure[bubble]));
  }
};

/// How fast a film grows along a step.
struct GrowthOf {
  FoamView mesh;
  StepView step;

  FOAM_HOST_DEVICE double operator()(Index film) const {
    return bends(mesh, film) ? arc_growth(mesh.chord(2 * film), step.chord_change(mesh, film),
                                          mesh.half_angle(2 * film), step.angle[film])
                             : 0;
  }
};

/// Marks the films that a step shortens further although they are short. Each swap of a film asks
/// for it to be four times shorter, so that no film is swapped back and forth.
struct MarkClosing {
  static constexpr std::uint8_t kLargestSwapCount = 4;

  FoamView mesh;
  StepView step;
  double t1_length = 0; ///< cm
  const std::uint8_t* swaps = nullptr;
  std::uint8_t* closing = nullptr;

  FOAM_HOST_DEVICE void operator()(Index film) const {
    closing[film] =
        bends(mesh, film) && swaps[film] < kLargestSwapCount &&
        mesh.length(2 * film) <= t1_length * std::pow(0.25, static_cast<double>(swaps[film])) &&
        dot(mesh.chord(2 * film), step.chord_change(mesh, film)) < 0;
  }
};

} // namespace detail

/// T1s of closing films that may be swapped and are pulled shut, the shortest first
/// (topology/bidding.h).
struct ClosingFilmBids {
  std::uint8_t* closing = nullptr; ///< by film; 0 once it is swapped
  std::uint8_t* swaps = nullptr;   ///< how often it has been

  struct Count {
    std::int64_t t1 = 0;

    FOAM_HOST_DEVICE bool any() const { return t1 > 0; }
    friend FOAM_HOST_DEVICE Count operator+(Count a, Count b) { return {a.t1 + b.t1}; }
  };

  FOAM_HOST_DEVICE static Index candidates(const FoamView& mesh) { return mesh.films; }
  FOAM_HOST_DEVICE std::uint64_t key(const FoamView& mesh, Index film) const {
    const bool gives_way = closing[film] && spares_sides(mesh, film) &&
                           can_perform_t1(mesh, film) && pulled_shut(mesh, film);
    return gives_way ? bid_key(false, mesh.length(2 * film), film) : kNoBid;
  }
  FOAM_HOST_DEVICE static Touched bubbles(const FoamView& mesh, Index film) {
    return bubbles_around_film(mesh, film);
  }
  FOAM_HOST_DEVICE static Count count(const FoamView& /*mesh*/, Index /*film*/) { return {1}; }
  FOAM_HOST_DEVICE void perform(FoamView& mesh, Index film) const {
    swap_film(mesh, film);
    closing[film] = 0;
    ++swaps[film];
  }
};

/// What an equilibration did.
struct NewtonResult {
  EquilibriumReport report;
  std::int64_t t1 = 0;      ///< films swapped
  int inner_iterations = 0; ///< of MINRES, all in all
};

/// Notes in a foam what has been done to its arrays.
inline void note(Foam& foam, const NewtonResult& result) {
  foam.t1_count += result.t1;
  foam.topology += static_cast<std::uint64_t>(result.t1);
  foam.report = result.report;
}

template <class Machine> class ParallelNewton {
public:
  ParallelNewton(Machine& machine, const EquilibratorOptions& options)
      : machine_(machine), options_(options), bidding_(machine), solver_(machine),
        preconditioner_(machine) {}

  /// Brings a mesh to equilibrium, swapping films shorter than t1_length (cm) that are pulled shut.
  /// Where it throws Aborted the mesh is somewhere in between.
  NewtonResult equilibrate(const FoamView& mesh, double t1_length, const AbortCheck& aborted) {
    prepare(mesh);
    NewtonResult result;
    double residual = residuals(mesh).largest();
    double best = std::numeric_limits<double>::infinity();
    int since_best = 0;
    double stiffening = residual > kFar ? kFirstStiffening : 0;
    while (!(residual < options_.tolerance)) {
      if (aborted && aborted()) {
        throw Aborted();
      }
      since_best = residual < 0.5 * best ? 0 : since_best + 1;
      best = std::min(best, residual);
      if (result.report.iterations >= options_.maximum_iterations || !std::isfinite(residual) ||
          (best < kClose && since_best > kPatience)) {
        break;
      }
      ++result.report.iterations;
      result.inner_iterations += find_step(mesh, stiffening, residual);
      machine_.for_each(
          mesh.films, detail::MarkClosing{mesh, step(), t1_length, swaps_.data(), closing_.data()});
      const double taken = search_line(mesh, residual, stiffening);
      const std::int64_t swapped =
          bidding_.run(mesh, ClosingFilmBids{closing_.data(), swaps_.data()}).t1;
      result.t1 += swapped;
      if (taken == 0 && swapped == 0) {
        if (stiffening >= kLargestStiffening) {
          break;
        }
        stiffening = std::max(kFirstStiffening, 8 * stiffening);
      } else {
        if (taken == 1) {
          stiffening = stiffening > kLeastStiffening ? stiffening / 8 : 0;
        }
        residual = residuals(mesh).largest();
      }
    }
    const EquilibriumMeasures measures = measure_equilibrium(machine_, mesh);
    result.report.converged = residual < options_.tolerance;
    result.report.max_angle_error = measures.angle_error;
    result.report.max_area_error = measures.area_error;
    result.report.residual = residual;
    return result;
  }

  /// Whether a mesh is so far from equilibrium that some film is in the way of Newton's first step:
  /// relax_compressible() then brings it nearer.
  bool hemmed_in(const FoamView& mesh) {
    prepare(mesh);
    const double residual = residuals(mesh).largest();
    if (!(residual > kFar)) {
      return false;
    }
    find_step(mesh, 0, residual);
    return longest_step(mesh) < kHemmedIn;
  }

private:
  template <class T> using Array = typename Machine::template Array<T>;

  static constexpr double kFar = 0.5;       // residual from which on films are stiffened at once
  static constexpr double kHemmedIn = 0.25; // part of its step that can be taken where it is not
  static constexpr double kFirstStiffening = 1;
  static constexpr double kLeastStiffening = 0.01;
  static constexpr double kLargestStiffening = 1000;
  static constexpr double kClose = 1e-6;
  static constexpr int kPatience = 24;          // iterations without progress when close
  static constexpr double kSmallestStep = 1e-4; // of a line search
  static constexpr double kRoughest = 1e-2;     // to which linear systems are solved, …
  static constexpr double kFinest = 1e-4;       // … in between as the residual is
  static constexpr int kInnerIterations = 500;

  double longest_step(const FoamView& mesh) {
    return machine_.reduce(mesh.films, 1.0, detail::LongestStep{mesh, step()}, detail::Smaller{});
  }

  /// Makes room for a mesh, and takes its measure.
  void prepare(const FoamView& mesh) {
    const auto junctions = FoamView::size(mesh.junctions);
    const auto films = FoamView::size(mesh.films);
    const auto bubbles = FoamView::size(mesh.bubbles);
    const auto unknowns = static_cast<std::size_t>(size_of(mesh));
    for (auto* array : {&position_, &junction_step_}) {
      array->resize(junctions);
    }
    for (auto* array : {&angle_, &angle_step_}) {
      array->resize(films);
    }
    for (auto* array : {&pressure_, &pressure_step_}) {
      array->resize(bubbles);
    }
    for (auto* array : {&right_, &solution_}) {
      array->resize(unknowns);
    }
    for (auto* array : {&swaps_, &closing_}) {
      array->resize(films);
    }
    stiffness_.resize(films);
    gradient_.resize(films);
    machine_.for_each(mesh.films, parallel::Fill<std::uint8_t>{swaps_.data(), 0});
    const detail::Total area =
        machine_.reduce(mesh.bubbles, detail::Total{}, detail::TargetArea{mesh}, parallel::Add{});
    units_ = {std::sqrt(area.mean().x), 2 * mesh.surface_tension};
  }

  StepView step() { return {junction_step_.data(), angle_step_.data(), pressure_step_.data()}; }

  LargestResiduals residuals(const FoamView& mesh) {
    using namespace detail;
    return {machine_.reduce(mesh.junctions, 0.0, ForceAt{mesh, units_}, Larger{}),
            machine_.reduce(mesh.films, 0.0, CurvatureOf{mesh, units_}, Larger{}),
            machine_.reduce(mesh.bubbles, 0.0, AreaErrorOf{mesh}, Larger{})};
  }

  /// Newton's step. \returns the iterations it took.
  int find_step(const FoamView& mesh, double stiffening, double residual) {
    using namespace detail;
    const Index rows = mesh.junctions + mesh.bubbles;
    machine_.for_each(mesh.films,
                      Linearise{mesh, units_, stiffening, stiffness_.data(), gradient_.data()});
    machine_.for_each(rows, RightHandSide{mesh, units_, gradient_.data(), right_.data()});
    if (mesh.boundary != Boundary::Free) { // the areas' sum is given
      level_pressures(mesh, right_.data());
    }
    const WholeFoamMatrix matrix{mesh, stiffness_.data()};
    preconditioner_.set_up(matrix, units_);
    const int iterations = solver_.solve(
        size_of(mesh), right_.data(), solution_.data(), std::clamp(residual, kFinest, kRoughest),
        kInnerIterations,
        [&](const double* from, double* to) {
          machine_.for_each(rows, Multiply{matrix, from, to});
        },
        [&](const double* from, double* to) { preconditioner_.apply(from, to); });
    remove_gauges(mesh);
    take_step(mesh, stiffening);
    return iterations;
  }

  /// The step that the solution is.
  void take_step(const FoamView& mesh, double stiffening) {
    using namespace detail;
    machine_.for_each(mesh.junctions, TakeJunctionStep{units_, solution_.data(), step()});
    machine_.for_each(mesh.bubbles, TakePressureStep{mesh, units_, solution_.data(), step()});
    machine_.for_each(mesh.films,
                      TakeAngleStep{mesh, units_, stiffening, solution_.data(), step()});
  }

  /// Takes the mean out of a vector's pressures.
  void level_pressures(const FoamView& mesh, double* vector) {
    using namespace detail;
    const Total total =
        machine_.reduce(mesh.bubbles, Total{}, TotalPressure{mesh, vector}, parallel::Add{});
    machine_.for_each(mesh.bubbles, ShiftPressure{mesh, -total.mean().x, vector});
  }

  /// Takes out of the solution what costs nothing: in a closed container only differences of
  /// pressure act, and nothing but a wall holds a foam in its place, and a torus in its direction.
  void remove_gauges(const FoamView& mesh) {
    using namespace detail;
    double* const x = solution_.data();
    if (mesh.boundary != Boundary::Free) {
      level_pressures(mesh, x);
    }
    if (mesh.boundary == Boundary::Fixed) {
      return;
    }
    HoldJunction hold{mesh, sum_junctions(mesh, TotalDisplacement{mesh, x}).mean(), 0, {}, x};
    if (mesh.boundary == Boundary::Free) {
      hold.centre = sum_junctions(mesh, TotalPosition{mesh}).mean();
      const Vec2 moment = sum_junctions(mesh, TotalMoment{mesh, hold.centre, x}).sum;
      hold.rotation = moment.x / moment.y;
    }
    machine_.for_each(mesh.junctions, hold);
  }

  template <class Map> detail::Total sum_junctions(const FoamView& mesh, const Map& map) {
    return machine_.reduce(mesh.junctions, detail::Total{}, map, parallel::Add{});
  }

  void walk(const FoamView& mesh, double fraction) {
    using namespace detail;
    machine_.for_each(mesh.junctions,
                      Walk<Vec2>{position_.data(), junction_step_.data(), fraction, mesh.position});
    machine_.for_each(mesh.films,
                      Walk<double>{angle_.data(), angle_step_.data(), fraction, mesh.film_angle});
    machine_.for_each(mesh.bubbles, Walk<double>{pressure_.data(), pressure_step_.data(), fraction,
                                                 mesh.pressure});
  }

  double violation(const FoamView& mesh) {
    return machine_.reduce(mesh.bubbles, 0.0, detail::ViolationOf{mesh}, parallel::Add{});
  }

  /// The exact penalty function (globalisation.h).
  double merit(const FoamView& mesh, double mu) {
    return units_.tension *
               machine_.reduce(mesh.films, 0.0, detail::LengthOf{mesh}, parallel::Add{}) +
           mu * violation(mesh);
  }

  /// Its weight of areas (J. Nocedal, S. J. Wright, Numerical Optimization, 2nd ed., 2006, 18.36).
  double penalty(const FoamView& mesh) {
    using namespace detail;
    const double largest =
        machine_.reduce(mesh.bubbles, 0.0, LargestPressure{mesh, step()}, Larger{});
    const double slope =
        units_.tension * machine_.reduce(mesh.films, 0.0, GrowthOf{mesh, step()}, parallel::Add{});
    const double descent = slope > 0 ? slope / violation(mesh) : 0;
    return 1.5 * std::max(largest, std::isfinite(descent) ? descent : 0) + 5e-4 * units_.pressure();
  }

  /// Takes as much of the step as can be taken, or backtracks along it, until the residual is
  /// halved or the merit function falls. \returns the fraction of the step taken.
  double search_line(const FoamView& mesh, double residual, double stiffening) {
    using namespace detail;
    const double mu = penalty(mesh);
    const double before = merit(mesh, mu);
    machine_.for_each(mesh.junctions, parallel::Copy<Vec2>{mesh.position, position_.data()});
    machine_.for_each(mesh.films, parallel::Copy<double>{mesh.film_angle, angle_.data()});
    machine_.for_each(mesh.bubbles, parallel::Copy<double>{mesh.pressure, pressure_.data()});
    const auto improves = [&](double fraction) {
      walk(mesh, fraction);
      return residuals(mesh).largest() < 0.5 * residual || merit(mesh, mu) < before;
    };
    const double longest = longest_step(mesh);
    if (longest < 1) {
      machine_.for_each(mesh.junctions, LimitJunction{mesh, step()});
      machine_.for_each(mesh.films, LimitAngle{mesh, step()});
      if (improves(1)) {
        return longest;
      }
      walk(mesh, 0);
      take_step(mesh, stiffening);
    }
    for (double fraction = longest; fraction > kSmallestStep * longest; fraction *= 0.5) {
      if (improves(fraction)) {
        return fraction;
      }
    }
    walk(mesh, 0);
    return 0;
  }

  Machine& machine_;
  EquilibratorOptions options_;
  Bidding<Machine> bidding_;
  MinimalResidual<Machine> solver_;
  FoamPreconditioner<Machine> preconditioner_;
  Units units_;

  Array<FilmStiffness> stiffness_;
  Array<FilmGradient> gradient_;
  Array<double> right_, solution_;
  Array<Vec2> junction_step_;
  Array<double> angle_step_, pressure_step_;
  Array<Vec2> position_; ///< and the next two: where a line search began
  Array<double> angle_, pressure_;
  Array<std::uint8_t> swaps_, closing_;
};

} // namespace foam::newton
