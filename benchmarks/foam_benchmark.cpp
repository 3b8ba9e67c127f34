// SPDX-License-Identifier: GPL-3.0-or-later
//
// Times pieces of work of the core. Each prints one line of JSON; compare.py puts them beside
// Surface Evolver's.
//
//   equilibrium N [FILE.fe]   a periodic foam from random points, brought to equilibrium; the start
//                             also as a Surface Evolver file
//   steps N COUNT             such a foam coarsened, areas + 0.01(n − 6) at mean area 1
//   frames N COUNT TOLERANCE  a periodic foam of the thesis's scale, coarsened with its constants
//   walls N COUNT             foams of about N bubbles in a disc and on a torus, a frame of each in
//                             turn
//   thesis                    the thesis's test: 2,000 bubbles, 1,000 frames
//   build N                   a mesh from N random points
//   memory N                  what a coarsening foam and its factorisation take
#include <malloc.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <ctime>
#include <fstream>
#include <iostream>
#include <memory>
#include <numbers>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "base/number.h"
#include "base/random.h"
#include "coarsening/coarsening.h"
#include "construct/containers.h"
#include "construct/from_points.h"
#include "construct/jittered_grid.h"
#include "engines/engines.h"
#include "equilibrium/nested_dissection.h"
#include "equilibrium/newton_matrix.h"
#include "physics/gas.h"

namespace {

using namespace foam;

/// Processor and wall-clock time since it was made, s.
class Stopwatch {
public:
  double cpu() const { return processor() - cpu_; }
  double wall() const {
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - wall_).count();
  }

private:
  static double processor() {
    std::timespec t{};
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return static_cast<double>(t.tv_sec) + 1e-9 * static_cast<double>(t.tv_nsec);
  }

  double cpu_ = processor();
  std::chrono::steady_clock::time_point wall_ = std::chrono::steady_clock::now();
};

/// One line of JSON.
class Record {
public:
  explicit Record(const std::string& work) { text_ << "{\"work\": \"" << work << '"'; }
  template <class Value> Record& add(const char* name, Value value) {
    text_ << ", \"" << name << "\": " << value;
    return *this;
  }
  void print() { std::cout << text_.str() << "}" << std::endl; }

private:
  std::ostringstream text_;
};

/// Of this program, by Linux's account.
double peak_memory_mib() {
  std::ifstream status("/proc/self/status");
  for (std::string word; status >> word;) {
    if (word == "VmHWM:") {
      double kib = 0;
      status >> kib;
      return kib / 1024;
    }
  }
  return std::nan("");
}

/// What has been allocated and not given back, bytes.
double allocated() {
  const auto state = mallinfo2();
  return static_cast<double>(state.uordblks + state.hblkhd);
}

std::vector<Vec2> random_points(Index count, double side) {
  std::mt19937_64 generator(1);
  std::vector<Vec2> points(place_of(count));
  for (Vec2& p : points) {
    p.x = side * static_cast<double>(generator() >> 11) * 0x1p-53;
    p.y = side * static_cast<double>(generator() >> 11) * 0x1p-53;
  }
  return points;
}

/// A periodic foam of random points at mean area 1, its target areas half-way between those of the
/// initial mesh and the mean; not in equilibrium.
Foam random_foam(Index bubbles) {
  const double side = std::sqrt(bubbles);
  BuildOptions options;
  options.boundary = Boundary::Periodic;
  options.torus = Lattice::rectangle(0, side, 0, side);
  Foam foam = build_from_points(random_points(bubbles, side), options);
  for (double& area : foam.target_area) {
    area = 0.5 * (area + 1);
  }
  return foam;
}

