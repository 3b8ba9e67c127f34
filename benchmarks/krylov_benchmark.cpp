// SPDX-License-Identifier: GPL-3.0-or-later
//
// Newton's linear systems solved by MINRES (core/equilibrium/parallel_newton.h) beside a sparse
// factorisation: iterations, which are the same on every machine, and processor time. The foams
// are disordered honeycombs in equilibrium, and they answer to a frame of diffusion. Writes a table
// in Markdown. Arguments: bubbles along a side of the foam, as many as wanted.
#include <algorithm>
#include <ctime>
#include <iostream>
#include <vector>

#include "construct/honeycomb.h"
#include "equilibrium/factorising_solver.h"
#include "equilibrium/whole_foam_newton.h"
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
      : mesh_(view_of(std::as_const(foam))), units_{foam.mean_spacing(), foam.reference_tension()},
        stiffness_(foam.film_angle.size()), gradient_(foam.film_angle.size()),
        solution_(place_of(newton::size_of(mesh_))) {}

  void set_up() {
    linearise(host_, mesh_, units_, 0, FieldView<Film, FilmStiffness>(stiffness_.data()),
              FieldView<Film, FilmGradient>(gradient_.data()));
    preconditioner_.set_up(matrix(), units_);
  }

  /// \returns iterations.
  int solve(const std::vector<double>& right, double tolerance) {
    return solver_.solve(
        newton::size_of(mesh_), right.data(), solution_.data(), tolerance, 1000,
        [&](const double* from, double* to) { newton::multiply(host_, matrix(), from, to); },
        [&](const double* from, double* to) { preconditioner_.apply(from, to); });
  }

private:
  newton::WholeFoamMatrix matrix() const {
    return {mesh_, FieldView<Film, const FilmStiffness>(stiffness_.data()),
            FieldView<Film, const FilmGradient>(gradient_.data()), units_.length};
  }

  Host host_{1};
  ConstFoamView mesh_;
  newton::Units units_;
  std::vector<FilmStiffness> stiffness_;
  std::vector<FilmGradient> gradient_;
  std::vector<double> solution_;
  newton::FoamPreconditioner<Host> preconditioner_{host_};
  MinimalResidual<Host> solver_{host_};
};

/// Areas that grow as they would by von Neumann's law, and stay the same all in all.
std::vector<double> diffusion(const Foam& foam) {
  std::vector<double> right(foam.pressure.size() + 2 * foam.position.size());
  for (const Bubble b : foam.bubble_slots()) {
    right[2 * foam.position.size() + b.place()] = foam.sides[b] - 6;
  }
  return right;
}

double factorise_and_solve(const Foam& foam) {
  newton::FactorisingSolver solver;
  solver.set_up(foam, whole_foam(foam));
  const Domain domain = domain_of(solver.region());
  Host host;
  newton::Evaluation<Host> state;
  state.evaluate(host, view_of(foam), domain);
  return processor_seconds([&] { solver.find(foam, domain, state, newton::Residual{}); });
}

void measure(Index side) {
  Foam foam = honeycomb({.columns = side, .rows = side, .displacement = 0.15, .swaps = 0.2});
  Host host;
  newton::WholeFoamNewton<Host> equilibrator(host, {});
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
