// SPDX-License-Identifier: GPL-3.0-or-later
//
// The device against the processor: the same algorithms on two machines (core/parallel/host.h,
// cuda/parallel/gpu.cuh). The processor's results are tested by themselves (tests/core).
#include <cuda_runtime_api.h>

#include <algorithm>
#include <cstdint>
#include <functional>
#include <iostream>
#include <map>
#include <memory>
#include <vector>

#include "../newton_on_host.h"
#include "../newton_system_members.h"
#include "../staircase.h"
#include "../two_sided_bubbles.h"
#include "algebra/device_direct_solver.h"
#include "coarsening/coarsening.h"
#include "construct/honeycomb.h"
#include "engines/engines.h"
#include "equilibrium/compressed_matrix.h"
#include "mesh/device_foam.h"
#include "mesh/film_set.h"
#include "mesh/validate.h"
#include "parallel/gpu.cuh"
#include "parallel/host.h"
#include "testing.h"
#include "thesis/jacobi_sweep.h"
#include "thesis/parallel_frame.h"
#include "thesis/rules.h"
#include "topology/collapse_operations.h"
#include "topology/operations.h"
#include "topology/reservations.h"

namespace foam {
namespace {

using cuda::DeviceArray;
using cuda::DeviceFoam;
using cuda::Gpu;

Foam disordered(Index columns = 40) {
  return honeycomb({.columns = columns, .rows = columns, .displacement = 0.1, .swaps = 0.2});
}

/// On a torus that is no rectangle, with films that have tensions of their own.
Foam uneven(Index columns = 40) {
  Foam foam = disordered(columns);
  const auto sheared = [](Vec2 p) { return Vec2{p.x + 0.2 * p.y, p.y}; };
  std::ranges::transform(foam.position, foam.position.begin(), sheared);
  auto& [origin, first, second] = foam.surroundings.lattice;
  foam.surroundings.lattice = {sheared(origin), sheared(first), sheared(second)};
  foam.film_tension.resize(foam.film_angle.size());
  for (const Film f : foam.film_slots()) {
    foam.film_tension[f] = foam.reference_tension() * (1 + 0.02 * (7 * f.index() % 11 - 5));
  }
  return foam;
}

/// Thresholds at which many films and bubbles of such a foam give way.
ThesisRules coarse_rules(TwoSidedBubbles two_sided = TwoSidedBubbles::Remove) {
  return {.limit = {.t1_length = 0.5, .t2_area = 0.8}, .two_sided_bubbles = two_sided};
}

CollapseOperations<ThesisRules> collapse_operations(std::uint8_t* swappable) {
  return {coarse_rules(), FieldView<Film, std::uint8_t>(swappable)};
}

SlideOperations slide_operations(std::uint8_t* waiting) {
  return {coarse_rules(TwoSidedBubbles::Slide).two_sided(),
          FieldView<Bubble, std::uint8_t>(waiting)};
}

void expect_same_topology(const Foam& a, const Foam& b) {
  EXPECT_TRUE(a.half_junction == b.half_junction);
  EXPECT_TRUE(a.half_bubble == b.half_bubble);
  EXPECT_TRUE(a.junction_half == b.junction_half);
  EXPECT_TRUE(a.bubble_half == b.bubble_half);
  EXPECT_TRUE(a.sides == b.sides);
  EXPECT_TRUE(a.film_wrap == b.film_wrap);
}

double largest_difference(const std::vector<Vec2>& a, const std::vector<Vec2>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, norm(a[i] - b[i]));
  }
  return largest;
}

double largest_difference(const std::vector<Point3>& a, const std::vector<Point3>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::hypot(a[i][0] - b[i][0], a[i][1] - b[i][1]));
  }
  return largest;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
  double largest = 0;
  for (std::size_t i = 0; i < a.size(); ++i) {
    largest = std::max(largest, std::abs(a[i] - b[i]));
  }
  return largest;
}

struct Square {
  FOAM_HOST_DEVICE std::int64_t operator()(Index i) const { return std::int64_t{i} * i; }
};

struct WriteSquare {
  std::int64_t* to;

