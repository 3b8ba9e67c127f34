// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "mesh/foam.h"
#include "mesh/foam_view.h"
#include "parallel/kernels.h"

namespace foam {

/// The user's choice of thresholds.
struct ThresholdOptions {
  ThresholdKind kind = ThresholdKind::Automatic;
  double t1_length = 0.025; ///< cm, ≥ 0
  double t2_area = 0.05;    ///< cm², ≥ 0
  double alpha = 0.05;      ///< Weygand's α, > 0

  friend bool operator==(const ThresholdOptions&, const ThresholdOptions&) = default;
};

/// \throws FoamError for options out of range.
void check(const ThresholdOptions& options);

inline constexpr double kAutomatic = 0.01; // of √Ā and of Ā

/// The thresholds in force for a foam of the mean target area Ā. Automatic ones are a hundredth of
/// √Ā and of Ā. Relative ones follow D. Weygand, Y. Bréchet and J. Lépinoux, Phil.
/// Mag. B 78 (1998) 329, as in the thesis (3.2.2): δ_T1 = α·√(2·A_total/(π·m)) for m junctions,
/// δ_T2 = δ_T1².
Thresholds thresholds(const Foam& foam, const ThresholdOptions& options);

/// The same from A_total (cm²), the number of bubbles, and m.
Thresholds thresholds(double total_area, Index bubbles, Index junctions,
                      const ThresholdOptions& options);

namespace detail {

struct IsJunction {
  ConstFoamView mesh;

  FOAM_HOST_DEVICE Index operator()(Junction junction) const {
    return mesh.has_junction(junction) ? 1 : 0;
  }
};

} // namespace detail

/// The same for a foam on an executor (parallel/host.h), from A_total (cm²) and the number of
/// bubbles.
template <class Executor>
Thresholds thresholds(Executor& executor, const FoamView& mesh, double total_area, Index bubbles,
                      const ThresholdOptions& options) {
  const Index junctions =
      options.kind == ThresholdKind::Relative
          ? executor.reduce(mesh.junction_slots(), Index{0}, detail::IsJunction{const_view(mesh)},
                            parallel::Add{})
          : 0;
  return thresholds(total_area, bubbles, junctions, options);
}

} // namespace foam
