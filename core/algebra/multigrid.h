// SPDX-License-Identifier: GPL-3.0-or-later
//
// Smoothing by Chebyshev's iteration, for the levels of a V-cycle, on an executor
// (parallel/host.h). A level's matrix has rows of 2 × 2 blocks:
//   Matrix::Place       what its rows are numbered by,
//   row(x, place)       of its product with x, and
//   diagonal(place)     the block on the diagonal.
#pragma once

#include <cmath>

#include "algebra/elastic_grid.h"
#include "algebra/minimal_residual.h"

namespace foam::multigrid {

/// What smoothing on a level needs.
template <class Executor> struct Smoother {
  Index size = 0;     ///< rows
  double largest = 1; ///< eigenvalue of D⁻¹·M, or a little more
  typename Executor::template Array<Symmetric2> inverse;
  typename Executor::template Array<double> r, d;
  typename Executor::template Array<double> trial, zero; ///< of find_largest()
};

/// x ← something other than zero everywhere, and smooth nowhere.
template <class Executor> void fill_roughly(Executor& executor, Index size, double* x) {
  executor.for_each(
      size, FOAM_KERNEL(Index i) {
        const std::uint32_t scattered = static_cast<std::uint32_t>(i) * 2654435761U;
        x[i] = static_cast<double>(scattered >> 8) / 0x1p24 - 0.5;
      });
}

/// d ← by_last·d + by_residual·D⁻¹·r, x ← x + d
template <class Executor>
void chebyshev_step(Executor& executor, Smoother<Executor>& s, double by_last, double by_residual,
                    double* x) {
  const Symmetric2* const inverse = s.inverse.data();
  const double* const r = s.r.data();
  double* const d = s.d.data();
  executor.for_each(
      s.size, FOAM_KERNEL(Index i) {
        const Vec2 step =
            by_last * displacement(d, i) + by_residual * (inverse[i] * displacement(r, i));
        set_displacement(d, i, step);
        set_displacement(x, i, displacement(x, i) + step);
      });
}

/// What a matrix has to know of x before its rows are asked for: nothing, unless it says so.
template <class Executor> void before_row(Executor&, const GridMatrix&, const double*) {}

/// r ← b − M·x
template <class Executor, class Matrix>
void find_residual(Executor& executor, const Matrix& matrix, Smoother<Executor>& s, const double* b,
                   const double* x) {
  before_row(executor, matrix, x);
  double* const r = s.r.data();
  executor.for_each(
      s.size, FOAM_KERNEL(Index i) {
        set_displacement(r, i, displacement(b, i) - matrix.row(x, typename Matrix::Place(i)));
      });
}

template <class Executor, class Matrix>
void prepare(Executor& executor, const Matrix& matrix, Smoother<Executor>& s, Index size) {
  s.size = size;
  s.inverse.resize(place_of(size));
  s.r.resize(2 * place_of(size));
  s.d.resize(2 * place_of(size));
  Symmetric2* const inverse = s.inverse.data();
  executor.for_each(
      size,
      FOAM_KERNEL(Index i) { inverse[i] = matrix.diagonal(typename Matrix::Place(i)).inverse(); });
}

/// Power iteration: x ← D⁻¹·M·x.
template <class Executor, class Matrix>
void find_largest(Executor& executor, const Matrix& matrix, Smoother<Executor>& s) {
  constexpr int kSteps = 10;
  constexpr double kMargin = 1.25; // for what it falls short of
  const Index length = 2 * s.size;
  s.trial.resize(place_of(length));
  s.zero.resize(place_of(length));
  double* const x = s.trial.data();
  executor.for_each(length, parallel::Fill<double>{s.zero.data(), 0});
  executor.for_each(length, parallel::Fill<double>{s.d.data(), 0});
  fill_roughly(executor, length, x);
  for (int step = 0; step < kSteps; ++step) {
    const double norm = std::sqrt(dot_product(executor, length, x, x));
    s.largest = step == 0 ? 1 : kMargin * norm;
    rescale(executor, length, x, norm > 0 ? 1 / norm : 0);
    find_residual(executor, matrix, s, s.zero.data(), x);
    executor.for_each(length, parallel::Fill<double>{x, 0});
    chebyshev_step(executor, s, 0, -1, x);
  }
}

/// Chebyshev's iteration for the eigenvalues of D⁻¹M from largest/ratio on (Y. Saad, Iterative
/// Methods for Sparse Linear Systems, 2nd ed., 2003, algorithm 12.1). \param fresh x is zero.
template <class Executor, class Matrix>
void smooth(Executor& executor, const Matrix& matrix, Smoother<Executor>& s, const double* b,
            double* x, bool fresh, int steps, double ratio) {
  const double centre = 0.5 * s.largest * (1 + 1 / ratio);
  const double radius = 0.5 * s.largest * (1 - 1 / ratio);
  const double sigma = centre / radius;
  double rho = 1 / sigma;
  double by_last = 0;
  double by_residual = 1 / centre;
  for (int step = 0; step < steps; ++step) {
    if (step == 0 && fresh) {
      executor.for_each(2 * s.size, parallel::Fill<double>{x, 0});
      executor.for_each(2 * s.size, parallel::Copy<double>{b, s.r.data()});
    } else {
      find_residual(executor, matrix, s, b, x);
    }
    chebyshev_step(executor, s, by_last, by_residual, x);
    const double next = 1 / (2 * sigma - rho);
    by_last = next * rho;
    by_residual = 2 * next / radius;
    rho = next;
  }
}

/// One symmetric V-cycle. \param correct of the residual, on coarser levels: adds to x
template <class Executor, class Matrix, class Correct>
void cycle(Executor& executor, const Matrix& matrix, Smoother<Executor>& s, const double* b,
           double* x, const Correct& correct) {
  constexpr int kSteps = 2;    // of Chebyshev's iteration before and after,
  constexpr double kRatio = 4; // for so large a part of the spectrum
  smooth(executor, matrix, s, b, x, true, kSteps, kRatio);
  find_residual(executor, matrix, s, b, x);
  correct(s.r.data());
  smooth(executor, matrix, s, b, x, false, kSteps, kRatio);
}

} // namespace foam::multigrid