  FOAM_HOST_DEVICE void operator()(Index i) const { to[i] = Square{}(i); }
};

void reductions() {
  Gpu gpu;
  for (const Index n : {0, 1, 127, 128, 129, 1000000}) {
    const std::int64_t m = n;
    EXPECT_EQ(gpu.reduce(n, std::int64_t{5}, Square{}, parallel::Add{}),
              5 + (m - 1) * m * (2 * m - 1) / 6);
  }
}

void arrays() {
  Gpu gpu;
  const Index n = 100001;
  DeviceArray<std::int64_t> squares(n);
  gpu.for_each(n, WriteSquare{squares.data()});
  std::vector<std::int64_t> fetched;
  squares.download(fetched);
  for (Index i = 0; i < n; ++i) {
    EXPECT_EQ(fetched[place_of(i)], Square{}(i));
  }
  DeviceArray<std::int64_t> copy;
  copy.copy_from(squares);
  std::vector<std::int64_t> fetched_copy;
  copy.download(fetched_copy);
  EXPECT_TRUE(fetched_copy == fetched);

  for (const Foam& foam : {uneven(), disordered()}) {
    DeviceFoam device;
    device.upload(foam);
    Foam back = uneven(4);
    device.download(back);
    for_each_array([](const auto& here, const auto& there) { EXPECT_TRUE(here == there); }, foam,
                   back);
    EXPECT_TRUE(device.view().surroundings == foam.surroundings);
    EXPECT_EQ(device.view().has_uniform_tension(), foam.has_uniform_tension());
  }
}

void sorting() {
  Gpu gpu;
  std::vector<std::uint64_t> keys(100001);
  for (std::size_t i = 0; i < keys.size(); ++i) {
    keys[i] = (i * 2654435761U) % 1000003U << 32 | i;
  }
  DeviceArray<std::uint64_t> there(keys);
  gpu.sort(there.data(), static_cast<Index>(keys.size()));
  std::vector<std::uint64_t> fetched;
  there.download(fetched);
  std::sort(keys.begin(), keys.end());
  EXPECT_TRUE(fetched == keys);
}

void sums() {
  Gpu gpu;
  Host host;
  for (const std::size_t n : {0, 1, 127, 128, 129, 1000000}) {
    std::vector<std::int64_t> here(n + 1);
    for (std::size_t i = 0; i < n; ++i) {
      here[i] = static_cast<std::int64_t>(i * i % 7);
    }
    DeviceArray<std::int64_t> there(here);
    const auto size = static_cast<Index>(n);
    const std::int64_t sum_there = gpu.exclusive_scan(there.data(), size);
    EXPECT_EQ(sum_there, host.exclusive_scan(here.data(), size));
    EXPECT_TRUE(fetch(there) == here);
  }
}

void update_order() {
  Foam foam = disordered();
  DeviceFoam device;
  device.upload(foam);
  Gpu gpu;
  Host host;
  thesis::UpdateOrder<Gpu> on_gpu(gpu);
  thesis::UpdateOrder<Host> on_host(host);
  for (const int reach : {0, 1, 2}) {
    on_gpu.find(const_view(device.view()), reach);
    on_host.find(const_view(view_of(foam)), reach);
    EXPECT_EQ(on_gpu.waves(), on_host.waves());
    std::vector<Index> waves(foam.position.size());
    cuda::check(cudaMemcpy(waves.data(), on_gpu.wave().data(), waves.size() * sizeof(Index),
                           cudaMemcpyDeviceToHost),
                "cudaMemcpy");
    EXPECT_TRUE(std::equal(waves.begin(), waves.end(), on_host.wave().data()));
  }
}

