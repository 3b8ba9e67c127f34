// SPDX-License-Identifier: GPL-3.0-or-later
#include "parallel/accelerator.h"

#include <gtest/gtest.h>

#include "evolution/coarsening.h"

namespace foam {
namespace {

bool device_is_there = false;

/// An accelerator that makes nothing.
void register_one() {
  register_cuda({[] { return std::string(device_is_there ? "" : "it is not plugged in"); },
                 [](const EquilibratorOptions&) { return std::unique_ptr<Equilibrator>(); },
                 [](const CoarseningOptions&) { return std::unique_ptr<Coarsening>(); }});
}

std::string error_of(Device device, const std::string& obstacle) {
  try {
    accelerator_for(device, obstacle);
  } catch (const FoamError& error) {
    return error.what();
  }
  return "no error";
}

TEST(Accelerator, IsTakenWhereItIsThereAndCan) {
  register_one();
  device_is_there = true;
  EXPECT_NE(accelerator_for(Device::CUDA, ""), nullptr);
  EXPECT_NE(accelerator_for(Device::Auto, ""), nullptr);
  EXPECT_EQ(accelerator_for(Device::CPU, ""), nullptr);
  EXPECT_EQ(accelerator_for(Device::Auto, "it cannot"), nullptr);
  EXPECT_EQ(error_of(Device::CUDA, "it cannot"), "Device = CUDA, but it cannot");
}

TEST(Accelerator, AutoSaysOnceThatItIsNotThere) {
  register_one();
  device_is_there = false;
  testing::internal::CaptureStderr();
  EXPECT_EQ(accelerator_for(Device::Auto, ""), nullptr);
  EXPECT_EQ(accelerator_for(Device::Auto, ""), nullptr);
  EXPECT_EQ(testing::internal::GetCapturedStderr(),
            "Foam: Device = Auto computes on the CPU: it is not plugged in\n");
  EXPECT_EQ(error_of(Device::CUDA, ""), "Device = CUDA, but it is not plugged in");
}

TEST(Accelerator, ComputesWhatIsTheSameThere) {
  CoarseningOptions options;
  EXPECT_FALSE(accelerator_obstacle(options.equilibrator).empty()) << "Newton, by itself";
  options.equilibrator.device = Device::CUDA;
  EXPECT_TRUE(accelerator_obstacle(options.equilibrator).empty()) << "Newton, asked for";
  options.equilibrator.kind = EquilibratorKind::Junction;
  EXPECT_TRUE(accelerator_obstacle(options.equilibrator).empty());
  EXPECT_FALSE(accelerator_obstacle(options).empty()) << "the final algorithm";
  options.topological_algorithm = TopologicalAlgorithm::Bidding;
  EXPECT_TRUE(accelerator_obstacle(options).empty());
  options.equilibrator.junction.sweep = Sweep::GaussSeidel;
  EXPECT_FALSE(accelerator_obstacle(options).empty()) << "one after the other";
}

/// From event to event on the processor alone; in fixed steps there and on the device.
TEST(Accelerator, ComputesNewtonsFrames) {
  for (const Device device : {Device::Auto, Device::CUDA}) {
    CoarseningOptions options;
    options.equilibrator.device = device;
    for (const auto algorithm : {TopologicalAlgorithm::Final, TopologicalAlgorithm::Original,
                                 TopologicalAlgorithm::Improved}) {
      options.topological_algorithm = algorithm;
      const std::string obstacle = accelerator_obstacle(options);
      EXPECT_NE(obstacle.find("TopologicalAlgorithm = Bidding"), std::string::npos) << obstacle;
    }
    options.topological_algorithm = TopologicalAlgorithm::Bidding;
    EXPECT_EQ(accelerator_obstacle(options), "");
  }
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
              "Device = CUDA, but Equilibrator = Newton steps from one topological event to the "
              "next on the CPU alone; with TopologicalAlgorithm = Bidding it goes in fixed steps, "
              "there as well");
  }
  options.topological_algorithm = TopologicalAlgorithm::Bidding;
  EXPECT_EQ(make_coarsening(options), nullptr) << "made by the accelerator, which makes nothing";
}

} // namespace
} // namespace foam
