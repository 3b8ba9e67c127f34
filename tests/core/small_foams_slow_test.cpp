// SPDX-License-Identifier: GPL-3.0-or-later
#include "../small_foams.h"

namespace foam::test {
namespace {

TEST(SmallFoams, ManyAreInEquilibriumToTheirEnd) {
  for (std::uint64_t seed = 1000; seed < 1250; ++seed) {
    run_at_random(seed, 100, 300);
  }
}

} // namespace
} // namespace foam::test
