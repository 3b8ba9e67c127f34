// SPDX-License-Identifier: GPL-3.0-or-later
//
// The thesis's frame on the GPU, and frames with Newton's method there: how fast they are, and
// whether they do what the processor does. Writes a page in Markdown to the standard output;
// scripts/gpu-check runs it.
#include <cuda_runtime_api.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdint>
#include <iostream>
#include <memory>
#include <string>
#include <thread>
#include <utility>
#include <vector>

#include "algebra/device_direct_solver.h"
#include "base/error.h"
#include "coarsening/coarsening.h"
#include "construct/honeycomb.h"
#include "engines/engines.h"

namespace foam {
namespace {

using Clock = std::chrono::steady_clock;

constexpr const char* kFrameColumns =
    "| bubbles | frames | s | frames/s | iterations of the last | residual | T1 | T2 | GiB "
    "| s to fetch |\n|--|--|--|--|--|--|--|--|--|--|\n";
constexpr const char* kShowColumns =
    "| bubbles | MB fetched | s to sample | by the processor | s for statistics | by the processor "
    "| s to fetch the foam |\n|--|--|--|--|--|--|--|\n";
constexpr const char* kCompareColumns =
    "| bubbles | frames | same operations | same lengths | largest difference at the end "
    "| s a frame, device | s a frame, processor |\n|--|--|--|--|--|--|--|\n";

/// A disordered foam on a torus; its bubbles have an area of about 1 cm².
Foam start(Index columns, Index rows) {
  return honeycomb({.columns = columns, .rows = rows, .displacement = 0.1, .swaps = 0.2});
}

/// The thesis's time step and thresholds (Figure 4.19).
CoarseningOptions thesis_options() {
  CoarseningOptions options;
  options.time_step = 1.0 / 30;
  options.thresholds.kind = ThresholdKind::Absolute;
  return options;
}

/// The thesis's method and constants.
std::unique_ptr<Evolution> coarsening_on(Device device, Foam foam) {
  CoarseningOptions options = thesis_options();
  options.topological_algorithm = TopologicalAlgorithm::Simultaneous;
  options.equilibrator.kind = EquilibratorKind::Junction;
  options.equilibrator.device = device;
  auto coarsening = make_coarsening(options);
  coarsening->restart(std::move(foam));
  return coarsening;
}

/// Frames with Newton's method, and the thesis's thresholds.
std::unique_ptr<Evolution> newton_on(Device device, double tolerance, Foam foam,
                                     LinearSolver solver = LinearSolver::Iterative) {
  CoarseningOptions options = thesis_options();
  options.stepping = Stepping::FixedSteps;
  options.equilibrator.device = device;
  options.equilibrator.tolerance = tolerance;
  options.equilibrator.linear_solver = solver;
  auto coarsening = make_coarsening(options);
  coarsening->restart(std::move(foam));
  return coarsening;
}

/// Seconds for some frames. \throws FoamError if the foam cannot go on for so long.
double advance(Evolution& coarsening, int frames) {
  const auto begin = Clock::now();
  for (int frame = 0; frame < frames; ++frame) {
    if (!coarsening.advance({})) {
      throw FoamError("the foam cannot go on after " + std::to_string(frame) + " frames");
    }
  }
  return std::chrono::duration<double>(Clock::now() - begin).count();
}

std::array<std::int64_t, 3> operations(const Foam& foam) {
  return {foam.t1_count, foam.t2_count, foam.t3_count};
}

/// Largest relative difference of film lengths; infinite where the films differ.
double difference(const Foam& a, const Foam& b) {
  if (a.half_junction != b.half_junction) {
    return HUGE_VAL;
  }
  double largest = 0;
  for (const Film f : a.film_slots()) {
    if (a.has_film(f)) {
      largest = std::max(largest, std::abs(a.length(f.half()) / b.length(f.half()) - 1));
    }
  }
  return largest;
}

/// The same foam on both, frame by frame.
void compare(const std::unique_ptr<Evolution>& there, const std::unique_ptr<Evolution>& here,
             int frames) {
  const Index bubbles = here->foam().bubble_count();
  double seconds_there = 0;
  double seconds_here = 0;
  int same_operations = 0;
  int close = 0;
  for (int frame = 0; frame < frames; ++frame) {
    seconds_there += advance(*there, 1);
    seconds_here += advance(*here, 1);
    const bool same = operations(there->foam()) == operations(here->foam());
    same_operations += same && same_operations == frame ? 1 : 0;
    close += close == frame && difference(there->foam(), here->foam()) < 1e-8 ? 1 : 0;
  }
  std::cout << "| " << bubbles << " | " << frames << " | " << same_operations << " | " << close
            << " | " << difference(there->foam(), here->foam()) << " | " << seconds_there / frames
            << " | " << seconds_here / frames << " |" << std::endl;
}

/// Frames as they follow one another, the foam left on the device.
template <class Make> void time_frames(const Make& make, Index columns, Index rows, int frames) {
  std::size_t free_before = 0;
  std::size_t free_after = 0;
  std::size_t total = 0;
  cudaMemGetInfo(&free_before, &total);
  const auto coarsening = make(start(columns, rows));
  advance(*coarsening,
          1); // allocates, loads the kernels, and takes the foam to its first equilibrium
  const double seconds = advance(*coarsening, frames);
  cudaMemGetInfo(&free_after, &total);
  const auto fetch = Clock::now();
  const Foam& foam = coarsening->foam();
  const double transfer = std::chrono::duration<double>(Clock::now() - fetch).count();
  std::cout << "| " << columns * rows << " | " << frames << " | " << seconds << " | "
            << frames / seconds << " | " << foam.report.iterations << " | " << foam.report.residual
            << " | " << foam.t1_count << " | " << foam.t2_count << " | "
            << static_cast<double>(free_before - free_after) / 0x1p30 << " | " << transfer << " |"
            << std::endl;
}

/// Seconds of one call; the best of five.
template <class Call> double seconds_of(const Call& call) {
  double best = HUGE_VAL;
  for (int i = 0; i < 5; ++i) {
    const auto begin = Clock::now();
    call();
    best = std::min(best, std::chrono::duration<double>(Clock::now() - begin).count());
  }
  return best;
}

template <class T> std::size_t bytes(const std::vector<T>& values) {
  return values.size() * sizeof(T);
}

std::size_t bytes(const SampledFoam& sampled) {
  const FilmPolylines& films = sampled.films;
  const BubblePolygons& bubbles = sampled.bubbles;
  return bytes(films.points) + bytes(films.junction_id) + bytes(films.offsets) +
         bytes(films.connectivity) + bytes(films.left) + bytes(films.right) +
         bytes(films.curvature) + bytes(films.pressure_difference) + bytes(films.length) +
         bytes(films.half_angle) + bytes(films.on_boundary) + bytes(bubbles.points) +
         bytes(bubbles.offsets) + bytes(bubbles.each);
}

/// What is shown of a frame: made on the device and fetched, beside the processor, which has to
/// fetch the foam first.
void time_shown_frame(Index columns, Index rows) {
  const auto coarsening = coarsening_on(Device::CUDA, start(columns, rows));
  advance(*coarsening, 2);
  const std::size_t fetched = bytes(coarsening->sample(0));
  const double sample_there = seconds_of([&] { coarsening->sample(0); });
  const double statistics_there = seconds_of([&] { coarsening->statistics(false); });
  const auto fetch = Clock::now();
  const Foam& foam = coarsening->foam();
  const double transfer = std::chrono::duration<double>(Clock::now() - fetch).count();
  std::cout << "| " << columns * rows << " | " << static_cast<double>(fetched) / 1e6 << " | "
            << sample_there << " | " << seconds_of([&] { sample(foam, 0); }) << " | "
            << statistics_there << " | " << seconds_of([&] { statistics(foam, false); }) << " | "
            << transfer << " |" << std::endl;
}

} // namespace
} // namespace foam

