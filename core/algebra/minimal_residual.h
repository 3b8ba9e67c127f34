// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "parallel/kernels.h"

namespace foam {

/// a·b
template <class Executor>
double dot_product(Executor& executor, Index size, const double* a, const double* b) {
  return executor.reduce(
      size, 0.0, FOAM_KERNEL(Index i) { return a[i] * b[i]; }, parallel::Add{});
}

/// |a − b|²
template <class Executor>
double squared_distance(Executor& executor, Index size, const double* a, const double* b) {
  return executor.reduce(
      size, 0.0, FOAM_KERNEL(Index i) { return (a[i] - b[i]) * (a[i] - b[i]); }, parallel::Add{});
}

/// a ← factor·a
template <class Executor> void rescale(Executor& executor, Index size, double* a, double factor) {
  executor.for_each(
      size, FOAM_KERNEL(Index i) { a[i] *= factor; });
}

/// MINRES for a symmetric indefinite matrix with a symmetric positive definite preconditioner (C.
/// C. Paige, M. A. Saunders, SIAM J. Numer. Anal. 12, 617, 1975; preconditioned as in H. Elman, D.
/// Silvester, A. Wathen, Finite Elements and Fast Iterative Solvers, 2nd ed., 2014, algorithm 4.1),
/// on an executor (parallel/host.h). A singular matrix is no obstacle to it if the equations have a
/// solution. Seven vectors, whatever the number of iterations.
template <class Executor> class MinimalResidual {
public:
  explicit MinimalResidual(Executor& executor) : executor_(executor) {}

  /// Solves for x from zero until the residual, in the preconditioner's norm, has fallen to
  /// `tolerance` of what it was.
  /// \param multiply multiply(from, to) does to ← A·from
  /// \param precondition precondition(from, to) does to ← P⁻¹·from
  /// \returns the iterations done.
  template <class Multiply, class Precondition>
  int solve(Index size, const double* b, double* x, double tolerance, int maximum_iterations,
            const Multiply& multiply, const Precondition& precondition) {
    for (auto* vector : {&last_, &now_, &next_, &z_, &next_z_, &d_last_, &d_now_}) {
      vector->resize(static_cast<std::size_t>(size));
    }
    for (double* vector : {last_.data(), d_last_.data(), d_now_.data(), x}) {
      executor_.for_each(size, parallel::Fill<double>{vector, 0});
    }
    executor_.for_each(size, parallel::Copy<double>{b, now_.data()});
    precondition(now_.data(), z_.data());
    double gamma = std::sqrt(dot_product(executor_, size, z_.data(), now_.data()));
    double last_gamma = 1;
    const double target = tolerance * gamma;
    double eta = gamma;
    double s_last = 0, s = 0, c_last = 1, c = 1;
    int iterations = 0;
    while (std::abs(eta) > target && iterations < maximum_iterations) {
      ++iterations;
      rescale(executor_, size, z_.data(), 1 / gamma);
      multiply(z_.data(), next_.data());
      const double delta = dot_product(executor_, size, next_.data(), z_.data());
      orthogonalise(size, delta / gamma, gamma / last_gamma);
      precondition(next_.data(), next_z_.data());
      const double next_gamma =
          std::sqrt(std::max(dot_product(executor_, size, next_z_.data(), next_.data()), 0.0));
      // Givens rotations of the tridiagonal matrix's last column.
      const double a0 = c * delta - c_last * s * gamma;
      const double a1 = std::hypot(a0, next_gamma);
      const double a2 = s * delta + c_last * c * gamma;
      const double a3 = s_last * gamma;
      if (a1 == 0) {
        break;
      }
      c_last = std::exchange(c, a0 / a1);
      s_last = std::exchange(s, next_gamma / a1);
      advance(size, x, a3, a2, a1, c * eta);
      std::swap(d_last_, d_now_);
      eta *= -s;
      std::swap(last_, now_);
      std::swap(now_, next_);
      std::swap(z_, next_z_);
      last_gamma = std::exchange(gamma, next_gamma);
    }
    return iterations;
  }

  // Parts of an iteration.

  /// next ← next − by_now·now − by_last·last
  void orthogonalise(Index size, double by_now, double by_last) {
    double* const next = next_.data();
    const double* const now = now_.data();
    const double* const last = last_.data();
    executor_.for_each(
        size, FOAM_KERNEL(Index i) { next[i] -= by_now * now[i] + by_last * last[i]; });
  }

  /// d ← (z − by_last·d − by_now·d_now)/norm, of the last direction d, and x ← x + step·d
  void advance(Index size, double* x, double by_last, double by_now, double norm, double step) {
    const double* const z = z_.data();
    double* const d = d_last_.data();
    const double* const d_now = d_now_.data();
    executor_.for_each(
        size, FOAM_KERNEL(Index i) {
          d[i] = (z[i] - by_last * d[i] - by_now * d_now[i]) / norm;
          x[i] += step * d[i];
        });
  }

private:
  using Vector = typename Executor::template Array<double>;

  Executor& executor_;
  Vector last_, now_, next_; ///< Lanczos vectors
  Vector z_, next_z_;        ///< the last two, preconditioned
  Vector d_last_, d_now_;    ///< directions
};

} // namespace foam
