// SPDX-License-Identifier: GPL-3.0-or-later
//
// A build for GPUs on a machine without one, or one that hides it (CUDA_VISIBLE_DEVICES).
#include <iostream>
#include <sstream>

#include "algebra/device_direct_solver.h"
#include "base/error.h"
#include "coarsening/coarsening.h"
#include "construct/honeycomb.h"
#include "engines/engines.h"
#include "equilibrium/equilibrator.h"
#include "testing.h"

namespace foam {
namespace {

CoarseningOptions options_on(Device device) {
  CoarseningOptions options;
  options.topological_algorithm = TopologicalAlgorithm::Simultaneous;
  options.equilibrator.kind = EquilibratorKind::Junction;
  options.equilibrator.maximum_iterations = 4;
  options.equilibrator.device = device;
  return options;
}

template <class Make> std::string error_of(Make&& make) {
  try {
    make();
  } catch (const FoamError& error) {
    return error.what();
  }
  return "no error";
}

void cuda_is_a_clear_error() {
  const CoarseningOptions options = options_on(Device::CUDA);
  const std::string begin = "Device = CUDA, but there is no CUDA device to use: ";
  EXPECT_EQ(error_of([&] { make_coarsening(options); }).substr(0, begin.size()), begin);
  EXPECT_EQ(error_of([&] { make_equilibrator(options.equilibrator); }).substr(0, begin.size()),
            begin);
}

void auto_computes_on_the_cpu_and_says_so_once() {
  std::ostringstream said;
  std::streambuf* const old = std::clog.rdbuf(said.rdbuf());
  const Foam start = honeycomb({.columns = 6, .rows = 6, .displacement = 0.1});
  const auto coarsened = [&](Device device) {
    const auto coarsening = make_coarsening(options_on(device));
    coarsening->restart(start);
    EXPECT_TRUE(coarsening->advance({}));
    return coarsening->foam().position;
  };
  EXPECT_TRUE(coarsened(Device::Auto) == coarsened(Device::CPU));
  EXPECT_TRUE(coarsened(Device::Auto) == coarsened(Device::CPU));
  std::clog.rdbuf(old);
  const std::string text = said.str();
  EXPECT_TRUE(text.starts_with("Foam: Device = Auto computes on the CPU: "));
  EXPECT_EQ(text.find('\n'), text.size() - 1);
}

void a_direct_solver_that_is_not_built_is_a_clear_error() {
  if (!cuda::has_direct_solver()) {
    EXPECT_EQ(error_of([] { cuda::make_direct_solver(); }),
              "LinearSolver = Direct, but this build has no cuDSS");
  }
}

} // namespace
} // namespace foam

int main() {
  foam::cuda_is_a_clear_error();
  foam::auto_computes_on_the_cpu_and_says_so_once();
  foam::a_direct_solver_that_is_not_built_is_a_clear_error();
  return foam::test::failures > 0 ? 1 : 0;
}