/// With an argument: one frame of so many columns and rows alone, for a profiler.
int main(int argc, char** argv) {
  using namespace foam;
  cudaDeviceProp device{};
  if (cudaGetDeviceProperties(&device, 0) != cudaSuccess) {
    std::cerr << "There is no CUDA device to measure.\n";
    return 77;
  }
  if (argc > 1) {
    const auto columns = static_cast<Index>(std::stoi(argv[1]));
    coarsening_on(Device::CUDA, start(columns, columns))->advance({});
    return 0;
  }
  std::cout << "# The thesis's frame on a GPU\n\n"
            << device.name << ", compute capability " << device.major << '.' << device.minor << ", "
            << static_cast<double>(device.totalGlobalMem) / 0x1p30
            << " GiB, beside a processor with " << std::thread::hardware_concurrency()
            << " threads.\n\n## Frames that follow one another\n\n"
            << kFrameColumns;
  const auto thesis = [](Foam foam) { return coarsening_on(Device::CUDA, std::move(foam)); };
  time_frames(thesis, 50, 40, 1000); // the thesis's test: 72 minutes on a GTS 250
  time_frames(thesis, 320, 312, 100);
  time_frames(thesis, 1000, 1000, 20);
  std::cout << "\n## The same with Newton's method to a residual of 1e-5\n\n" << kFrameColumns;
  const auto newton = [](Foam foam) { return newton_on(Device::CUDA, 1e-5, std::move(foam)); };
  time_frames(newton, 50, 40, 100);
  time_frames(newton, 320, 312, 30);
  time_frames(newton, 1000, 1000, 10);
  std::cout << "\n## The same with its systems solved directly, by cuDSS\n\n";
  if (cuda::has_direct_solver()) {
    std::cout << kFrameColumns;
    const auto direct = [](Foam foam) {
      return newton_on(Device::CUDA, 1e-5, std::move(foam), LinearSolver::Direct);
    };
    time_frames(direct, 50, 40, 100);
    time_frames(direct, 320, 312, 5);
  } else {
    std::cout << "This build has no cuDSS.\n";
  }
  std::cout << "\n## What is shown of a frame\n\nBest of five, with the transfers.\n\n"
            << kShowColumns;
  time_shown_frame(50, 40);
  time_shown_frame(320, 312);
  time_shown_frame(1000, 1000);
  std::cout << "\n## Device and processor, the same foam\n\n"
            << "Frames from the first on in which the operations are the same, and in which all "
               "films' lengths are within 1e-8.\n\n"
            << kCompareColumns;
  const auto compare_thesis = [](Index columns, Index rows) {
    compare(coarsening_on(Device::CUDA, start(columns, rows)),
            coarsening_on(Device::CPU, start(columns, rows)), 100);
  };
  compare_thesis(50, 40);
  compare_thesis(320, 312);
  std::cout << "\n## The same with Newton's method to a residual of 1e-10\n\n" << kCompareColumns;
  const auto compare_newton = [](Index columns, Index rows, int frames) {
    compare(newton_on(Device::CUDA, 1e-10, start(columns, rows)),
            newton_on(Device::CPU, 1e-10, start(columns, rows)), frames);
  };
  compare_newton(50, 40, 100);
  compare_newton(320, 312, 10);
  return 0;
}
