// SPDX-License-Identifier: GPL-3.0-or-later
// Equilibria against closed forms and published values (tests/data, line tension 2γ = 1).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "engines/engines.h"
#include "foams.h"
#include "reference.h"

namespace foam::test {
namespace {

constexpr double kPi = std::numbers::pi;

std::vector<double> sorted_pressures(const Foam& foam) {
  std::vector<double> p = foam.pressure;
  std::ranges::sort(p);
  return p;
}

std::vector<Vec2> flower_points(int petals) {
  std::vector<Vec2> points{{0, 0}};
  for (int k = 0; k < petals; ++k) {
    const double angle = 2 * kPi * k / petals;
    points.push_back({1.1 * std::cos(angle), 1.1 * std::sin(angle)});
  }
  return points;
}

/// Points whose Delaunay triangulation has the best known topology of n equal bubbles.
std::vector<Vec2> cluster_points(int n) {
  const double h = std::sqrt(3.0) / 2;
  switch (n) {
  case 3:
    return {{0, 0}, {1, 0}, {0.5, h}};
  case 4:
    return {{0, 0}, {1, 0}, {0.5, h}, {0.5, -h}};
  case 5:
    return {{0, 0}, {1, 0}, {2, 0}, {0.5, h}, {1.5, h}};
  default:
    return flower_points(n - 1);
  }
}

TEST(ExactValues, FreeClustersOfEqualBubbles) {
  const auto lengths = read_csv("free_clusters_unit_area.csv");
  const auto pressures = read_csv("free_clusters_pressures.csv");
  for (int n = 2; n <= 7; ++n) {
    Foam foam = n == 2 ? double_bubble(1, 1) : unit_cluster(cluster_points(n));
    if (n == 2) {
      equilibrate(foam, 1e-13);
    }
    expect_valid(foam);
    const double length = number(lengths[static_cast<std::size_t>(n - 1)], "P_line_tension_1");
    std::vector<double> expected;
    for (const auto& row : pressures) {
      if (std::stoi(row.at("N")) == n) {
        expected.push_back(number(row, "dp_over_2gamma"));
      }
    }
    std::ranges::sort(expected);
    // The references are printed to 12 decimals.
    EXPECT_NEAR(foam.energy(), length, 1e-10) << n;
    const auto found = sorted_pressures(foam);
    ASSERT_EQ(found.size(), expected.size());
    double worst = 0;
    for (std::size_t i = 0; i < found.size(); ++i) {
      worst = std::max(worst, std::abs(found[i] - expected[i]));
    }
    EXPECT_LT(worst, 1e-10) << n;
    std::cout << "N = " << n << ": length error " << foam.energy() - length << ", pressure error "
              << worst << '\n';
  }
}

TEST(ExactValues, UnequalDoubleBubbles) {
  for (const auto& row : read_csv("double_bubble_unequal.csv")) {
    Foam foam = double_bubble(number(row, "A1"), number(row, "A2"));
    equilibrate(foam, 1e-13);
    expect_equilibrium(foam);
    EXPECT_NEAR(foam.energy(), number(row, "P_line_tension_1"), 1e-10);
    EXPECT_NEAR(foam.pressure[Bubble(0)], number(row, "dp1_over_2gamma"), 1e-9);
    EXPECT_NEAR(foam.pressure[Bubble(1)], number(row, "dp2_over_2gamma"), 1e-9);
    EXPECT_NEAR(norm(foam.chord(Half(0))), number(row, "interface_chord"), 1e-10);
  }
}

TEST(ExactValues, FlowersAndTheirRegularPolygons) {
  const auto polygons = read_csv("plateau_ncells.csv");
  for (const auto& row : read_csv("flower_clusters.csv")) {
    const int petals = std::stoi(row.at("n_center"));
    const Foam foam = unit_cluster(flower_points(petals));
    expect_valid(foam);
    EXPECT_TRUE(foam.report.converged) << petals;
    ASSERT_EQ(foam.sides[Bubble(0)], petals);
    EXPECT_NEAR(foam.energy(), number(row, "P_unit_area_line_tension1"), 1e-10) << petals;
    EXPECT_NEAR(foam.pressure[Bubble(0)], number(row, "p_center"), 1e-9) << petals;
    EXPECT_NEAR(foam.pressure[Bubble(1)], number(row, "p_petal"), 1e-9) << petals;
    // The bubble in the middle is the regular n-gon with 120° corners.
    const auto polygon = std::ranges::find_if(
        polygons, [&](const auto& p) { return std::stoi(p.at("n")) == petals; });
    ASSERT_NE(polygon, polygons.end());
    double perimeter = 0;
    for_each_half(foam, Bubble(0), [&](Half h) {
      perimeter += foam.length(h);
      EXPECT_NEAR(foam.half_angle(h), number(*polygon, "arc_half_angle_rad"), 1e-10);
      EXPECT_NEAR(arc_curvature(norm(foam.chord(h)), foam.half_angle(h)),
                  number(*polygon, "kappa_sqrtA_(dp*sqrtA/(2gamma))"), 1e-9);
    });
    EXPECT_NEAR(perimeter, number(*polygon, "perimeter_over_sqrtA"), 1e-10);
  }
}

/// An n × n hexagonal lattice of unit bubbles, stretched by λ along its rows and 1/λ across.
Foam honeycomb(int n, double stretch) {
  const double spacing = std::sqrt(2 / std::sqrt(3.0));
  const double row = spacing * std::sqrt(3.0) / 2;
  std::vector<Vec2> points;
  for (int j = 0; j < n; ++j) {
    for (int i = 0; i < n; ++i) {
      points.push_back({(i + 0.5 * (j % 2) + 0.25) * spacing, (j + 0.5) * row});
    }
  }
  BuildOptions options;
  options.boundary = Boundary::Periodic;
  options.surface_tension = 0.5;
  options.torus = Lattice::rectangle(0, n * spacing, 0, n * row);
  Foam foam = build_from_points(points, options);
  foam.surroundings.lattice = Lattice::rectangle(0, n * spacing * stretch, 0, n * row / stretch);
  for (Vec2& x : foam.position) {
    x = {x.x * stretch, x.y / stretch};
  }
  EquilibratorOptions tight;
  tight.tolerance = 1e-12;
  make_equilibrator(tight)->equilibrate(foam, 0, {});
  return foam;
}

TEST(ExactValues, HoneycombEnergy) {
  const Foam foam = honeycomb(6, 1);
  expect_valid(foam);
  EXPECT_TRUE(foam.report.converged);
  EXPECT_NEAR(foam.energy() / 36, std::sqrt(2 * std::sqrt(3.0)), 1e-12);
}

TEST(ExactValues, StretchedHoneycomb) {
  // L² = ¾ d² tr(FᵀF) + (3/2) d² per bubble, d the lattice constant, until a film vanishes at √3.
  for (const double stretch : {0.7, 0.9, 1.2, 1.5}) {
    const Foam foam = honeycomb(6, stretch);
    expect_valid(foam);
    EXPECT_TRUE(foam.report.converged);
    const double d2 = 2 / std::sqrt(3.0);
    const double expected =
        std::sqrt(0.75 * d2 * (stretch * stretch + 1 / (stretch * stretch)) + 1.5 * d2);
    EXPECT_NEAR(foam.energy() / 36, expected, 1e-11) << stretch;
  }
}

TEST(ExactValues, VirialOfFreeClusters) {
  for (const Index n : {10, 60, 200}) {
    const Foam foam = random_foam(n, Boundary::Free, static_cast<std::uint64_t>(n));
    expect_valid(foam);
    expect_equilibrium(foam);
    double work = 0;
    for (const Bubble b : foam.bubble_slots()) {
      work += foam.pressure[b] * foam.area(b);
    }
    EXPECT_NEAR(work / (0.5 * foam.energy()), 1, 1e-9) << n;
  }
}

TEST(ExactValues, ThreeCentresOfCurvatureAreCollinear) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic}) {
    const Foam foam = random_foam(100, boundary, 4);
    for (const Junction j : foam.junction_slots()) {
      double sum = 0;
      std::array<Vec2, 3> centre_times_curvature;
      std::array<double, 3> curvature{};
      for (std::size_t k = 0; k < 3; ++k) {
        const Half h = foam.junction_half[j][k];
        curvature[k] = arc_curvature(norm(foam.chord(h)), foam.half_angle(h));
        centre_times_curvature[k] = left_normal(foam.tangent(h));
        sum += curvature[k];
      }
      EXPECT_NEAR(sum, 0, 1e-7); // to the tolerance times 1/length of the shortest film
      // Centres c_k = n_k/κ_k; (c_2 − c_1) × (c_3 − c_1) = 0, multiplied by κ_1 κ_2 κ_3.
      const auto& [n1, n2, n3] = centre_times_curvature;
      const auto& [k1, k2, k3] = curvature;
      const double determinant = k1 * cross(n2, n3) + k2 * cross(n3, n1) + k3 * cross(n1, n2);
      EXPECT_NEAR(determinant, 0, 1e-7);
    }
  }
}

} // namespace
} // namespace foam::test
