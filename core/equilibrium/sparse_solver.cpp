// SPDX-License-Identifier: GPL-3.0-or-later
#include "equilibrium/sparse_solver.h"

namespace foam {

#ifdef FOAM_HAVE_MUMPS
namespace {

/// Below this many unknowns MUMPS's housekeeping takes longer than its blocks save.
constexpr Index kSmall = 8000;

/// The faster one for the size of a system; for a small one that needs pivoting, MUMPS all the
/// same.
class SolverBySize final : public SparseSolver {
public:
  void analyse(const SymmetricPattern& pattern) override {
    pattern_ = pattern;
    if (pattern.size() >= kSmall) {
      choose(mumps_, make_mumps_solver);
    } else {
      choose(eigen_, make_eigen_solver);
    }
  }

  Index factorise(std::span<const double> values) override {
    const Index negative = chosen_->factorise(values);
    if (negative >= 0 || chosen_ == mumps_.get()) {
      return negative;
    }
    choose(mumps_, make_mumps_solver);
    return chosen_->factorise(values);
  }

  void solve(std::span<double> rhs) override { chosen_->solve(rhs); }

private:
  void choose(std::unique_ptr<SparseSolver>& solver, std::unique_ptr<SparseSolver> (*make)()) {
    if (!solver) {
      solver = make();
    }
    solver->analyse(pattern_);
    chosen_ = solver.get();
  }

  SymmetricPattern pattern_;
  std::unique_ptr<SparseSolver> eigen_, mumps_;
  SparseSolver* chosen_ = nullptr;
};

} // namespace
#endif

std::unique_ptr<SparseSolver> make_sparse_solver() {
#ifdef FOAM_HAVE_MUMPS
  return std::make_unique<SolverBySize>();
#else
  return make_eigen_solver();
#endif
}

} // namespace foam
