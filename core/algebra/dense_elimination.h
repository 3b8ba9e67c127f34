// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

#include "mesh/ids.h"

namespace foam {

/// Eliminates the first unknowns of a dense symmetric system: of K = (K₁₁ · ; K₂₁ K₂₂) the first
/// columns become L (unit lower triangular, its diagonal not stored) with K₁₁ = L₁·D·L₁ᵀ and
/// L₂ = K₂₁·L₁⁻ᵀ·D⁻¹, and K₂₂ becomes the Schur complement K₂₂ − L₂·D·L₂ᵀ. It uses the widest
/// vectors that the processor has; the bits of the result do not depend on how wide they are.
///
/// \param columns K₁₁ over K₂₁, of which the lower triangle matters, column by column: size ×
/// pivots.size(); \param rest K₂₂, of which the lower triangle matters, column by column, square;
/// \param pivots becomes D; \param least magnitude of a pivot. \returns false if one is smaller.
bool eliminate_densely(std::span<double> columns, std::span<double> rest, std::span<double> pivots,
                       double least);

/// Solves with such an L: x ← (L₁ 0; L₂ 1)⁻¹·x. \param columns as eliminate_densely() left them, be
/// they rounded since: vectors and sums keep their digits; \param x of their size
void solve_lower(std::span<const double> columns, std::span<double> x);
void solve_lower(std::span<const float> columns, std::span<double> x);
/// x ← (L₁ 0; L₂ 1)⁻ᵀ·x.
void solve_upper(std::span<const double> columns, std::span<double> x);
void solve_upper(std::span<const float> columns, std::span<double> x);

} // namespace foam