void sweep() {
  for (const bool orientation : {false, true}) {
    for (const RootSearch search : {RootSearch::Angles, RootSearch::Energies}) {
      JunctionOptions options;
      options.orientation_invariant = orientation;
      options.root_search = search;
      Foam foam = disordered();
      DeviceFoam device;
      device.upload(foam);
      Gpu gpu;
      Host host;
      thesis::JacobiSweep<Gpu> on_gpu(gpu, options);
      thesis::JacobiSweep<Host> on_host(host, options);
      on_gpu.prepare(device.view());
      on_host.prepare(view_of(foam));
      const thesis::Maxima there = on_gpu.sweep(device.view());
      const thesis::Maxima here = on_host.sweep(view_of(foam));
      EXPECT_GT(here.position, 1e-3);
      EXPECT_NEAR(there.position, here.position, 1e-9);
      EXPECT_NEAR(there.pressure, here.pressure, 1e-9);
      EXPECT_EQ(there.solvable, here.solvable);
      Foam fetched = foam;
      device.download(fetched);
      EXPECT_NEAR(largest_difference(fetched.position, foam.position), 0, 1e-9);
      EXPECT_NEAR(largest_difference(fetched.pressure, foam.pressure), 0, 1e-9);
    }
  }
}

void reservations() {
  Foam foam = disordered();
  DeviceFoam device;
  device.upload(foam);
  Gpu gpu;
  Host host;
  std::vector<std::uint8_t> swappable(foam.film_angle.size(), 1);
  DeviceArray<std::uint8_t> swappable_there(swappable);
  Reservations<Gpu> on_gpu(gpu);
  Reservations<Host> on_host(host);
  const std::int64_t there = on_gpu.run(device.view(), collapse_operations(swappable_there.data()));
  const std::int64_t here = on_host.run(view_of(foam), collapse_operations(swappable.data()));
  EXPECT_GT(here, 100);
  EXPECT_EQ(there, here);
  const std::vector<TopologicalOperation> performed_there = on_gpu.take_performed();
  const std::vector<TopologicalOperation> performed_here = on_host.take_performed();
  EXPECT_EQ(performed_there.size(), performed_here.size());
  for (std::size_t i = 0; i < std::min(performed_here.size(), performed_there.size()); ++i) {
    EXPECT_TRUE(performed_there[i].kind == performed_here[i].kind);
    EXPECT_TRUE(performed_there[i].bubbles == performed_here[i].bubbles);
    EXPECT_NEAR(norm(performed_there[i].place - performed_here[i].place), 0, 1e-9);
  }
  Foam fetched = foam;
  device.download(fetched);
  EXPECT_TRUE(validate(fetched).empty());
  expect_same_topology(fetched, foam);
  EXPECT_NEAR(largest_difference(fetched.position, foam.position), 0, 1e-9);
  EXPECT_NEAR(largest_difference(fetched.target_area, foam.target_area), 0, 1e-9);
}

void sliding() {
  Foam foam = test::with_two_sided_bubbles(disordered());
  DeviceFoam device;
  device.upload(foam);
  Gpu gpu;
  Host host;
  std::vector<std::uint8_t> waiting(foam.bubble_half.size(), 1);
  DeviceArray<std::uint8_t> waiting_there(waiting);
  const auto there =
      Reservations<Gpu>(gpu).run(device.view(), slide_operations(waiting_there.data()));
  const auto here = Reservations<Host>(host).run(view_of(foam), slide_operations(waiting.data()));
  EXPECT_GT(here, 10);
  EXPECT_EQ(there, here);
  Foam fetched = foam;
  device.download(fetched);
  EXPECT_NEAR(largest_difference(fetched.position, foam.position), 0, 1e-9);
  EXPECT_NEAR(largest_difference(fetched.film_angle, foam.film_angle), 0, 1e-9);
}

/// The thesis's time step and thresholds (Figure 4.19).
CoarseningOptions options_on(Device device) {
  CoarseningOptions options;
  options.time_step = 1.0 / 30;
  options.thresholds.kind = ThresholdKind::Absolute;
  options.topological_algorithm = TopologicalAlgorithm::Simultaneous;
  options.stepping = Stepping::FixedSteps;
  options.equilibrator.kind = EquilibratorKind::Junction;
  options.equilibrator.device = device;
  return options;
}

Foam coarsened(const CoarseningOptions& options, Foam foam, int frames) {
  const auto coarsening = make_coarsening(options);
  coarsening->restart(std::move(foam));
  for (int frame = 0; frame < frames; ++frame) {
    EXPECT_TRUE(coarsening->advance({}));
  }
  return coarsening->foam();
}

