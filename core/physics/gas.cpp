// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/gas.h"

#include <numbers>

#include "parallel/host.h"

namespace foam {

double von_neumann_constant(double surface_tension, double kappa) {
  return 2 * std::numbers::pi / 3 * surface_tension * kappa;
}

namespace {

/// Of the AreaRate of a bubble, cm²/s².
struct AreaRateChange {
  AreaRate rate;
  std::span<const double> angle_rates; ///< rad/s

  double operator()(Bubble bubble) const {
    double change = 0;
    if (rate.measured(bubble)) {
      for_each_half(rate.mesh, bubble, [&](Half h) {
        const double turn = angle_rates[h.film().place()];
        change -= permeability(rate.mesh, h, rate.kappa) * rate.mesh.tension(h.film()) * 2 *
                  (h == h.film().half() ? turn : -turn);
      });
    }
    return change;
  }
  bool takes_a_share(Bubble bubble) const { return rate.takes_a_share(bubble); }
};

/// Of all bubbles, 0 for those that are gone; a closed foam's total is conserved.
template <class Rate> Field<Bubble, double> balanced(const Foam& foam, const Rate& rate) {
  Host host(1);
  const double excess = sum_bubbles(host, view_of(foam), rate).excess();
  Field<Bubble, double> rates(foam.pressure.size(), 0.0);
  for (const Bubble b : foam.bubble_slots()) {
    if (foam.has_bubble(b)) {
      rates[b] = detail::balanced(foam, rate, b, excess);
    }
  }
  return rates;
}

} // namespace

AreaRate area_rate(const ConstFoamView& mesh, double kappa) {
  return {mesh, von_neumann_constant(mesh.surface_tension, kappa), kappa};
}

Field<Bubble, double> area_rates(const Foam& foam, double kappa) {
  return balanced(foam, area_rate(view_of(foam), kappa));
}

bool area_rates_change(const Foam& foam) {
  bool change = false;
  if (foam.surroundings.has_walls()) {
    for (const Piece piece : foam.piece_slots()) {
      change = change || foam.wall_piece[piece].half_angle != 0 || starts_at_edge(foam, piece) ||
               foam.exterior[foam.piece_outside[piece]].contact == WallContact::Pinned;
    }
  }
  for (const Film f : foam.film_slots()) {
    change = change || (foam.has_film(f) && foam.tension(f) != foam.reference_tension());
  }
  return change;
}

Field<Bubble, double> area_rate_changes(const Foam& foam, double kappa,
                                        std::span<const double> angle_rates) {
  return balanced(foam, AreaRateChange{area_rate(view_of(foam), kappa), angle_rates});
}

} // namespace foam
