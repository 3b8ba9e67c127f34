// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cmath>
#include <utility>

#include "parallel/kernels.h"

namespace foam::newton {
namespace detail {

struct DotProduct {
  const double* a = nullptr;
  const double* b = nullptr;

  FOAM_HOST_DEVICE double operator()(Index i) const { return a[i] * b[i]; }
};

/// next ← next − by_now·now − by_last·last
struct Orthogonalise {
  double* next = nullptr;
  const double* now = nullptr;
  const double* last = nullptr;
  double by_now = 0, by_last = 0;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    next[i] -= by_now * now[i] + by_last * last[i];
  }
};

/// last ← (z − by_last·last − by_now·now)/norm, x ← x + step·last
struct Advance {
  double* x = nullptr;
  const double* z = nullptr;
  double* last = nullptr;
  const double* now = nullptr;
  double by_last = 0, by_now = 0, norm = 1, step = 0;

  FOAM_HOST_DEVICE void operator()(Index i) const {
    const double direction = (z[i] - by_last * last[i] - by_now * now[i]) / norm;
    last[i] = direction;
    x[i] += step * direction;
  }
};

/// a ← factor·a
struct Rescale {
  double* a = nullptr;
  double factor = 1;

  FOAM_HOST_DEVICE void operator()(Index i) const { a[i] *= factor; }
};

} // namespace detail

/// MINRES for a symmetric indefinite matrix with a symmetric positive definite preconditioner (C.
/// C. Paige, M. A. Saunders, SIAM J. Numer. Anal. 12, 617, 1975; preconditioned as in H. Elman, D.
/// Silvester, A. Wathen, Finite Elements and Fast Iterative Solvers, 2nd ed., 2014, algorithm 4.1),
/// on a machine (parallel/host.h). A singular matrix is no obstacle to it if the equations have a
/// solution. Seven vectors, whatever the number of iterations.
template <class Machine> class MinimalResidual {
public:
  explicit MinimalResidual(Machine& machine) : machine_(machine) {}

  /// Solves for x from zero until the residual, in the preconditioner's norm, has fallen to
  /// `tolerance` of what it was.
  /// \param multiply multiply(from, to) does to ← A·from
  /// \param precondition precondition(from, to) does to ← P⁻¹·from
  /// \returns the iterations done.
  template <class Multiply, class Precondition>
  int solve(Index size, const double* b, double* x, double tolerance, int maximum_iterations,
            const Multiply& multiply, const Precondition& precondition) {
    using namespace detail;
    for (auto* vector : {&last_, &now_, &next_, &z_, &next_z_, &d_last_, &d_now_}) {
      vector->resize(static_cast<std::size_t>(size));
    }
    for (double* vector : {last_.data(), d_last_.data(), d_now_.data(), x}) {
      machine_.for_each(size, parallel::Fill<double>{vector, 0});
    }
    machine_.for_each(size, parallel::Copy<double>{b, now_.data()});
    precondition(now_.data(), z_.data());
    double gamma = std::sqrt(dot(size, z_, now_));
    double last_gamma = 1;
    const double target = tolerance * gamma;
    double eta = gamma;
    double s_last = 0, s = 0, c_last = 1, c = 1;
    int iterations = 0;
    while (std::abs(eta) > target && iterations < maximum_iterations) {
      ++iterations;
      machine_.for_each(size, Rescale{z_.data(), 1 / gamma});
      multiply(z_.data(), next_.data());
      const double delta = dot(size, next_, z_);
      machine_.for_each(size, Orthogonalise{next_.data(), now_.data(), last_.data(), delta / gamma,
                                            gamma / last_gamma});
      precondition(next_.data(), next_z_.data());
      const double next_gamma = std::sqrt(std::max(dot(size, next_z_, next_), 0.0));
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
      machine_.for_each(size,
                        Advance{x, z_.data(), d_last_.data(), d_now_.data(), a3, a2, a1, c * eta});
      std::swap(d_last_, d_now_);
      eta *= -s;
      std::swap(last_, now_);
      std::swap(now_, next_);
      std::swap(z_, next_z_);
      last_gamma = std::exchange(gamma, next_gamma);
    }
    return iterations;
  }

private:
  using Vector = typename Machine::template Array<double>;

  double dot(Index size, const Vector& a, const Vector& b) {
    return machine_.reduce(size, 0.0, detail::DotProduct{a.data(), b.data()}, parallel::Add{});
  }

  Machine& machine_;
  Vector last_, now_, next_; ///< Lanczos vectors
  Vector z_, next_z_;        ///< the last two, preconditioned
  Vector d_last_, d_now_;    ///< directions
};

} // namespace foam::newton
