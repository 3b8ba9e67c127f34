// SPDX-License-Identifier: GPL-3.0-or-later
#include "statistics/ensemble.h"

#include <cmath>
#include <limits>
#include <numeric>

#include <boost/math/distributions/students_t.hpp>

namespace foam {

MeanEstimate estimate_mean(std::span<const double> values) {
  constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  const auto count = static_cast<double>(values.size());
  if (values.empty()) {
    return {nan, nan, nan};
  }
  const double mean = std::accumulate(values.begin(), values.end(), 0.0) / count;
  if (values.size() < 2) {
    return {mean, nan, nan};
  }
  double squares = 0;
  for (const double value : values) {
    squares += (value - mean) * (value - mean);
  }
  const double standard_error = std::sqrt(squares / (count - 1) / count);
  const double t = boost::math::quantile(boost::math::students_t(count - 1), 0.975);
  return {mean, standard_error, t * standard_error};
}

} // namespace foam
