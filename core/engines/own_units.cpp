// SPDX-License-Identifier: GPL-3.0-or-later
#include "engines/own_units.h"

#include <utility>
#include <vector>

#include "mesh/hosted_walls.h"
#include "physics/gas.h"

namespace foam {
namespace {

CoarseningOptions in_units(CoarseningOptions options, const UnitChange& change) {
  options.permeability *= change.area() / change.tension;
  ThresholdOptions& asked = options.thresholds;
  const Thresholds limit = in_units(Thresholds{asked.t1_length, asked.t2_area}, change);
  asked.t1_length = limit.t1_length;
  asked.t2_area = limit.t2_area;
  return options;
}

/// The options in a foam's own units, noted in the foam as it comes.
CoarseningOptions prepared(const CoarseningOptions& asked, Foam& foam, const UnitChange& own) {
  CoarseningOptions options = in_units(asked, own);
  options.time_step = foam.time_step = time_step(asked, foam, foam.mean_area());
  foam.growth_constant = von_neumann_constant(foam.surface_tension, asked.permeability);
  return options;
}

/// Strains are the same in any units.
DeformationOptions prepared(const DeformationOptions& asked, Foam& /*foam*/,
                            const UnitChange& /*own*/) {
  return asked;
}

void multiply(std::vector<double>& values, double factor) {
  for (double& value : values) {
    value *= factor;
  }
}

void move(std::vector<Point3>& points, const UnitChange& change) {
  for (Point3& p : points) {
    const Vec2 place = change.place({p[0], p[1]});
    p = {place.x, place.y, p[2]};
  }
}

void change_units(std::vector<BubbleStatistics>& bubbles, const UnitChange& change) {
  for (BubbleStatistics& bubble : bubbles) {
    bubble.area *= change.area();
    bubble.target_area *= change.area();
    bubble.pressure *= change.pressure();
    bubble.perimeter *= change.length;
    bubble.stress = change.pressure() * bubble.stress;
  }
}

void change_units(FoamStatistics& statistics, const UnitChange& change) {
  statistics.mean_area *= change.area();
  statistics.energy *= change.energy();
  statistics.stress = change.pressure() * statistics.stress;
  change_units(statistics.each, change);
}

void change_units(SampledFoam& foam, const UnitChange& change) {
  foam.record = in_units(foam.record, change);
  for (Exterior& exterior : foam.exteriors) {
    exterior = in_units(exterior, change);
  }
  for (WallForce& force : foam.wall_forces) {
    force = {change.tension * force.network, change.tension * force.pressure};
  }
  for (WallPiece& piece : foam.wall_pieces) {
    piece = in_units(piece, change);
  }
  foam.energy *= change.energy();
  move(foam.films.points, change);
  multiply(foam.films.curvature, 1 / change.length);
  multiply(foam.films.pressure_difference, change.pressure());
  multiply(foam.films.length, change.length);
  multiply(foam.films.tension, change.tension);
  move(foam.bubbles.points, change);
  change_units(foam.bubbles.each, change);
}

/// A foam in other units for as long as this lives.
class InUnits {
public:
  InUnits(Foam& foam, const UnitChange& change) : foam_(foam), back_(change.inverse()) {
    change_units(foam_, change);
  }
  InUnits(const InUnits&) = delete;
  InUnits& operator=(const InUnits&) = delete;
  ~InUnits() { change_units(foam_, back_); }

private:
  Foam& foam_;
  UnitChange back_;
};

} // namespace

UnitSteps unit_steps(EquilibratorKind kind) {
  return kind == EquilibratorKind::Junction ? UnitSteps::Coarse : UnitSteps::Fine;
}

OwnUnitsEquilibrator::OwnUnitsEquilibrator(std::unique_ptr<Equilibrator> equilibrator,
                                           UnitSteps steps)
    : equilibrator_(std::move(equilibrator)), steps_(steps) {}

EquilibriumReport OwnUnitsEquilibrator::equilibrate(Foam& foam, double t1_length,
                                                    const AbortCheck& aborted) {
  const UnitChange own = own_units(foam, steps_);
  const InUnits in_own(foam, own);
  return equilibrator_->equilibrate(foam, own.length * t1_length, aborted);
}

template <class Options>
OwnUnitsEvolution<Options>::OwnUnitsEvolution(const Options& options, Make make)
    : options_(options), make_(std::move(make)) {}

template <class Options> void OwnUnitsEvolution<Options>::restart(Foam foam) {
  const UnitChange own = own_units(foam, unit_steps(options_.equilibrator.kind));
  const Options options = prepared(options_, foam, own);
  change_units(foam, own);
  const bool obstacles = has_obstacles(foam);
  const bool alike = options == its_options_ && obstacles == has_obstacles_;
  auto anew = evolution_ && alike ? nullptr : make_(options, foam);
  (anew ? *anew : *evolution_).restart(std::move(foam));
  if (anew) {
    evolution_ = std::move(anew);
    its_options_ = options;
    has_obstacles_ = obstacles;
  }
  own_ = own;
  foam_.reset();
}

template <class Options> bool OwnUnitsEvolution<Options>::advance(const AbortCheck& aborted) {
  foam_.reset();
  return evolution_->advance(aborted);
}

template <class Options> const Foam& OwnUnitsEvolution<Options>::foam() const {
  if (own_.changes_nothing()) {
    return evolution_->foam();
  }
  if (!foam_) {
    foam_ = evolution_->foam();
    change_units(*foam_, own_.inverse());
  }
  return *foam_;
}

template <class Options> const FoamRecord& OwnUnitsEvolution<Options>::record() const {
  record_ = in_units(evolution_->record(), own_.inverse());
  return record_;
}

template <class Options> std::vector<TopologicalEvent> OwnUnitsEvolution<Options>::events() const {
  std::vector<TopologicalEvent> events = evolution_->events();
  const UnitChange back = own_.inverse();
  for (TopologicalEvent& event : events) {
    event.place = back.place(event.place);
  }
  return events;
}

template <class Options> SampledFoam OwnUnitsEvolution<Options>::sample(double chord_error) {
  if (own_.shift != Vec2{}) { // a place in between that is not a junction would be rounded twice
    return foam::sample(foam(), chord_error);
  }
  SampledFoam sampled = evolution_->sample(own_.length * chord_error);
  if (!own_.changes_nothing()) {
    change_units(sampled, own_.inverse());
  }
  return sampled;
}

template <class Options>
FoamStatistics OwnUnitsEvolution<Options>::statistics(bool include_boundary) {
  FoamStatistics result = evolution_->statistics(include_boundary);
  change_units(result, own_.inverse());
  return result;
}

template class OwnUnitsEvolution<CoarseningOptions>;
template class OwnUnitsEvolution<DeformationOptions>;

} // namespace foam
