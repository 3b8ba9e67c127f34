// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace foam {

/// What a sample of independent runs says about a mean.
struct MeanEstimate {
  double mean = 0;
  double standard_error = 0; ///< s/√N with N − 1 in s²; NaN for fewer than two values
  double half_width = 0;     ///< of the confidence interval about the mean; NaN likewise
};

/// The mean of values, its standard error, and the 95 % confidence interval t·s/√N, with Student's
/// t for N − 1 degrees of freedom (Student, The probable error of a mean, Biometrika 6, 1, 1908).
/// \param values finite, in any unit, which is that of the estimate. Without values all is NaN.
MeanEstimate estimate_mean(std::span<const double> values);

} // namespace foam
