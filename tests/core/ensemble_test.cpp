// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/ensemble.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace foam {
namespace {

TEST(Ensemble, StudentsTable) {
  // t for 1, 2, 4 and 9 degrees of freedom, from tables of the distribution.
  for (const auto& [count, t] : {std::pair{2, 12.7062}, {3, 4.3027}, {5, 2.7764}, {10, 2.2622}}) {
    std::vector<double> values;
    for (int i = 0; i < count; ++i) {
      values.push_back(3 + 2 * i);
    }
    // Of 0, 1, … N − 1 the variance is N(N + 1)/12.
    const double standard_error = 2 * std::sqrt((count + 1) / 12.0);
    const auto estimate = estimate_mean(values);
    EXPECT_DOUBLE_EQ(estimate.mean, 3 + (count - 1));
    EXPECT_NEAR(estimate.standard_error, standard_error, 1e-12);
    EXPECT_NEAR(estimate.half_width / standard_error, t, 5e-5);
  }
}

TEST(Ensemble, TooFewValues) {
  EXPECT_TRUE(std::isnan(estimate_mean({}).mean));
  const std::vector<double> one{7};
  EXPECT_EQ(estimate_mean(one).mean, 7);
  EXPECT_TRUE(std::isnan(estimate_mean(one).standard_error));
  EXPECT_TRUE(std::isnan(estimate_mean(one).half_width));
}

} // namespace
} // namespace foam
