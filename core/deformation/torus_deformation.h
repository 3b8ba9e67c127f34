// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "deformation/options.h"
#include "equilibrium/newton_equilibrator.h"
#include "evolution/evolution.h"
#include "physics/rates.h"

namespace foam {

/// Quasi-static deformation of a torus by its periods, from one T1 to the next.
///
/// Between T1s positions, half-angles and pressures are smooth in the strain, and a film that is to
/// be swapped shrinks to nothing linearly: the equilibrium's response to the flow
/// (newton::FactorisingSolver::response) predicts at which strain, and the foam is brought to it as
/// by Newton's method for the root of the film's length, be the frames long or short. All films
/// that vanish at one strain are swapped together, and the foam relaxes at that strain; films that
/// are pulled shut meanwhile are swapped as well. Its target areas stay.
///
/// The periods are always the shortest ones (reduced). A frame counts |strain step| of time.
class TorusDeformation final : public Evolution {
public:
  /// \throws FoamError for options out of range.
  explicit TorusDeformation(const DeformationOptions& options);

  /// \throws FoamError if the foam is not periodic.
  void restart(Foam foam) override;
  bool advance(const AbortCheck& aborted) override;
  const Foam& foam() const override { return foam_; }
  double frame_time() const override;

private:
  /// Per unit of strain, of the foam of some topology.
  struct Response {
    std::uint64_t topology = 0;
    Field<Junction, Vec2> junctions; ///< beside what the flow moves them by
    Field<Film, double> angles;
    Field<Bubble, double> pressures;

    Rates view() const { return {junctions, angles, pressures}; }
  };

  bool cover(double way, const AbortCheck& aborted);
  bool strain_by(double way, const AbortCheck& aborted);
  void turn_at_amplitude();
  void predict();
  double growth(Film film) const;
  double strain_to_close(Film film) const;
  double next_closing() const;
  double near_closing(double wait) const;
  double swap_closing(double wait);
  bool arrive(double& way, const AbortCheck& aborted);
  bool jump(double way, const AbortCheck& aborted);
  void follow(double way);
  bool relax(double t1_length, int most_iterations, const AbortCheck& aborted);
  bool relax_swapping(const AbortCheck& aborted);
  double reachable_tolerance() const;
  void undo(Foam foam);

  DeformationOptions options_;
  Tensor flow_;
  NewtonEquilibrator newton_;
  Foam foam_;
  Response response_, before_; ///< here, and where the foam stood before
  double since_before_ = 0;    ///< strain from there; 0 if it means nothing
  bool predicted_ = false;     ///< the response is that of the foam as it stands
  int iterations_ = 0;
};

} // namespace foam