void frames() {
  for (const TwoSidedBubbles two_sided : {TwoSidedBubbles::Remove, TwoSidedBubbles::Slide}) {
    for (const bool relative : {false, true}) {
      const auto on = [&](Device device) {
        CoarseningOptions options = options_on(device);
        options.two_sided_bubbles = two_sided;
        options.thresholds.kind = relative ? ThresholdKind::Relative : ThresholdKind::Absolute;
        return coarsened(options, disordered(20), 10);
      };
      const Foam there = on(Device::CUDA);
      const Foam here = on(Device::CPU);
      EXPECT_TRUE(validate(there).empty());
      EXPECT_EQ(there.t1_count, here.t1_count);
      EXPECT_EQ(there.t2_count, here.t2_count);
      EXPECT_EQ(there.t3_count, here.t3_count);
      EXPECT_EQ(there.time, here.time);
      EXPECT_EQ(there.report.iterations, here.report.iterations);
      expect_same_topology(there, here);
      EXPECT_NEAR(there.energy() / here.energy(), 1, 1e-8);
    }
  }
}

void repetition() {
  const auto run = [] { return coarsened(options_on(Device::CUDA), disordered(), 5); };
  const Foam once = run();
  const Foam again = run();
  EXPECT_TRUE(once.position == again.position);
  EXPECT_TRUE(once.pressure == again.pressure);
  EXPECT_TRUE(once.film_angle == again.film_angle);
  EXPECT_TRUE(once.target_area == again.target_area);
  expect_same_topology(once, again);
}

Foam double_bubble() {
  FilmSet set;
  set.surface_tension = 0.25;
  set.junctions = {{0, -0.5}, {0, 0.5}};
  set.films = {{0, 1, 0, 1, 0.0, {}}, {1, 0, 0, -1, 1.3, {}}, {0, 1, 1, -1, 1.3, {}}};
  set.bubbles = {{0, 0.0, 1}, {1, 0.0, 3}};
  return foam_of(set);
}

void end() {
  CoarseningOptions options = options_on(Device::CUDA);
  options.thresholds.t2_area = 2;
  const auto coarsening = make_coarsening(options);
  coarsening->restart(double_bubble());
  EXPECT_TRUE(!coarsening->advance({}));
  EXPECT_TRUE(coarsening->foam().target_area == double_bubble().target_area);
  EXPECT_TRUE(coarsening->record().ended.has_value());
  EXPECT_EQ(coarsening->record().ended->bubble, 0);

  // Arcs about 90°, which the processor's factorisations are needed for.
  options = options_on(Device::CUDA);
  options.equilibrator.kind = EquilibratorKind::Newton;
  options.time_step = 0.05;
  const auto newton = make_coarsening(options);
  newton->restart(double_bubble());
  while (newton->advance({})) {
    EXPECT_TRUE(newton->record().report.converged);
  }
  EXPECT_TRUE(newton->record().ended->cause == End::Cause::LastTwo);
  EXPECT_EQ(newton->foam().bubble_count(), 2);
}

void abort() {
  const Foam start = disordered(20);
  const auto coarsening = make_coarsening(options_on(Device::CUDA));
  coarsening->restart(start);
  bool aborted = false;
  try {
    coarsening->advance([] { return true; });
  } catch (const Aborted&) {
    aborted = true;
  }
  EXPECT_TRUE(aborted);
  EXPECT_TRUE(coarsening->foam().position == start.position);
  EXPECT_TRUE(coarsening->foam().target_area == start.target_area);
}

void equilibrator() {
  const auto equilibrated = [](Device device) {
    Foam foam = disordered(20);
    make_equilibrator(options_on(device).equilibrator)->equilibrate(foam, 0, {});
    return foam;
  };
  const Foam there = equilibrated(Device::CUDA);
  const Foam here = equilibrated(Device::CPU);
  EXPECT_EQ(there.report.iterations, here.report.iterations);
  EXPECT_EQ(there.report.converged, here.report.converged);
  EXPECT_NEAR(there.report.residual, here.report.residual, 1e-8);
  EXPECT_NEAR(largest_difference(there.position, here.position), 0, 1e-8);
}

