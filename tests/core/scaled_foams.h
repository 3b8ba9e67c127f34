// SPDX-License-Identifier: GPL-3.0-or-later
//
// The same foam in other units.
#pragma once

#include <gtest/gtest.h>

#include <cmath>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "base/number.h"
#include "foams.h"

namespace foam::test {

inline constexpr double kTension = 0.25; // N/cm, of the foam that others are compared with

/// What a foam is multiplied by, and where it is put, in spacings.
struct Scale {
  double length = 1;
  double tension = 1;
  Vec2 shift;
};

inline std::string name(const Scale& scale) {
  return "lengths times " + number(scale.length) + ", tensions times " + number(scale.tension) +
         ", moved by " + number(scale.shift) + ": ";
}

inline BuildOptions build_options(Boundary boundary, Index bubbles, const Scale& scale) {
  BuildOptions options;
  options.boundary = boundary;
  options.surface_tension = kTension * scale.tension;
  if (boundary == Boundary::Periodic) {
    const Vec2 corner = grid_corner(bubbles, scale.length);
    options.torus = Lattice{scale.length * scale.shift, {corner.x, 0}, {0, corner.y}};
  }
  return options;
}

/// A random foam in equilibrium.
inline Foam scaled_foam(Boundary boundary, Index bubbles, std::uint64_t seed, const Scale& scale) {
  std::vector<Vec2> points = jittered_grid(bubbles, scale.length, 1, seed);
  for (Vec2& point : points) {
    point += scale.length * scale.shift;
  }
  Foam foam = build_from_points(points, build_options(boundary, bubbles, scale));
  equilibrate(foam);
  return foam;
}

/// In which the foam of scale 1 loses about a twentieth of its bubbles in 20 frames.
inline CoarseningOptions coarsening_options(Stepping stepping, const Scale& scale) {
  CoarseningOptions options = thesis_options();
  options.stepping = stepping;
  options.time_step = scale.length * scale.length / scale.tension / 30;
  options.thresholds.t1_length = 0.025 * scale.length;
  options.thresholds.t2_area = 0.05 * scale.length * scale.length;
  return options;
}

inline std::unique_ptr<Evolution> coarsened(Foam foam, const CoarseningOptions& options,
                                            int frames = 20) {
  auto coarsening = make_coarsening(options);
  coarsening->restart(std::move(foam));
  for (int frame = 0; frame < frames; ++frame) {
    coarsening->advance({});
    EXPECT_TRUE(coarsening->record().report.converged) << "frame " << frame;
  }
  return coarsening;
}

inline void expect_same_foam(const Foam& foam, const Scale& scale, const Foam& reference,
                             double tolerance) {
  const double energy = scale.length * scale.tension * reference.energy();
  EXPECT_NEAR(foam.energy(), energy, tolerance * energy) << name(scale);
  EXPECT_EQ(foam.bubble_count(), reference.bubble_count()) << name(scale);
  EXPECT_EQ(foam.t1_count, reference.t1_count) << name(scale);
  EXPECT_EQ(foam.t2_count, reference.t2_count) << name(scale);
  EXPECT_EQ(foam.sides, reference.sides) << name(scale);
  EXPECT_NEAR(foam.time, scale.length * scale.length / scale.tension * reference.time,
              1e-12 * foam.time);
}

} // namespace foam::test
