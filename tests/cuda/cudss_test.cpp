// SPDX-License-Identifier: GPL-3.0-or-later
//
// How cuDSS is used, with an emulation that can be asked what has been done with it and made to
// fail.
#include <cudss.h>

#include <functional>
#include <map>
#include <string>

#include "algebra/device_direct_solver.h"
#include "base/error.h"
#include "construct/honeycomb.h"
#include "equilibrium/whole_foam_newton.h"
#include "mesh/device_foam.h"
#include "mesh/validate.h"
#include "parallel/gpu.cuh"
#include "testing.h"

namespace foam {
namespace {

using namespace cuda;

struct Found {
  Foam foam;
  newton::NewtonResult result;
};

/// Newton's equilibrium of a disordered foam.
Found equilibrate(std::unique_ptr<DirectSolver> direct, double t1_length) {
  Foam foam = honeycomb({.columns = 10, .rows = 10, .displacement = 0.1, .swaps = 0.2});
  DeviceFoam device;
  device.upload(foam);
  EquilibratorOptions options;
  options.tolerance = 1e-11;
  Gpu gpu;
  const newton::NewtonResult result = newton::WholeFoamNewton<Gpu>(gpu, options, std::move(direct))
                                          .equilibrate(device.view(), t1_length, {});
  device.download(foam);
  EXPECT_TRUE(result.report.converged);
  EXPECT_TRUE(validate(foam).empty());
  return {foam, result};
}

void expect_same_lengths(const Foam& a, const Foam& b) {
  EXPECT_TRUE(a.half_junction == b.half_junction);
  for (const Film f : a.film_slots()) {
    EXPECT_NEAR(a.length(f.half()), b.length(f.half()), 1e-9);
  }
}

void forget_counts() {
  cudss_emulation::analyses = 0;
  cudss_emulation::factorisations = 0;
}

void one_analysis_serves_until_a_film_is_swapped() {
  forget_counts();
  const Found direct = equilibrate(make_direct_solver(), 0);
  EXPECT_TRUE(direct.result.swaps.empty());
  EXPECT_EQ(direct.result.inner_iterations, 0);
  EXPECT_EQ(cudss_emulation::analyses, 1);
  EXPECT_EQ(cudss_emulation::factorisations, direct.result.report.iterations);
  expect_same_lengths(direct.foam, equilibrate(nullptr, 0).foam);
}

void it_is_done_again_after_a_swap() {
  forget_counts();
  const Found direct = equilibrate(make_direct_solver(), 0.4);
  EXPECT_TRUE(!direct.result.swaps.empty());
  EXPECT_EQ(direct.result.inner_iterations, 0);
  EXPECT_GT(cudss_emulation::analyses, 1);
  EXPECT_GT(cudss_emulation::factorisations, cudss_emulation::analyses);
}

void it_works_without_determinism() {
  const Found offered = equilibrate(make_direct_solver(), 0);
  forget_counts();
  cudss_emulation::offers_determinism = false;
  const Found refused = equilibrate(make_direct_solver(), 0);
  cudss_emulation::offers_determinism = true;
  EXPECT_EQ(cudss_emulation::analyses, 2); // it asks once
  EXPECT_TRUE(refused.foam.position == offered.foam.position);
}

/// A system of two equations: 4x + y = 6, x + 3y = 7.
std::string error_of_a_solution(DirectSolver& solver) {
  const DeviceArray<Index> first(std::vector<Index>{0, 1, 3});
  const DeviceArray<Index> column(std::vector<Index>{0, 0, 1});
  const DeviceArray<double> value(std::vector<double>{4, 1, 3});
  const DeviceArray<double> b(std::vector<double>{6, 7});
  DeviceArray<double> x(2);
  try {
    solver.solve({2, 3, first.data(), column.data(), value.data()}, b.data(), x.data());
  } catch (const FoamError& error) {
    return error.what();
  }
  EXPECT_NEAR(fetch(x)[0], 1, 1e-14);
  EXPECT_NEAR(fetch(x)[1], 2, 1e-14);
  return "";
}

void its_errors_are_ours() {
  const std::map<int, std::string> errors = {
      {CUDSS_PHASE_ANALYSIS, "cuDSS: the analysis failed: a kernel failed"},
      {CUDSS_PHASE_FACTORIZATION, "cuDSS: the factorisation failed: a kernel failed"},
      {CUDSS_PHASE_SOLVE, "cuDSS: the solution failed: a kernel failed"}};
  const auto solver = make_direct_solver();
  for (const auto& [phase, message] : errors) {
    cudss_emulation::failing_phase = phase;
    EXPECT_EQ(error_of_a_solution(*solver), message);
    cudss_emulation::failing_phase = 0;
    EXPECT_EQ(error_of_a_solution(*solver), "");
  }
}

void all_is_given_back() {
  EXPECT_EQ(cudss_emulation::objects, 0);
}

} // namespace
} // namespace foam

int main() {
  foam::one_analysis_serves_until_a_film_is_swapped();
  foam::it_is_done_again_after_a_swap();
  foam::it_works_without_determinism();
  foam::its_errors_are_ours();
  foam::all_is_given_back();
  return foam::test::failures > 0 ? 1 : 0;
}