/// A foam that has lost bubbles, on both sides.
std::unique_ptr<Evolution> coarsened_there() {
  auto coarsening = make_coarsening(options_on(Device::CUDA));
  coarsening->restart(disordered());
  for (int frame = 0; frame < 3; ++frame) {
    EXPECT_TRUE(coarsening->advance({}));
  }
  return coarsening;
}

void sampling() {
  const auto coarsening = coarsened_there();
  for (const double chord_error : {0.0, 1e-4}) {
    const SampledFoam there = coarsening->sample(chord_error);
    const SampledFoam here = foam::sample(coarsening->foam(), chord_error);
    EXPECT_GT(here.films.points.size(), 5000u);
    EXPECT_NEAR(there.energy / here.energy, 1, 1e-12);
    EXPECT_EQ(there.record.time, here.record.time);
    EXPECT_EQ(there.record.t1_count, here.record.t1_count);
    EXPECT_EQ(there.films.points.size(), here.films.points.size());
    EXPECT_NEAR(largest_difference(there.films.points, here.films.points), 0, 1e-12);
    EXPECT_TRUE(there.films.junction_id == here.films.junction_id);
    EXPECT_TRUE(there.films.offsets == here.films.offsets);
    EXPECT_TRUE(there.films.connectivity == here.films.connectivity);
    EXPECT_TRUE(there.films.left == here.films.left);
    EXPECT_TRUE(there.films.right == here.films.right);
    EXPECT_NEAR(largest_difference(there.films.curvature, here.films.curvature), 0, 1e-12);
    EXPECT_TRUE(there.films.pressure_difference == here.films.pressure_difference);
    EXPECT_NEAR(largest_difference(there.films.length, here.films.length), 0, 1e-12);
    EXPECT_TRUE(there.films.half_angle == here.films.half_angle);
    EXPECT_TRUE(there.films.on_boundary == here.films.on_boundary);
    EXPECT_TRUE(there.bubbles.offsets == here.bubbles.offsets);
    EXPECT_NEAR(largest_difference(there.bubbles.points, here.bubbles.points), 0, 1e-10);
    EXPECT_TRUE(coarsening->sample(chord_error).films.points == there.films.points);
  }
}

void sampling_of_tensions() {
  CoarseningOptions options = options_on(Device::CUDA);
  options.equilibrator.kind = EquilibratorKind::Newton;
  const auto coarsening = make_coarsening(options);
  coarsening->restart(uneven());
  const SampledFoam there = coarsening->sample(0);
  const SampledFoam here = foam::sample(coarsening->foam(), 0);
  EXPECT_EQ(here.films.tension.size(), here.films.length.size());
  EXPECT_TRUE(there.films.tension == here.films.tension);
  EXPECT_NEAR(there.energy / here.energy, 1, 1e-12);
  EXPECT_NEAR(largest_difference(there.bubbles.points, here.bubbles.points), 0, 1e-10);
}

void statistics_of_bubbles() {
  const auto coarsening = coarsened_there();
  const FoamStatistics there = coarsening->statistics(true);
  const FoamStatistics here = foam::statistics(coarsening->foam(), true);
  EXPECT_GT(here.by_sides.size(), 2u);
  EXPECT_EQ(there.bubbles, here.bubbles);
  EXPECT_EQ(there.mean_sides, here.mean_sides);
  EXPECT_EQ(there.mu2, here.mu2);
  EXPECT_NEAR(there.mean_area, here.mean_area, 1e-12);
  EXPECT_NEAR(there.area_second_moment, here.area_second_moment, 1e-12);
  EXPECT_NEAR(there.energy / here.energy, 1, 1e-12);
  EXPECT_NEAR(there.aboav, here.aboav, 1e-10);
  EXPECT_EQ(there.by_sides.size(), here.by_sides.size());
  for (std::size_t i = 0; i < here.by_sides.size(); ++i) {
    EXPECT_EQ(there.by_sides[i].sides, here.by_sides[i].sides);
    EXPECT_EQ(there.by_sides[i].count, here.by_sides[i].count);
    EXPECT_NEAR(there.by_sides[i].mean_neighbour_sides, here.by_sides[i].mean_neighbour_sides,
                1e-12);
    EXPECT_NEAR(there.by_sides[i].mean_relative_area, here.by_sides[i].mean_relative_area, 1e-12);
  }
  EXPECT_EQ(there.each.size(), here.each.size());
  for (std::size_t i = 0; i < here.each.size(); ++i) {
    EXPECT_EQ(there.each[i].id, here.each[i].id);
    EXPECT_EQ(there.each[i].sides, here.each[i].sides);
    EXPECT_NEAR(there.each[i].area, here.each[i].area, 1e-12);
    EXPECT_NEAR(there.each[i].perimeter, here.each[i].perimeter, 1e-12);
  }
  EXPECT_EQ(coarsening->statistics(true).mean_area, there.mean_area);
  EXPECT_EQ(coarsening->statistics(true).energy, there.energy);
}