/// In the format of Surface Evolver's data files (K. A. Brakke, Surface Evolver Manual, ch. 5).
void write_evolver_file(const Foam& foam, const std::string& path) {
  const auto number = [](auto element) { return element.index() + 1; };
  const auto& [origin, first, second] = foam.surroundings.lattice;
  std::ofstream file(path);
  file.precision(17);
  file << "STRING\nSPACE_DIMENSION 2\nTORUS_FILLED\nPERIODS\n"
       << first.x << ' ' << first.y << '\n'
       << second.x << ' ' << second.y
       << "\nlength_method_name \"circular_arc_length\"\narea_method_name \"circular_arc_area\""
       << "\nVERTICES\n";
  for (const Junction j : foam.junction_slots()) {
    const Vec2 p = foam.position[j];
    file << number(j) << ' ' << p.x << ' ' << p.y << '\n';
  }
  const auto wrap = [](Index periods) { return periods == 0 ? '*' : (periods > 0 ? '+' : '-'); };
  file << "EDGES\n";
  for (const Film f : foam.film_slots()) {
    const Wrap w = foam.wrap(f.half());
    file << number(f) << ' ' << number(foam.start(f.half())) << ' ' << number(foam.end(f.half()))
         << ' ' << wrap(w.x) << ' ' << wrap(w.y) << '\n';
  }
  file << "FACES\n";
  for (const Bubble b : foam.bubble_slots()) {
    file << number(b);
    for_each_half(foam, b,
                  [&](Half h) { file << ' ' << (h.reversed() ? -1 : 1) * number(h.film()); });
    file << '\n';
  }
  file << "BODIES\n";
  for (const Bubble b : foam.bubble_slots()) {
    file << number(b) << ' ' << number(b) << " volume " << foam.target_area[b] << '\n';
  }
}

void time_equilibrium(Index bubbles, const std::string& evolver_file) {
  Foam foam = random_foam(bubbles);
  if (!evolver_file.empty()) {
    write_evolver_file(foam, evolver_file);
  }
  const Stopwatch watch;
  const EquilibriumReport report = make_equilibrator({})->equilibrate(foam, 0.1, {});
  Record("equilibrium")
      .add("bubbles", bubbles)
      .add("cpu", watch.cpu())
      .add("wall", watch.wall())
      .add("iterations", report.iterations)
      .add("t1", foam.t1_count)
      .add("residual", report.residual)
      .add("length", foam.energy() / foam.reference_tension())
      .add("unconverged", report.converged ? 0 : 1)
      .add("memory_mib", peak_memory_mib())
      .print();
}

/// Advances a foam and prints what a frame took.
void time_frames(const std::string& work, Foam foam, const CoarseningOptions& options, int count,
                 const Stopwatch& whole) {
  const Index bubbles = foam.bubble_count();
  auto coarsening = make_coarsening(options);
  coarsening->restart(std::move(foam));
  const Stopwatch watch;
  double residual = 0;
  int unconverged = 0;
  int frames = 0;
  while (frames < count && coarsening->advance({})) {
    ++frames;
    residual = std::max(residual, coarsening->foam().report.residual);
    unconverged += coarsening->foam().report.converged ? 0 : 1;
  }
  const double per_frame = 1.0 / std::max(frames, 1);
  Record(work)
      .add("bubbles", bubbles)
      .add("frames", frames)
      .add("cpu_per_frame", watch.cpu() * per_frame)
      .add("wall_per_frame", watch.wall() * per_frame)
      .add("cpu_in_all", whole.cpu())
      .add("wall_in_all", whole.wall())
      .add("bubbles_left", coarsening->foam().bubble_count())
      .add("t1", coarsening->foam().t1_count)
      .add("t2", coarsening->foam().t2_count)
      .add("residual", residual)
      .add("unconverged", unconverged)
      .add("memory_mib", peak_memory_mib())
      .print();
}

void time_steps(Index bubbles, int count) {
  const Stopwatch whole;
  Foam foam = random_foam(bubbles);
  make_equilibrator({})->equilibrate(foam, 0.1, {});
  CoarseningOptions options;
  options.time_step = 1;
  options.permeability = 0.01 / von_neumann_constant(foam.surface_tension, 1);
  options.thresholds.kind = ThresholdKind::Absolute;
  options.thresholds.t1_length = 0.1;
  options.thresholds.t2_area = 0.05;
  time_frames("steps", std::move(foam), options, count, whole);
}

