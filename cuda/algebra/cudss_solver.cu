// SPDX-License-Identifier: GPL-3.0-or-later
//
// NVIDIA's cuDSS, 0.8 or later, on the default stream. The matrices of a foam near equilibrium are
// quasi-definite, so that the pivots on the diagonal that it takes for symmetric matrices will do.
#include <cudss.h>

#include <string>
#include <type_traits>

#include "algebra/device_direct_solver.h"
#include "base/error.h"
#include "parallel/gpu.cuh"
#include "parallel/kernels.h"

namespace foam::cuda {
namespace {

std::string describe(cudssStatus_t status) {
  switch (status) {
  case CUDSS_STATUS_NOT_INITIALIZED:
    return "it is not initialised";
  case CUDSS_STATUS_ALLOC_FAILED:
    return "out of memory";
  case CUDSS_STATUS_INVALID_VALUE:
    return "an invalid value";
  case CUDSS_STATUS_NOT_SUPPORTED:
    return "not supported";
  case CUDSS_STATUS_EXECUTION_FAILED:
    return "a kernel failed";
  default:
    return "status " + std::to_string(static_cast<int>(status));
  }
}

/// \throws FoamError if a call of cuDSS has failed.
void check(cudssStatus_t status, const char* call) {
  if (status != CUDSS_STATUS_SUCCESS) {
    throw FoamError(std::string("cuDSS: ") + call + " failed: " + describe(status));
  }
}

struct Destroy {
  cudssHandle_t library = nullptr; ///< of data

  void operator()(cudssHandle_t handle) const { cudssDestroy(handle); }
  void operator()(cudssConfig_t config) const { cudssConfigDestroy(config); }
  void operator()(cudssData_t data) const { cudssDataDestroy(library, data); }
  void operator()(cudssMatrix_t matrix) const { cudssMatrixDestroy(matrix); }
};

template <class Handle> using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Destroy>;

using Library = Owned<cudssHandle_t>;
using Config = Owned<cudssConfig_t>;
using Data = Owned<cudssData_t>;
using Matrix = Owned<cudssMatrix_t>;

Library make_library() {
  cudssHandle_t handle = nullptr;
  check(cudssCreate(&handle), "its start");
  return Library(handle);
}

Config make_config() {
  cudssConfig_t config = nullptr;
  check(cudssConfigCreate(&config), "a configuration");
  return Config(config);
}

Data make_data(const Library& library) {
  cudssData_t data = nullptr;
  check(cudssDataCreate(library.get(), &data), "making room for factors");
  return Data(data, Destroy{library.get()});
}

/// It refers to the arrays.
Matrix make_matrix(const LowerTriangle& m) {
  cudssMatrix_t matrix = nullptr;
  check(cudssMatrixCreateCsr(&matrix, m.size, m.size, m.entries, m.first, nullptr, m.column,
                             m.value, CUDSS_R_32I, CUDSS_R_32I, CUDSS_R_64F, CUDSS_MTYPE_SYMMETRIC,
                             CUDSS_MVIEW_LOWER, CUDSS_BASE_ZERO),
        "taking a matrix");
  return Matrix(matrix);
}

/// It refers to the values.
Matrix make_vector(Index size, const double* values) {
  cudssMatrix_t vector = nullptr;
  check(cudssMatrixCreateDn(&vector, size, 1, size, values, CUDSS_R_64F, CUDSS_LAYOUT_COL_MAJOR),
        "taking a vector");
  return Matrix(vector);
}

struct Differ {
  const Index* a = nullptr;
  const Index* b = nullptr;

  FOAM_HOST_DEVICE bool operator()(Index i) const { return a[i] != b[i]; }
};

class CudssSolver final : public DirectSolver {
public:
  void solve(const LowerTriangle& matrix, const double* b, double* x) override {
    const Matrix right = make_vector(matrix.size, b);
    const Matrix solution = make_vector(matrix.size, x);
    if (!is_analysed(matrix)) {
      analyse(matrix, solution, right);
    }
    check(cudssMatrixSetValues(matrix_.get(), matrix.value), "taking a matrix's values");
    check(execute(CUDSS_PHASE_FACTORIZATION, solution, right), "the factorisation");
    check(execute(CUDSS_PHASE_SOLVE, solution, right), "the solution");
  }

private:
  /// Whether a matrix has its entries in the places of the one analysed.
  bool is_analysed(const LowerTriangle& matrix) {
    const auto same = [&](const DeviceArray<Index>& mine, const Index* its, Index size) {
      return mine.size() == static_cast<std::size_t>(size) &&
             !gpu_.reduce(size, false, Differ{mine.data(), its}, parallel::Or{});
    };
    return analysed_ && same(first_, matrix.first, matrix.size + 1) &&
           same(column_, matrix.column, matrix.entries);
  }

  void analyse(const LowerTriangle& matrix, const Matrix& solution, const Matrix& right) {
    analysed_ = false;
    keep(first_, matrix.first, matrix.size + 1);
    keep(column_, matrix.column, matrix.entries);
    matrix_ =
        make_matrix({matrix.size, matrix.entries, first_.data(), column_.data(), matrix.value});
    cudssStatus_t status = analyse_once(solution, right);
    if (status == CUDSS_STATUS_NOT_SUPPORTED && deterministic_) {
      deterministic_ = false;
      status = analyse_once(solution, right);
    }
    check(status, "the analysis");
    analysed_ = true;
  }

  cudssStatus_t analyse_once(const Matrix& solution, const Matrix& right) {
    data_ = make_data(library_);
    const int deterministic = deterministic_ ? 1 : 0;
    check(cudssConfigSet(config_.get(), CUDSS_CONFIG_DETERMINISTIC_MODE, &deterministic,
                         sizeof(deterministic)),
          "a setting");
    return execute(CUDSS_PHASE_ANALYSIS, solution, right);
  }

  void keep(DeviceArray<Index>& mine, const Index* its, Index size) {
    mine.resize(static_cast<std::size_t>(size));
    gpu_.for_each(size, parallel::Copy<Index>{its, mine.data()});
  }

  cudssStatus_t execute(cudssPhase_t phase, const Matrix& solution, const Matrix& right) {
    return cudssExecute(library_.get(), phase, config_.get(), data_.get(), matrix_.get(),
                        solution.get(), right.get());
  }

  Gpu gpu_;
  Library library_ = make_library();
  Config config_ = make_config();
  DeviceArray<Index> first_, column_; ///< of the matrix analysed
  Matrix matrix_;
  Data data_;
  bool analysed_ = false;
  bool deterministic_ = true; ///< the same bits every time
};

} // namespace

bool has_direct_solver() {
  return true;
}

std::unique_ptr<DirectSolver> make_direct_solver() {
  return std::make_unique<CudssSolver>();
}

} // namespace foam::cuda