template <class T> std::vector<T> fetch(const T* there, std::size_t size) {
  std::vector<T> here(size);
  cuda::check(cudaMemcpy(here.data(), there, size * sizeof(T), cudaMemcpyDeviceToHost),
              "cudaMemcpy");
  return here;
}

void expect_same_matrix(const LowerTriangle& there, const LowerTriangle& here) {
  EXPECT_EQ(there.size, here.size);
  EXPECT_EQ(there.entries, here.entries);
  const auto rows = place_of(here.size) + 1;
  const auto entries = place_of(here.entries);
  EXPECT_TRUE(fetch(there.first, rows) == std::vector(here.first, here.first + rows));
  EXPECT_TRUE(fetch(there.column, entries) == std::vector(here.column, here.column + entries));
  EXPECT_NEAR(largest_difference(fetch(there.value, entries),
                                 std::vector(here.value, here.value + entries)),
              0, 1e-10);
}

void newton_system() {
  Foam foam = disordered();
  DeviceFoam device;
  device.upload(foam);
  Gpu gpu;
  Host host;
  test::NewtonSystem<Gpu> on_gpu(gpu, device.view(), foam.mean_spacing(), 0.5);
  test::NewtonSystem<Host> on_host(host, view_of(foam), foam.mean_spacing(), 0.5);
  std::vector<double> x(place_of(on_host.size()));
  for (std::size_t i = 0; i < x.size(); ++i) {
    x[i] = std::sin(static_cast<double>(i));
  }
  std::vector<double> here(x.size());
  std::vector<double> fetched;
  DeviceArray<double> x_there(x);
  DeviceArray<double> there(x.size());
  on_gpu.multiply(x_there.data(), there.data());
  on_host.multiply(x.data(), here.data());
  there.download(fetched);
  EXPECT_NEAR(largest_difference(fetched, here), 0, 1e-10);
  on_gpu.precondition(x_there.data(), there.data());
  on_host.precondition(x.data(), here.data());
  there.download(fetched);
  EXPECT_NEAR(largest_difference(fetched, here), 0, 1e-8);
  expect_same_matrix(on_gpu.assemble(), on_host.assemble());
}

EquilibratorOptions newton_on(Device device) {
  EquilibratorOptions options;
  options.device = device;
  options.tolerance = 1e-11;
  return options;
}

/// To the same equilibrium; with no T1s, so that there is but one.
void newton_equilibrator() {
  for (const Foam& start : {disordered(20), uneven(20)}) {
    Foam there = start;
    Foam here = start;
    make_equilibrator(newton_on(Device::CUDA))->equilibrate(there, 0, {});
    test::KrylovEquilibrator(newton_on(Device::CPU)).equilibrate(here, 0, {});
    EXPECT_TRUE(there.report.converged);
    EXPECT_TRUE(here.report.converged);
    EXPECT_EQ(there.report.iterations, here.report.iterations);
    expect_same_topology(there, here);
    for (const Film f : here.film_slots()) {
      EXPECT_NEAR(there.length(f.half()), here.length(f.half()), 1e-8);
    }
  }
}

void newton_repetition() {
  const auto run = [] {
    Foam foam = disordered(20);
    make_equilibrator(newton_on(Device::CUDA))->equilibrate(foam, 0.3, {});
    return foam;
  };
  const Foam once = run();
  const Foam again = run();
  EXPECT_TRUE(once.position == again.position);
  EXPECT_TRUE(once.pressure == again.pressure);
  EXPECT_TRUE(once.film_angle == again.film_angle);
  expect_same_topology(once, again);
}

