// SPDX-License-Identifier: GPL-3.0-or-later
#include <gtest/gtest.h>

#include <memory>

#include "scaled_foams.h"

namespace foam::test {
namespace {

TEST(Units, ChangeNothingInTenThousandBubbles) {
  constexpr Index kBubbles = 10000;
  for (const Boundary boundary : {Boundary::Free, Boundary::Periodic, Boundary::Fixed}) {
    const Foam start = scaled_foam(boundary, kBubbles, 5, {});
    const auto reference = coarsened(start, coarsening_options(Stepping::Events, {}), 1);
    EXPECT_GT(reference->foam().t1_count, start.t1_count) << "something happens";
    for (const Scale& scale : {Scale{1e-9, 4e-12, {}}, Scale{1e-9, 4e12, {}}, Scale{1e9, 4e-12, {}},
                               Scale{1e9, 4e12, {}}}) {
      const Foam scaled = scaled_foam(boundary, kBubbles, 5, scale);
      expect_same_foam(scaled, scale, start, 1e-12);
      const auto coarsening = coarsened(scaled, coarsening_options(Stepping::Events, scale), 1);
      expect_same_foam(coarsening->foam(), scale, reference->foam(), 1e-12);
    }
  }
}

} // namespace
} // namespace foam::test