/// At the scale of the thesis's large foams, not in equilibrium.
Foam thesis_foam(Index bubbles, Boundary boundary) {
  constexpr double kSpacing = 4.4; // cm
  BuildOptions build;
  build.boundary = boundary;
  if (boundary == Boundary::Periodic) {
    const Vec2 corner = grid_corner(bubbles, kSpacing);
    build.torus = Lattice::rectangle(0, corner.x, 0, corner.y);
  }
  return build_from_points(jittered_grid(bubbles, kSpacing, 1, 1), build);
}

/// With the thesis's constants (its Figure 4.19).
void time_thesis_frames(const std::string& work, Index bubbles, Boundary boundary, int count,
                        double tolerance) {
  const Stopwatch whole;
  Foam foam = thesis_foam(bubbles, boundary);
  CoarseningOptions options;
  options.time_step = 1.0 / 30;
  options.thresholds.kind = ThresholdKind::Absolute;
  options.equilibrator.tolerance = tolerance;
  make_equilibrator(options.equilibrator)->equilibrate(foam, options.thresholds.t1_length, {});
  time_frames(work, std::move(foam), options, count, whole);
}

/// Of points, with areas at random: two foams of them are as uneven as each other.
Foam uneven_foam(const std::vector<Vec2>& points, BuildOptions options) {
  Random random(1);
  options.target_areas = TargetAreas::Array;
  options.fit_areas = true;
  options.target_area_array.resize(points.size());
  std::ranges::generate(options.target_area_array, [&] { return 0.2 + 1.6 * random.uniform(); });
  return build_from_points(points, options);
}

/// As many bubbles of about area 1 as find room in a disc.
Foam foam_in_disc(Index bubbles) {
  const double radius = std::sqrt(bubbles / std::numbers::pi);
  BuildOptions options;
  options.boundary = Boundary::Container;
  options.container = disc({-radius, radius, -radius, radius}, WallContact::Slip);
  const auto side = static_cast<Index>(std::ceil(2 * radius));
  std::vector<Vec2> points = jittered_grid(side * side, 1, 1, 1);
  const Vec2 middle = 0.5 * grid_corner(side * side, 1);
  for (Vec2& p : points) {
    p -= middle;
  }
  std::erase_if(points, [&](Vec2 p) { return !is_inside(options.container, p); });
  return uneven_foam(points, options);
}

Foam foam_on_torus(Index bubbles) {
  const Vec2 corner = grid_corner(bubbles, 1);
  BuildOptions options;
  options.boundary = Boundary::Periodic;
  options.torus = Lattice::rectangle(0, corner.x, 0, corner.y);
  return uneven_foam(jittered_grid(bubbles, 1, 1, 1), options);
}

/// What walls cost: two foams take turns, so that both find the machine in the same mood.
void time_walls(Index bubbles, int count) {
  for (const Stepping stepping : {Stepping::Events, Stepping::FixedSteps}) {
    CoarseningOptions options;
    options.stepping = stepping;
    struct Run {
      std::unique_ptr<Evolution> coarsening;
      double cpu = 0;
      std::int64_t events = 0;

      void advance() {
        const Stopwatch watch;
        if (!coarsening->advance({}) || !coarsening->foam().report.converged) {
          throw std::runtime_error("a frame found no equilibrium");
        }
        cpu += watch.cpu();
      }
      std::int64_t events_so_far() const {
        const Foam& foam = coarsening->foam();
        return foam.t1_count + foam.t2_count + foam.t3_count;
      }
    };
    std::array<Run, 2> runs;
    for (Run& run : runs) {
      Foam foam = &run == runs.data() ? foam_in_disc(bubbles) : foam_on_torus(bubbles);
      make_equilibrator({})->equilibrate(foam, 0.025, {});
      run.coarsening = make_coarsening(options);
      run.coarsening->restart(std::move(foam));
      run.advance(); // which has a factorisation to make
      run.cpu = 0;
      run.events = -run.events_so_far();
    }
    for (int frame = 0; frame < count; ++frame) {
      std::ranges::for_each(runs, &Run::advance);
    }
    const auto& [disc, torus] = runs;
    Record(stepping == Stepping::Events ? "walls" : "walls_in_fixed_steps")
        .add("bubbles_in_disc", disc.coarsening->foam().bubble_count())
        .add("bubbles_on_torus", torus.coarsening->foam().bubble_count())
        .add("frames", count)
        .add("events_in_disc", disc.events + disc.events_so_far())
        .add("events_on_torus", torus.events + torus.events_so_far())
        .add("cpu_per_frame_in_disc", disc.cpu / count)
        .add("cpu_per_frame_on_torus", torus.cpu / count)
        .add("ratio", disc.cpu / torus.cpu)
        .print();
  }
}

