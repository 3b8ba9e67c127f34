// SPDX-License-Identifier: GPL-3.0-or-later
#include "physics/equilibrium_measures.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "mesh/element_measures.h"
#include "parallel/host.h"

namespace foam {
namespace {

/// The largest of error(e) for all elements e, and 0.
template <class Element, class Error> double largest(Slots<Element> slots, const Error& error) {
  std::vector<double> errors(place_of(slots.size()) + 1);
  Host().for_each(slots, [&](Element e) { errors[e.place()] = error(e); });
  return std::ranges::max(errors);
}

/// Part of its direction (rad) or length that a film may lose where both ends are rounded.
double relative_rounding(const Foam& foam, Film film, double rounding) {
  return 4 * rounding / norm(foam.chord(film.half()));
}

double angle_rounding(const Foam& foam, Junction junction, double rounding) {
  double sum = 0;
  for (const Half h : foam.junction_half[junction]) {
    sum += relative_rounding(foam, h.film(), rounding);
  }
  return sum;
}

double area_rounding(const Foam& foam, Bubble bubble, double rounding) {
  double sum = 0;
  for_each_half(foam, bubble, [&](Half h) { sum += 4 * rounding * foam.length(h); });
  return sum / foam.target_area[bubble];
}

double curvature_rounding(const Foam& foam, Film film, double rounding) {
  return 4 * rounding * std::abs(foam.pressure_difference(film.half())) / foam.tension(film);
}

/// The largest of each error, less what rounding of coordinates may do to it.
double worst_angle(const Foam& foam, double rounding) {
  return largest(foam.junction_slots(), [&](Junction j) {
    return foam.moves(j) ? angle_error(foam, j) - angle_rounding(foam, j, rounding) : 0;
  });
}

double worst_area(const Foam& foam, double rounding) {
  return largest(foam.bubble_slots(), [&](Bubble b) {
    return foam.has_bubble(b) ? area_error(foam, b) - area_rounding(foam, b, rounding) : 0;
  });
}

double worst_curvature(const Foam& foam, double rounding) {
  return largest(foam.film_slots(), [&](Film f) {
    return foam.bends(f) ? curvature_error(foam, f) - curvature_rounding(foam, f, rounding) : 0;
  });
}

} // namespace

double max_angle_error(const Foam& foam) {
  return worst_angle(foam, 0);
}

double max_area_error(const Foam& foam) {
  return worst_area(foam, 0);
}

double max_curvature_error(const Foam& foam) {
  return worst_curvature(foam, 0);
}

EquilibriumReport measured_report(const Foam& foam) {
  EquilibriumReport report;
  report.max_angle_error = max_angle_error(foam);
  report.max_area_error = max_area_error(foam);
  report.residual =
      std::max({report.max_angle_error, report.max_area_error, max_curvature_error(foam)});
  return report;
}

bool holds(const EquilibriumReport& report, const Foam& foam, double rounding) {
  // A part that was said to be off by so much; what remains are the last digits of measuring.
  const auto explained = [](double measured, double said) {
    return measured <= 1.01 * said + 1e-12;
  };
  const double said_in_all =
      std::max({report.max_angle_error, report.max_area_error, report.residual});
  return explained(worst_angle(foam, rounding), report.max_angle_error) &&
         explained(worst_area(foam, rounding), report.max_area_error) &&
         explained(worst_curvature(foam, rounding), said_in_all);
}

EquilibriumReport confirmed(const EquilibriumReport& report, const Foam& foam, double rounding) {
  const bool explained = holds(report, foam, rounding);
  const auto near = [](double measured, double said) {
    return measured <= 1.01 * said + 1e-7 && measured >= 0.99 * said - 1e-9;
  };
  EquilibriumReport measured = measured_report(foam);
  if (explained && near(measured.max_angle_error, report.max_angle_error) &&
      near(measured.max_area_error, report.max_area_error)) {
    return report;
  }
  constexpr double kLargestRounding = 1e-3; // that leaves an equilibrium what it is
  measured.converged = report.converged && explained && measured.residual < kLargestRounding;
  measured.iterations = report.iterations;
  return measured;
}

} // namespace foam
