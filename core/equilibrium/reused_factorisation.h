// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "algebra/multifrontal_solver.h"
#include "algebra/patch_correction.h"
#include "equilibrium/newton_matrix.h"

namespace foam {

/// The factorisation of a whole foam's or a patch's Newton matrix, which goes on serving while the
/// foam moves and changes its topology in a few places.
///
/// Where films have other neighbours since, or another shape, its solution is put right in a patch
/// around those films, with the present matrix there. What is left is small and smooth, so that an
/// iteration with it contracts.
class ReusedFactorisation {
public:
  /// \returns the number of negative pivots, or −1 if it cannot be factorised.
  Index factorise(const Foam& foam, const Region& region, const NewtonMatrix& matrix);

  /// Makes the last factorise() serve for what the whole foam is now, and rounds it: it
  /// preconditions an iteration from now on. \param matrix of the present topology and state.
  /// \returns false if too much has changed.
  bool adapt(const Foam& foam, const Region& region, const NewtonMatrix& matrix);
  /// Whether the film's half-angle was an unknown.
  bool keeps_angle(Film film) const { return unknowns_.keeps_angle(film); }

  /// Replaces the right-hand side by the solution, which is approximate after adapt().
  void solve(std::span<double> rhs);

private:
  void solve_as_before(std::span<double> rhs);
  /// What a film was when the matrix was factorised.
  struct FilmState {
    std::array<Junction, 2> ends; ///< start, end
    std::array<Bubble, 2> sides;  ///< left, right
    Vec2 chord;
    double angle = 0;

    /// Whether it has become another since.
    bool changed(const FilmState& now) const;
  };
  /// Around the films that have changed.
  struct Patch {
    std::uint64_t topology = 0;
    std::vector<Bubble> bubbles; ///< at those films
    PatchCorrection<FilmLagrangian::kVariables> correction;
  };
  static FilmState state_of(const Foam& foam, Film film);
  std::vector<Bubble> changed_bubbles(const Foam& foam, const Region& region) const;
  bool make_patch(const Foam& foam, const Region& region, std::vector<Bubble> bubbles,
                  const NewtonMatrix& matrix);

  MultifrontalSolver solver_;
  int numbering_ = 0; ///< of the matrix that was analysed
  bool whole_ = false;
  Surroundings surroundings_;
  Unknowns unknowns_;
  Field<Film, FilmState> films_;
  std::uint64_t topology_ = 0;     ///< that unknowns_ or renumbering_ is for
  std::vector<Index> renumbering_; ///< to unknowns_; empty while the topology is the same
  std::unique_ptr<Patch> patch_;   ///< nothing while no film has changed
};

} // namespace foam