void time_build(Index points) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic}) {
    const double side = std::sqrt(points);
    const std::vector<Vec2> where = random_points(points, side);
    BuildOptions options;
    options.boundary = boundary;
    options.torus = Lattice::rectangle(0, side, 0, side);
    const Stopwatch watch;
    const Foam foam = build_from_points(where, options);
    Record(boundary == Boundary::Free ? "build_free" : "build_periodic")
        .add("bubbles", foam.bubble_count())
        .add("cpu", watch.cpu())
        .add("wall", watch.wall())
        .add("memory_mib", peak_memory_mib())
        .print();
  }
}

/// A coarsening foam, and a linear system like the one that it keeps: matrix and factorisation.
void measure_memory(Index bubbles) {
  const double before = allocated();
  auto coarsening = make_coarsening({});
  coarsening->restart(thesis_foam(bubbles, Boundary::Periodic));
  for (int frame = 0; frame < 3 && coarsening->advance({}); ++frame) {
  }
  const double whole = allocated() - before;

  const Foam& foam = coarsening->foam();
  const Region region = whole_foam(foam);
  const double without = allocated();
  NewtonMatrix matrix;
  matrix.set_up(foam, region, std::vector<char>(region.films.size(), 0));
  matrix.assemble(foam, region, 0);
  MultifrontalSolver solver;
  solver.analyse(nested_dissection(foam, region, matrix.unknowns()), matrix.shares());
  solver.factorise(matrix.shares(), matrix.diagonal());
  const double system = allocated() - without;
  Record("memory")
      .add("bubbles", foam.bubble_count())
      .add("bytes_per_bubble", whole / foam.bubble_count())
      .add("system_bytes_per_bubble", system / foam.bubble_count())
      .print();
}

} // namespace

int main(int argc, char** argv) {
  const std::vector<std::string> arguments(argv + 1, argv + argc);
  const auto number = [&](std::size_t i) { return std::stod(arguments.at(i)); };
  const auto count = [&](std::size_t i) { return static_cast<Index>(number(i)); };
  try {
    const std::string work = arguments.at(0);
    if (work == "equilibrium") {
      time_equilibrium(count(1), arguments.size() > 2 ? arguments[2] : "");
    } else if (work == "steps") {
      time_steps(count(1), count(2));
    } else if (work == "frames") {
      time_thesis_frames(work, count(1), Boundary::Periodic, count(2), number(3));
    } else if (work == "walls") {
      time_walls(count(1), count(2));
    } else if (work == "thesis") {
      time_thesis_frames(work, 2000, Boundary::Free, 1000, 1e-9);
    } else if (work == "build") {
      time_build(count(1));
    } else if (work == "memory") {
      measure_memory(count(1));
    } else {
      throw std::invalid_argument("there is no work named " + work);
    }
  } catch (const std::exception& error) {
    std::cerr << "foam_benchmark: " << error.what() << '\n';
    return 1;
  }
  return 0;
}
