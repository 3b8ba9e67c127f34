// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton's linear systems solved by MINRES (core/equilibrium/parallel_newton.h) beside a sparse
// factorisation: iterations, which are the same on every machine, and processor time. The foams are
// disordered honeycombs in equilibrium, and they answer to a frame of diffusion. Writes a table in
// Markdown. Arguments: bubbles along a side of the foam, as many as wanted.
#include <algorithm>
#include <ctime>
#include <iostream>
#include <vector>

#include "construct/honeycomb.h"
#include "equilibrium/lagrangian_system.h"
#include "equilibrium/parallel_newton.h"
#include "parallel/host.h"

namespace foam {
namespace {

constexpr Index kLargestFactorised = 100000; // bubbles; the factors of a million take 8 GB or so

template <class Work> double processor_seconds(Work&& work) {
  const std::clock_t begin = std::clock();
  work();
  return static_cast<double>(std::clock() - begin) / CLOCKS_PER_SEC;
}

/// Newton's matrix of a foam and its preconditioner.
class Krylov {
public:
  explicit Krylov(Foam& foam)
      : mesh_(view_of(foam)), units_{foam.mean_spacing(), 2 * foam.surface_tension},
        stiffness_(foam.film_angle.size()), gradient_(foam.film_angle.size()),
        solution_(Foam::size(newton::size_of(mesh_))) {}

  void set_up() {
    host_.for_each(mesh_.films,
                   newton::Linearise{mesh_, units_, 0, stiffness_.data(), gradient_.data()});
    preconditioner_.set_up({mesh_, stiffness_.data()}, units_);
  }

  /// \returns iterations.
  int solve(const std::vector<double>& right, double tolerance) {
    const newton::WholeFoamMatrix matrix{mesh_, stiffness_.data()};
    return solver_.solve(
        newton::size_of(mesh_), right.data(), solution_.data(), tolerance, 1000,
        [&](const double* from, double* to) {
          host_.for_each(mesh_.junctions + mesh_.bubbles, newton::Multiply{matrix, from, to});
        },
        [&](const double* from, double* to) { preconditioner_.apply(from, to); });
  }

private:
  Host host_{1};
  FoamView mesh_;
  newton::Units units_;
  std::vector<newton::FilmStiffness> stiffness_;
  std::vector<newton::FilmGradient> gradient_;
  std::vector<double> solution_;
  newton::FoamPreconditioner<Host> preconditioner_{host_};
  newton::MinimalResidual<Host> solver_{host_};
};

/// Areas that grow as they would by von Neumann's law, and stay the same all in all.
std::vector<double> diffusion(const Foam& foam) {
  std::vector<double> right(foam.pressure.size() + 2 * foam.position.size());
  for (Index b = 0; b < foam.bubble_capacity(); ++b) {
    right[2 * foam.position.size() + Foam::size(b)] = foam.sides[Foam::size(b)] - 6;
  }
  return right;
}

double factorise_and_solve(const Foam& foam) {
  LagrangianSystem system;
  system.set_up(foam, whole_foam(foam));
  system.evaluate(foam);
  return processor_seconds([&] {
    system.factorise(foam, foam.bubble_capacity());
    system.newton_step(foam);
  });
}

void measure(Index side) {
  Foam foam = honeycomb({.columns = side, .rows = side, .displacement = 0.15, .swaps = 0.2});
  Host host;
  newton::ParallelNewton<Host> equilibrator(host, {});
  const newton::NewtonResult found =
      equilibrator.equilibrate(view_of(foam), 0.1 * foam.mean_spacing(), {});
  std::cout << "| " << side * side << " | " << found.report.iterations << " | "
            << found.inner_iterations << " | " << found.report.residual;
  Krylov krylov(foam);
  const double set_up = processor_seconds([&] { krylov.set_up(); });
  const std::vector<double> right = diffusion(foam);
  double last = 0;
  for (const double tolerance : {1e-2, 1e-4, 1e-6}) {
    int iterations = 0;
    last = processor_seconds([&] { iterations = krylov.solve(right, tolerance); });
    std::cout << " | " << iterations;
  }
  std::cout << " | " << set_up << " | " << last << " | ";
  if (side * side <= kLargestFactorised) {
    std::cout << factorise_and_solve(foam);
  }
  std::cout << " |" << std::endl;
}

} // namespace
} // namespace foam

int main(int argc, char** argv) {
  std::cout << "| bubbles | Newton steps to 1e-9 | MINRES iterations of all | residual | of one "
               "system to 1e-2 | to 1e-4 | to 1e-6 | s to set up | s for 1e-6 | s to factorise and "
               "solve |\n|--|--|--|--|--|--|--|--|--|--|\n";
  for (int i = 1; i < argc; ++i) {
    foam::measure(static_cast<foam::Index>(std::stoi(argv[i])));
  }
}
