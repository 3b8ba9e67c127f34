// SPDX-License-Identifier: GPL-3.0-or-later
#include "deformation/moduli.h"

#include "base/error.h"
#include "equilibrium/factorising_solver.h"
#include "mesh/units.h"

namespace foam {
namespace {

/// \pre the step is one of a whole foam
Rates rates_of(const newton::StepView& step, const Foam& foam) {
  return {{step.junction.data(), foam.position.size()},
          {step.angle.data(), foam.film_angle.size()},
          {step.pressure.data(), foam.pressure.size()}};
}

} // namespace

SymmetricTensor stress_change(const Foam& foam, const Tensor& flow) {
  if (!foam.surroundings.periodic()) {
    throw FoamError("a torus alone is strained by its periods, but this foam is not periodic");
  }
  newton::FactorisingSolver solver;
  solver.set_up(foam, whole_foam(foam));
  const Field<Bubble, double> no_growth(foam.target_area.size(), 0.0);
  const newton::StepView* response = solver.response(foam, no_growth, {}, 0, flow);
  if (response != nullptr) { // what holds free directions is felt in the ninth digit
    response = solver.response(foam, no_growth, rates_of(*response, foam), 0, flow);
  }
  if (response == nullptr) {
    throw FoamError("the foam has no definite response to a strain: it is not in equilibrium");
  }
  SymmetricTensor sum;
  for (const Film f : solver.region().films) {
    const Vec2 chord = foam.chord(f.half());
    const Vec2 change = flow * chord + response->chord_change(view_of(foam), f);
    sum += foam.tension(f) *
           arc_tangents_change(chord, change, foam.half_angle(f.half()), response->angle[f]);
  }
  for (const Bubble b : solver.region().bubbles) {
    sum = sum - isotropic(response->pressure[b] * foam.target_area[b]);
  }
  return (1 / foam.surroundings.lattice.area()) * sum;
}

double shear_modulus(Foam foam, DeformationKind kind) {
  const UnitChange own = own_units(foam, UnitSteps::Fine);
  change_units(foam, own);
  const SymmetricTensor change =
      own.inverse().pressure() * stress_change(foam, velocity_gradient(kind));
  return kind == DeformationKind::SimpleShear ? change.xy : 0.25 * (change.xx - change.yy);
}

} // namespace foam
