// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/sampled_foam.h"

#include "parallel/host.h"
#include "sampling/foam_sampler.h"

namespace foam {

void take_outsides(const Foam& foam, SampledFoam& sampled) {
  sampled.exteriors = foam.exterior;
  sampled.wall_pieces = foam.wall_piece;
  sampled.wall_forces = wall_forces(foam);
}

SampledFoam sample(const Foam& foam, double chord_error) {
  Host host;
  SampledFoam sampled =
      FoamSampler<Host>(host).sample(view_of(foam), BubbleNames<Host>(foam.bubble_id), chord_error);
  sampled.record = static_cast<const FoamRecord&>(foam);
  take_outsides(foam, sampled);
  return sampled;
}

} // namespace foam