void newton_abort() {
  const Foam start = disordered(20);
  Foam foam = start;
  bool aborted = false;
  try {
    make_equilibrator(newton_on(Device::CUDA))->equilibrate(foam, 0.3, [] { return true; });
  } catch (const Aborted&) {
    aborted = true;
  }
  EXPECT_TRUE(aborted);
  EXPECT_TRUE(foam.position == start.position);
  expect_same_topology(foam, start);
}

/// Frames with Newton's equilibria, with T1s and T2s.
void newton_frames() {
  for (const Foam& start : {disordered(16), uneven(16)}) {
    const auto on = [&](Device device) {
      CoarseningOptions options = options_on(device);
      options.equilibrator.kind = EquilibratorKind::Newton;
      options.equilibrator.tolerance = 1e-10;
      options.thresholds.t1_length = 0.3;
      options.thresholds.t2_area = 0.6;
      return coarsened(options, start, 10);
    };
    const Foam there = on(Device::CUDA);
    const Foam here = on(Device::CPU);
    EXPECT_TRUE(there.report.converged);
    EXPECT_TRUE(here.report.converged);
    EXPECT_GT(here.t1_count + here.t2_count, 0);
    EXPECT_EQ(there.t1_count, here.t1_count);
    EXPECT_EQ(there.t2_count, here.t2_count);
    expect_same_topology(there, here);
    EXPECT_NEAR(there.energy() / here.energy(), 1, 1e-9);
  }
}

/// A double row in a channel, of uneven bubbles, some of which have changed neighbours.
void frames_between_walls() {
  Foam start = test::staircase(8, 1, 0.5);
  for (const Index zig_zag : {0, 18}) { // films
    perform_t1(start, Film(zig_zag));
  }
  double sum = 0;
  for (const Bubble b : start.bubble_slots()) {
    start.target_area[b] = 0.5 * (1 + 0.1 * (7 * b.index() % 11 - 5));
    sum += start.target_area[b];
  }
  for (double& area : start.target_area) {
    area *= 8 / sum;
  }
  const auto on = [&](Device device) {
    CoarseningOptions options = options_on(device);
    options.equilibrator.kind = EquilibratorKind::Newton;
    options.equilibrator.tolerance = 1e-10;
    options.thresholds.t1_length = 0.05;
    options.thresholds.t2_area = 0.05;
    options.time_step = 0.02;
    return coarsened(options, start, 30);
  };
  const Foam there = on(Device::CUDA);
  const Foam here = on(Device::CPU);
  double gas = 0;
  for (const Bubble b : there.bubble_slots()) {
    gas += there.has_bubble(b) ? there.area(b) : 0;
  }
  EXPECT_NEAR(gas, 8, 1e-9);
  EXPECT_TRUE(there.report.converged);
  EXPECT_TRUE(validate(there).empty());
  EXPECT_GT(here.t1_count, 2);
  EXPECT_EQ(there.t1_count, here.t1_count);
  EXPECT_EQ(there.t2_count, here.t2_count);
  expect_same_topology(there, here);
  EXPECT_NEAR(there.energy() / here.energy(), 1, 1e-9);
}

bool without_direct_solver() {
  if (cuda::has_direct_solver()) {
    return false;
  }
  std::cout << "SKIPPED: this build has no cuDSS\n";
  test::skipped = true;
  return true;
}

EquilibratorOptions directly(EquilibratorOptions options) {
  options.linear_solver = LinearSolver::Direct;
  return options;
}

/// To the equilibrium that MINRES leads to.
void direct_solver() {
  if (without_direct_solver()) {
    return;
  }
  Foam direct = disordered(12);
  Foam iterative = direct;
  make_equilibrator(directly(newton_on(Device::CUDA)))->equilibrate(direct, 0, {});
  make_equilibrator(newton_on(Device::CUDA))->equilibrate(iterative, 0, {});
  EXPECT_TRUE(direct.report.converged);
  EXPECT_TRUE(iterative.report.converged);
  expect_same_topology(direct, iterative);
  for (const Film f : direct.film_slots()) {
    EXPECT_NEAR(direct.length(f.half()), iterative.length(f.half()), 1e-9);
  }
}

