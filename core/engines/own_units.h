// SPDX-License-Identifier: GPL-3.0-or-later
//
// Engines that compute every foam in its own units (mesh/units.h), whatever those are in which it
// comes and goes.
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <vector>

#include "coarsening/options.h"
#include "deformation/options.h"
#include "equilibrium/equilibrator.h"
#include "evolution/evolution.h"
#include "mesh/units.h"

namespace foam {

/// Newton's method has no length of its own. The thesis's has: its constants are absolute numbers,
/// for bubbles of about 1 cm and γ of about 0.25 N/cm, and stay what they are near those.
UnitSteps unit_steps(EquilibratorKind kind);

class OwnUnitsEquilibrator final : public Equilibrator {
public:
  OwnUnitsEquilibrator(std::unique_ptr<Equilibrator> equilibrator, UnitSteps steps);

  EquilibriumReport equilibrate(Foam& foam, double t1_length, const AbortCheck& aborted) override;
  void forget() override { equilibrator_->forget(); }

private:
  std::unique_ptr<Equilibrator> equilibrator_;
  UnitSteps steps_;
};

/// The units, and an automatic time step, are those of the foam that it begins with, until it
/// begins anew. \tparam Options of what evolves.
template <class Options> class OwnUnitsEvolution final : public Evolution {
public:
  /// For a foam such as the one given.
  using Make = std::function<std::unique_ptr<Evolution>(const Options&, const Foam&)>;

  OwnUnitsEvolution(const Options& options, Make make);

  void restart(Foam foam) override;
  bool advance(const AbortCheck& aborted) override;
  const Foam& foam() const override;
  double frame_time() const override { return evolution_->frame_time(); }
  const FoamRecord& record() const override;
  std::vector<TopologicalEvent> events() const override;
  SampledFoam sample(double chord_error) override;
  FoamStatistics statistics(bool include_boundary) override;

private:
  Options options_;
  Make make_;
  UnitChange own_;
  std::unique_ptr<Evolution> evolution_;
  Options its_options_;        ///< evolution_'s
  bool has_obstacles_ = false; ///< the foam that it was made for
  mutable std::optional<Foam> foam_;
  mutable FoamRecord record_;
};

extern template class OwnUnitsEvolution<CoarseningOptions>;
extern template class OwnUnitsEvolution<DeformationOptions>;
using OwnUnitsCoarsening = OwnUnitsEvolution<CoarseningOptions>;
using OwnUnitsDeformation = OwnUnitsEvolution<DeformationOptions>;

} // namespace foam
