// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <string>

#include "base/number.h"
#include "base/random.h"
#include "coarsening/options.h"
#include "construct/from_points.h"
#include "construct/jittered_grid.h"
#include "engines/engines.h"
#include "mesh/validate.h"
#include "physics/gas.h"

namespace foam::test {

/// A run at random, all of it a function of the seed: so that what goes wrong can be seen again.
class RandomRun {
public:
  /// \param least, most bubbles at the start; between them all orders of magnitude are alike
  RandomRun(std::uint64_t seed, double least, double most) : seed_(seed), random_(seed) {
    bubbles_ = static_cast<Index>(std::lround(between(least, most)));
    boundary_ = pick(std::array{Boundary::Free, Boundary::Periodic, Boundary::Fixed});
    options_.stepping = pick(std::array{Stepping::Events, Stepping::FixedSteps});
    options_.two_sided_bubbles = pick(std::array{TwoSidedBubbles::Remove, TwoSidedBubbles::Slide});
    options_.thresholds = pick(std::array<ThresholdOptions, 8>{
        {{.kind = ThresholdKind::Automatic},
         {.kind = ThresholdKind::Absolute, .t1_length = 0.025, .t2_area = 0.05},
         {.kind = ThresholdKind::Absolute, .t1_length = 0.1, .t2_area = 0.1},
         {.kind = ThresholdKind::Absolute, .t1_length = 0.05, .t2_area = 0.005},
         {.kind = ThresholdKind::Absolute, .t1_length = 0.002, .t2_area = 1e-4},
         {.kind = ThresholdKind::Absolute, .t1_length = 0, .t2_area = 0},
         {.kind = ThresholdKind::Relative},
         {.kind = ThresholdKind::Relative, .alpha = 0.02}}});
    areas_ = pick(std::array{TargetAreas::Initial, TargetAreas::Uniform, TargetAreas::Array});
    surface_tension_ = between(0.05, 5);
    options_.permeability = between(0.1, 10);
    options_.time_step =
        between(0.005, 0.5) / von_neumann_constant(surface_tension_, options_.permeability);
    jitter_ = random_.uniform();
  }

  const CoarseningOptions& options() const { return options_; }
  Boundary boundary() const { return boundary_; }

  /// The foam that it begins with, of mean area 1 cm² or so; not in equilibrium.
  Foam start() const {
    BuildOptions build;
    build.boundary = boundary_;
    build.surface_tension = surface_tension_;
    build.target_areas =
        areas_ == TargetAreas::Uniform ? TargetAreas::Uniform : TargetAreas::Initial;
    Foam foam = build_from_points(jittered_grid(bubbles_, 1, jitter_, seed_), build);
    if (areas_ == TargetAreas::Array) {
      change_areas(foam);
    }
    return foam;
  }

  /// In words and numbers.
  std::string text() const {
    const auto among = [](auto value, auto... names) {
      return std::array{names...}[static_cast<std::size_t>(value)];
    };
    const ThresholdOptions& limit = options_.thresholds;
    return "seed " + std::to_string(seed_) + ": " + std::to_string(bubbles_) + " bubbles, " +
           among(boundary_, "Free", "Periodic", "Fixed") + ", " +
           among(options_.stepping, "Events", "FixedSteps") + ", " +
           among(options_.two_sided_bubbles, "Remove", "Slide") + ", areas " +
           among(areas_, "Initial", "Uniform", "Array") + ", jitter " + number(jitter_) +
           ", SurfaceTension " + number(surface_tension_) + ", Permeability " +
           number(options_.permeability) + ", TimeStep " + number(options_.time_step) +
           among(limit.kind,
                 ", Absolute, T1Length " + number(limit.t1_length) + ", T2Area " +
                     number(limit.t2_area),
                 ", Relative, Alpha " + number(limit.alpha), std::string(", Automatic"));
  }

private:
  template <class Values> typename Values::value_type pick(const Values& values) {
    return values[static_cast<std::size_t>(random_.uniform() * static_cast<double>(values.size()))];
  }
  double between(double least, double most) {
    return least * std::pow(most / least, random_.uniform());
  }
  /// By up to a half; what a closed foam has in all stays.
  void change_areas(Foam& foam) const {
    Random random(seed_ + 1);
    double before = 0;
    double after = 0;
    for (double& area : foam.target_area) {
      before += area;
      area *= 0.5 + random.uniform();
      after += area;
    }
    for (double& area : foam.target_area) {
      area *= before / after;
    }
  }

  std::uint64_t seed_;
  Random random_;
  Index bubbles_ = 0;
  Boundary boundary_ = Boundary::Free;
  TargetAreas areas_ = TargetAreas::Initial;
  double surface_tension_ = 0;
  double jitter_ = 0;
  CoarseningOptions options_;
};

} // namespace foam::test
