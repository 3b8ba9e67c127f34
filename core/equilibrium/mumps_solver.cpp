// SPDX-License-Identifier: GPL-3.0-or-later
//
// MUMPS (P. R. Amestoy, I. S. Duff, J.-Y. L'Excellent, J. Koster, SIAM J. Matrix Anal. Appl. 23
// (2001) 15): multifrontal LDLᵀ with pivoting, sequential build.
#include <dmumps_c.h>

#include <mutex>

#include "equilibrium/sparse_solver.h"

namespace foam {
namespace {

class MumpsSolver final : public SparseSolver {
public:
  MumpsSolver() {
    mumps_.comm_fortran = -987654; // MPI_COMM_WORLD, as MUMPS spells it
    mumps_.par = 1;
    mumps_.sym = 2;
    call(kInitialise);
    for (const int stream : {1, 2, 3}) {
      control(stream) = 0;
    }
    control(4) = 0;
  }
  ~MumpsSolver() override { call(kFinalise); }

  void analyse(const SymmetricPattern& pattern) override {
    rows_.clear();
    columns_.clear();
    for (Index column = 0; column < pattern.size(); ++column) {
      for (Index k = pattern.column_start[Foam::size(column)];
           k < pattern.column_start[Foam::size(column + 1)]; ++k) {
        rows_.push_back(pattern.row[Foam::size(k)] + 1);
        columns_.push_back(column + 1);
      }
    }
    mumps_.n = pattern.size();
    mumps_.nnz = static_cast<MUMPS_INT8>(rows_.size());
    mumps_.irn = rows_.data();
    mumps_.jcn = columns_.data();
    control(7) = kAmf;
    control(6) = 0;   // no column permutation from values, which are not there yet
    control(14) = 50; // per cent of working space to spare
    call(kAnalyse);
  }

  Index factorise(std::span<const double> values) override {
    values_.assign(values.begin(), values.end());
    mumps_.a = values_.data();
    call(kFactorise);
    while (mumps_.infog[0] == -8 || mumps_.infog[0] == -9) { // working space too small
      control(14) *= 2;
      call(kFactorise);
    }
    return mumps_.infog[0] < 0 ? -1 : mumps_.infog[11];
  }

  void solve(std::span<double> rhs) override {
    mumps_.rhs = rhs.data();
    mumps_.nrhs = 1;
    mumps_.lrhs = static_cast<MUMPS_INT>(rhs.size());
    call(kSolve);
  }

private:
  enum Job { kInitialise = -1, kFinalise = -2, kAnalyse = 1, kFactorise = 2, kSolve = 3 };
  static constexpr int kAmf = 2; // approximate minimum fill

  void call(Job job) {
    static std::mutex one_at_a_time; // MUMPS keeps global state
    const std::scoped_lock lock(one_at_a_time);
    mumps_.job = job;
    dmumps_c(&mumps_);
  }
  /// ICNTL as the users' guide numbers it.
  MUMPS_INT& control(int i) { return mumps_.icntl[i - 1]; }

  DMUMPS_STRUC_C mumps_{};
  std::vector<MUMPS_INT> rows_, columns_;
  std::vector<double> values_;
};

} // namespace

std::unique_ptr<SparseSolver> make_mumps_solver() {
  return std::make_unique<MumpsSolver>();
}

} // namespace foam
