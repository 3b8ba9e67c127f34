// SPDX-License-Identifier: GPL-3.0-or-later
#include "sampling/sampled_foam.h"

#include "parallel/host.h"
#include "sampling/foam_sampler.h"

namespace foam {

SampledFoam sample(const Foam& foam, double chord_error) {
  Host host;
  SampledFoam sampled =
      FoamSampler<Host>(host).sample(view_of(foam), BubbleNames<Host>(foam.bubble_id), chord_error);
  sampled.record = static_cast<const FoamRecord&>(foam);
  sampled.exteriors = foam.exterior;
  return sampled;
}

} // namespace foam