/// It swaps films; the same bits as far as cuDSS gives them.
void direct_repetition() {
  if (without_direct_solver()) {
    return;
  }
  const auto run = [] {
    Foam foam = disordered(12);
    make_equilibrator(directly(newton_on(Device::CUDA)))->equilibrate(foam, 0.3, {});
    EXPECT_TRUE(foam.report.converged);
    return foam;
  };
  const Foam once = run();
  const Foam again = run();
  expect_same_topology(once, again);
  EXPECT_NEAR(largest_difference(once.position, again.position), 0, 1e-8);
}

/// Frames through the same equilibria as long as nothing is swapped. Where films may be, exact
/// steps may come by others than those that are almost so.
void direct_frames() {
  if (without_direct_solver()) {
    return;
  }
  const auto frames = [](LinearSolver solver, double t1_length, double t2_area) {
    CoarseningOptions options = options_on(Device::CUDA);
    options.equilibrator.kind = EquilibratorKind::Newton;
    options.equilibrator.tolerance = 1e-10;
    options.equilibrator.linear_solver = solver;
    options.time_step = 0.01;
    options.thresholds.t1_length = t1_length;
    options.thresholds.t2_area = t2_area;
    const Foam foam = coarsened(options, disordered(12), 5);
    EXPECT_TRUE(foam.report.converged);
    EXPECT_TRUE(validate(foam).empty());
    return foam;
  };
  const Foam direct = frames(LinearSolver::Direct, 0, 0);
  const Foam iterative = frames(LinearSolver::Iterative, 0, 0);
  EXPECT_EQ(direct.t1_count, 0);
  EXPECT_EQ(direct.t2_count, 0);
  expect_same_topology(direct, iterative);
  EXPECT_NEAR(direct.energy() / iterative.energy(), 1, 1e-9);

  const Foam eventful = frames(LinearSolver::Direct, 0.3, 0.6);
  EXPECT_GT(eventful.t1_count, 0);
  EXPECT_GT(eventful.t2_count, 0);
  double gas = 0;
  for (const Bubble b : eventful.bubble_slots()) {
    gas += eventful.has_bubble(b) ? eventful.target_area[b] : 0;
  }
  EXPECT_NEAR(gas / eventful.surroundings.lattice.area(), 1, 1e-12);
}

} // namespace
} // namespace foam

int main(int argc, char** argv) {
  using namespace foam;
  const std::map<std::string, std::function<void()>> tests = {
      {"reductions", reductions},
      {"arrays", arrays},
      {"update_order", update_order},
      {"sweep", sweep},
      {"reservations", reservations},
      {"sliding", sliding},
      {"frames", frames},
      {"repetition", repetition},
      {"end", end},
      {"abort", foam::abort},
      {"equilibrator", equilibrator},
      {"sorting", sorting},
      {"sums", sums},
      {"sampling", sampling},
      {"sampling_of_tensions", sampling_of_tensions},
      {"statistics", statistics_of_bubbles},
      {"newton_system", newton_system},
      {"newton_equilibrator", newton_equilibrator},
      {"newton_repetition", newton_repetition},
      {"newton_abort", newton_abort},
      {"newton_frames", newton_frames},
      {"frames_between_walls", frames_between_walls},
      {"direct_solver", direct_solver},
      {"direct_repetition", direct_repetition},
      {"direct_frames", direct_frames}};
  int devices = 0;
  if (cudaGetDeviceCount(&devices) != cudaSuccess || devices == 0) {
    std::cout << "SKIPPED: there is no CUDA device\n";
    return 77;
  }
  for (const auto& [name, test] : tests) {
    if (argc < 2 || name == argv[1]) {
      std::cout << name << std::endl;
      test();
    }
  }
  if (test::failures > 0 || (argc > 1 && !tests.contains(argv[1]))) {
    return 1;
  }
  return argc > 1 && test::skipped ? 77 : 0;
}
