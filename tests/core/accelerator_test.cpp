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
  EXPECT_FALSE(accelerator_obstacle(options).empty()) << "Newton, from event to event";
  options.equilibrator.device = Device::CUDA;
  EXPECT_TRUE(accelerator_obstacle(options.equilibrator).empty()) << "Newton, asked for";
  EXPECT_FALSE(accelerator_obstacle(options).empty()) << "Newton, from event to event";
  options.equilibrator.kind = EquilibratorKind::Junction;
  EXPECT_TRUE(accelerator_obstacle(options.equilibrator).empty());
  EXPECT_FALSE(accelerator_obstacle(options).empty()) << "the final algorithm";
  options.topological_algorithm = TopologicalAlgorithm::Bidding;
  EXPECT_TRUE(accelerator_obstacle(options).empty());
  options.equilibrator.junction.sweep = Sweep::GaussSeidel;
  EXPECT_FALSE(accelerator_obstacle(options).empty()) << "one after the other";
}

} // namespace
} // namespace foam
