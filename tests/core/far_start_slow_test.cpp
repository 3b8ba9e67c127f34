// SPDX-License-Identifier: GPL-3.0-or-later
//
// None of five hundred far starts is too far.
#include <gtest/gtest.h>

#include "far_starts.h"

namespace foam::test {
namespace {

/// All kinds of a size, so many seeds of each: 2 kinds of points, 3 boundaries, 3 distributions.
void expect_equilibria(Index bubbles, std::uint64_t seeds) {
  for (const Points points : {Points::Poisson, Points::Jittered}) {
    for (const Boundary boundary : {Boundary::Free, Boundary::Periodic, Boundary::Fixed}) {
      for (const double variation : {0.0, 0.75, 1.5}) {
        for (std::uint64_t seed = 1; seed <= seeds; ++seed) {
          expect_equilibrium_from({points, boundary, bubbles, variation, seed});
        }
      }
    }
  }
}

TEST(FarStarts, OfFiftyBubblesReachEquilibrium) {
  expect_equilibria(50, 16);
}

TEST(FarStarts, OfTwoHundredBubblesReachEquilibrium) {
  expect_equilibria(200, 8);
}

TEST(FarStarts, OfAThousandBubblesReachEquilibrium) {
  expect_equilibria(1000, 3);
}

TEST(FarStarts, OfFourThousandBubblesReachEquilibrium) {
  expect_equilibria(4000, 1);
}

TEST(FarStarts, OfTenThousandBubblesReachEquilibrium) {
  for (const double variation : {0.0, 1.5}) {
    expect_equilibrium_from({Points::Poisson, Boundary::Periodic, 10000, variation, 1});
    expect_equilibrium_from({Points::Poisson, Boundary::Free, 10000, variation, 1});
  }
}

TEST(FarStarts, OfClustersReachEquilibrium) {
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic, Boundary::Fixed}) {
    for (const double variation : {0.0, 1.5}) {
      for (const Index bubbles : {48, 198, 396}) {
        for (std::uint64_t seed = 1; seed <= 8; ++seed) {
          expect_equilibrium_from({Points::Clusters, boundary, bubbles, variation, seed});
        }
      }
    }
  }
}

TEST(FarStarts, OfLongRingsReachEquilibrium) {
  for (const Index bubbles : {100, 150, 200, 300}) {
    for (const Boundary boundary : {Boundary::Free, Boundary::Fixed}) {
      expect_equilibrium_from({Points::Ring, boundary, bubbles, 0, 0});
      expect_equilibrium_from({Points::RingRound, boundary, bubbles + 1, 0, 0});
    }
  }
}

TEST(FarStarts, OfWidelySpreadAreasReachEquilibrium) {
  for (const Points points : {Points::Poisson, Points::Jittered}) {
    for (const Boundary boundary : {Boundary::Free, Boundary::Periodic, Boundary::Fixed}) {
      for (const Index bubbles : {50, 200, 500}) {
        for (std::uint64_t seed = 1; seed <= 6; ++seed) {
          expect_equilibrium_from({points, boundary, bubbles, 3, seed});
        }
      }
    }
  }
}

} // namespace
} // namespace foam::test
