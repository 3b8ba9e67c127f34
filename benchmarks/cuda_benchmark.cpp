// SPDX-License-Identifier: GPL-3.0-or-later
//
// The thesis's frame on the GPU: how fast it is, and whether it does what the processor does.
// Writes a page in Markdown to the standard output; scripts/gpu-check runs it.
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

#include "build/honeycomb.h"
#include "evolution/coarsening.h"

namespace foam {
namespace {

using Clock = std::chrono::steady_clock;

/// A disordered foam on a torus; its bubbles have an area of about 1 cm².
Foam start(Index columns, Index rows) {
  return honeycomb({.columns = columns, .rows = rows, .displacement = 0.1, .swaps = 0.2});
}

/// The thesis's method and constants (Figure 4.19).
std::unique_ptr<Coarsening> coarsening_on(Device device, Foam foam) {
  CoarseningOptions options;
  options.topological_algorithm = TopologicalAlgorithm::Bidding;
  options.equilibrator.kind = EquilibratorKind::Junction;
  options.equilibrator.device = device;
  auto coarsening = make_coarsening(options);
  coarsening->restart(std::move(foam));
  return coarsening;
}

/// Seconds for some frames. \throws FoamError if the foam cannot go on for so long.
double advance(Coarsening& coarsening, int frames) {
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
  for (Index f = 0; f < a.film_capacity(); ++f) {
    if (a.has_film(f)) {
      largest = std::max(largest, std::abs(a.length(2 * f) / b.length(2 * f) - 1));
    }
  }
  return largest;
}

/// The same foam on both, frame by frame.
void compare(Index columns, Index rows, int frames) {
  const auto there = coarsening_on(Device::CUDA, start(columns, rows));
  const auto here = coarsening_on(Device::CPU, start(columns, rows));
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
  std::cout << "| " << columns * rows << " | " << frames << " | " << same_operations << " | "
            << close << " | " << difference(there->foam(), here->foam()) << " | "
            << seconds_there / frames << " | " << seconds_here / frames << " |" << std::endl;
}

/// Frames as they follow one another, the foam left on the device.
void time_frames(Index columns, Index rows, int frames) {
  std::size_t free_before = 0;
  std::size_t free_after = 0;
  std::size_t total = 0;
  cudaMemGetInfo(&free_before, &total);
  const auto coarsening = coarsening_on(Device::CUDA, start(columns, rows));
  advance(*coarsening, 1); // allocates, and loads the kernels
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
            << "| bubbles | frames | s | frames/s | sweeps of the last | residual | T1 | T2 | GiB "
               "| s to fetch |\n|--|--|--|--|--|--|--|--|--|--|\n";
  time_frames(50, 40, 1000); // the thesis's test: 72 minutes on a GTS 250
  time_frames(320, 312, 100);
  time_frames(1000, 1000, 20);
  std::cout
      << "\n## Device and processor, the same foam\n\n"
      << "Frames from the first on in which the operations are the same, and in which all "
         "films' lengths are within 1e-8.\n\n"
      << "| bubbles | frames | same operations | same lengths | largest difference at the end "
         "| s a frame, device | s a frame, processor |\n|--|--|--|--|--|--|--|\n";
  compare(50, 40, 100);
  compare(320, 312, 100);
  return 0;
}
