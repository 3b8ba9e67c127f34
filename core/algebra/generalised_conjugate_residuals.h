// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include "parallel/kernels.h"

namespace foam {

/// The largest entry by magnitude of a residual, each times its weight.
inline double largest_weighted(std::span<const double> rest, std::span<const double> weight) {
  constexpr parallel::Larger larger{};
  double largest = 0;
  for (std::size_t i = 0; i < rest.size(); ++i) {
    largest = larger(largest, weight[i] * std::abs(rest[i]));
  }
  return largest;
}

/// Goes on solving K·x = load by generalised conjugate residuals (S. C. Eisenstat, H. C. Elman, M.
/// H. Schultz, SIAM J. Numer. Anal. 20 (1983) 345): x takes up that combination of the
/// preconditioned residuals which leaves the smallest residual in a weighted norm. K may be
/// indefinite, and the preconditioner unsymmetric.
///
/// \param rest load − K·x, of which it leaves what is left; \param weight of its entries;
/// \param limit to largest_weighted(rest, weight); \param most directions;
/// \param subtract_product (z, from): from −= K·z; \param precondition (z): z ← about K⁻¹·z.
/// \returns whether the limit is met.
template <class SubtractProduct, class Precondition>
bool generalised_conjugate_residuals(std::span<double> x, std::vector<double>& rest,
                                     std::span<const double> weight, double limit, int most,
                                     const SubtractProduct& subtract_product,
                                     const Precondition& precondition) {
  const auto product = [weight](std::span<const double> a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i) {
      sum += weight[i] * weight[i] * a[i] * b[i];
    }
    return sum;
  };
  const auto add = [](double factor, std::span<const double> a, std::span<double> to) {
    for (std::size_t i = 0; i < a.size(); ++i) {
      to[i] += factor * a[i];
    }
  };
  struct Direction {
    std::vector<double> step, effect; ///< z, −K·z
    double norm2 = 0;                 ///< of the effect
  };
  std::vector<Direction> directions;
  while (!(largest_weighted(rest, weight) <= limit)) {
    if (static_cast<int>(directions.size()) == most) {
      return false;
    }
    Direction next{rest, std::vector<double>(rest.size(), 0.0), 0};
    precondition(next.step);
    subtract_product(next.step, next.effect);
    for (const Direction& before : directions) {
      const double share = -product(next.effect, before.effect) / before.norm2;
      add(share, before.step, next.step);
      add(share, before.effect, next.effect);
    }
    next.norm2 = product(next.effect, next.effect);
    const double length = -product(rest, next.effect) / next.norm2;
    if (!(next.norm2 > 0)) {
      return false;
    }
    add(length, next.step, x);
    add(length, next.effect, rest);
    directions.push_back(std::move(next));
  }
  return true;
}

} // namespace foam
