// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/accelerator.h"

#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <string>

#include "base/error.h"
#include "coarsening/newton_frame_coarsening.h"
#include "engines/engines.h"
#include "foams.h"

namespace foam {
namespace {

bool device_is_there = false;
int made = 0; ///< by the accelerator

/// An accelerator that makes what the processor computes with.
void register_one() {
  register_cuda({[] { return std::string(device_is_there ? "" : "it is not plugged in"); },
                 [](const EquilibratorOptions&) { return std::unique_ptr<Equilibrator>(); },
                 [](const CoarseningOptions& options) -> std::unique_ptr<Coarsening> {
                   ++made;
                   return std::make_unique<NewtonFrameCoarsening>(options);
                 }});
}

const Method kOnGpu{Method::Work::Equilibrium, "", nullptr, OnGpu::Yes, ""};
const Method kIfAsked{Method::Work::Equilibrium, "", nullptr, OnGpu::Asked,
                      "it has to be asked for"};
const Method kNever{Method::Work::Equilibrium, "", nullptr, OnGpu::No, "it cannot"};

std::string error_of(Device device, const Method& method) {
  try {
    accelerator_for(device, method);
  } catch (const FoamError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Accelerator, IsTakenWhereItIsThereAndCan) {
  register_one();
  device_is_there = true;
  EXPECT_NE(accelerator_for(Device::CUDA, kOnGpu), nullptr);
  EXPECT_NE(accelerator_for(Device::Auto, kOnGpu), nullptr);
  EXPECT_EQ(accelerator_for(Device::CPU, kOnGpu), nullptr);
  EXPECT_NE(accelerator_for(Device::CUDA, kIfAsked), nullptr);
  EXPECT_EQ(accelerator_for(Device::Auto, kIfAsked), nullptr);
  EXPECT_EQ(accelerator_for(Device::Auto, kNever), nullptr);
  EXPECT_EQ(error_of(Device::CUDA, kNever), "Device = CUDA, but it cannot");
}

TEST(Accelerator, AutoSaysOnceThatItIsNotThere) {
  register_one();
  device_is_there = false;
  testing::internal::CaptureStderr();
  EXPECT_EQ(accelerator_for(Device::Auto, kOnGpu), nullptr);
  EXPECT_EQ(accelerator_for(Device::Auto, kOnGpu), nullptr);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "Foam: Device = Auto computes on the CPU: it is not plugged in\n");
  EXPECT_EQ(error_of(Device::CUDA, kOnGpu), "Device = CUDA, but it is not plugged in");
}

OnGpu equilibrium_of(const CoarseningOptions& options) {
  return method_for(Method::Work::Equilibrium, options).gpu;
}

OnGpu coarsening_of(const CoarseningOptions& options) {
  return method_for(Method::Work::Coarsening, options).gpu;
}

TEST(Methods, AreOnTheGpuWhereTheyAreTheSameThere) {
  CoarseningOptions options;
  EXPECT_EQ(equilibrium_of(options), OnGpu::Asked) << "Newton may swap other films";
  EXPECT_EQ(coarsening_of(options), OnGpu::No) << "from event to event";
  options.stepping = Stepping::FixedSteps;
  EXPECT_EQ(coarsening_of(options), OnGpu::Yes);
  options.equilibrator.kind = EquilibratorKind::Junction;
  EXPECT_EQ(equilibrium_of(options), OnGpu::Yes);
  for (const auto algorithm : {TopologicalAlgorithm::Final, TopologicalAlgorithm::Original,
                               TopologicalAlgorithm::Improved}) {
    options.topological_algorithm = algorithm;
    EXPECT_EQ(coarsening_of(options), OnGpu::No);
  }
  options.topological_algorithm = TopologicalAlgorithm::Simultaneous;
  EXPECT_EQ(coarsening_of(options), OnGpu::Yes);
  options.equilibrator.junction.sweep = Sweep::GaussSeidel;
  EXPECT_EQ(equilibrium_of(options), OnGpu::No) << "one after the other";
  EXPECT_EQ(coarsening_of(options), OnGpu::No);
}

TEST(Methods, AreChosenByNoOptionsOfOthers) {
  CoarseningOptions options;
  options.topological_algorithm = TopologicalAlgorithm::Simultaneous;
  EXPECT_EQ(coarsening_of(options), OnGpu::No) << "of the thesis alone";
  options.equilibrator.kind = EquilibratorKind::Junction;
  options.topological_algorithm = TopologicalAlgorithm::Final;
  options.stepping = Stepping::FixedSteps;
  EXPECT_EQ(coarsening_of(options), OnGpu::No) << "of Newton alone";
}

TEST(Methods, SayWhatStandsInTheWayOfAGpu) {
  for (const Method& method : methods()) {
    EXPECT_EQ(std::string(method.obstacle).empty(), method.gpu == OnGpu::Yes) << method.options;
  }
}

/// The table of docs/proxies/equilibrator.md.
TEST(Methods, AreDocumented) {
  std::string table;
  for (const Method& method : methods()) {
    table += method.work == Method::Work::Equilibrium ? "| FoamFromPoints | " : "| FoamCoarsen | ";
    table += method.options;
    table += method.gpu == OnGpu::Yes  ? " | yes |\n"
             : method.gpu == OnGpu::No ? " | no |\n"
                                       : " | if `Device` is CUDA |\n";
  }
  std::ifstream page(FOAM_SOURCE_DIRECTORY "/docs/proxies/equilibrator.md");
  const std::string text{std::istreambuf_iterator<char>(page), {}};
  EXPECT_NE(text.find(table), std::string::npos) << table;
}

TEST(Accelerator, IsAnErrorForNewtonFromEventToEvent) {
  register_one();
  device_is_there = true;
  CoarseningOptions options;
  EXPECT_NE(make_coarsening(options), nullptr) << "Auto: on the processor";
  options.equilibrator.device = Device::CUDA;
  try {
    make_coarsening(options);
    FAIL();
  } catch (const FoamError& error) {
    EXPECT_EQ(std::string(error.what()),
              "Device = CUDA, but Stepping = Events, from one topological event to the next, is "
              "computed on the CPU alone; FixedSteps is computed there as well");
  }
  options.stepping = Stepping::FixedSteps;
  made = 0;
  make_coarsening(options)->restart(test::random_foam(20, Boundary::Free));
  EXPECT_EQ(made, 1) << "by the accelerator";
}

} // namespace
} // namespace foam
