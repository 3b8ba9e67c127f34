// SPDX-License-Identifier: GPL-3.0-or-later
#include "junction/junction_step.h"

namespace foam::junction {

MovementConstraints::MovementConstraints(const Foam& foam, Index junction,
                                         const JunctionOptions& options)
    : foam_(foam), junction_(junction), energy_decay_(options.energy_decay),
      orientation_invariant_(options.orientation_invariant) {
  if (energy_decay_) {
    energy_ = local_energy(junction_star(foam_, junction_));
  }
  if (orientation_invariant_) {
    oriented_ = orientations();
  }
}

bool MovementConstraints::hold() const {
  if (energy_decay_ && !(local_energy(junction_star(foam_, junction_)) <= energy_)) {
    return false;
  }
  if (!orientation_invariant_) {
    return true;
  }
  // The invariant is to be maintained: a junction that was inverted before binds nobody.
  const auto now = orientations();
  for (std::size_t k = 0; k < now.size(); ++k) {
    if (oriented_[k] && !now[k]) {
      return false;
    }
  }
  return true;
}

std::array<bool, 4> MovementConstraints::orientations() const {
  const JunctionStar star = junction_star(foam_, junction_);
  std::array<bool, 4> result{oriented(star)};
  for (std::size_t k = 0; k < 3; ++k) {
    result[k + 1] = oriented(junction_star(foam_, foam_.end(star.half[k])));
  }
  return result;
}

JunctionChange move_junction(Foam& foam, Index junction, const JunctionStep& step,
                             const JunctionOptions& options) {
  if (!step.finite()) {
    return {.pressure = {}, .position = {}, .solvable = false};
  }
  const auto share_of_step = [&](double share) {
    const auto& dp = step.pressure;
    return JunctionChange{.pressure = {share * dp[0], share * dp[1], share * dp[2]},
                          .position = share * step.position};
  };
  if (foam.pinned(junction)) {
    return share_of_step(options.damping);
  }
  const MovementConstraints constraints(foam, junction, options);
  Vec2& position = foam.position[Foam::size(junction)];
  const Vec2 old = position;
  for (double scale = 1; scale > options.minimum_scale; scale *= 0.5) {
    const JunctionChange change = share_of_step(options.damping * scale);
    position = old + change.position;
    if (constraints.hold()) {
      return change;
    }
  }
  position = old;
  return {};
}

JunctionChange equilibrate_junction(Foam& foam, Index junction, const JunctionOptions& options) {
  const JunctionStep step = junction_step(foam, junction, options);
  const JunctionChange change = move_junction(foam, junction, step, options);
  const auto& halves = foam.junction_half[Foam::size(junction)];
  for (std::size_t k = 0; k < 3; ++k) {
    if (const Index b = foam.left(halves[k]); b != kWorld) {
      foam.pressure[Foam::size(b)] += change.pressure[k] / foam.sides[Foam::size(b)];
    }
  }
  return change;
}

} // namespace foam::junction
