// SPDX-License-Identifier: GPL-3.0-or-later
//
// As much of NVIDIA's cuDSS as cuda/ calls, with the processor's memory for the device's and core's
// dense elimination for its factorisation: what uses it runs, and is tested, without it. It takes
// nothing that is not in order: neither entries beyond the diagonal nor columns that do not ascend,
// nor another matrix than the one analysed.
#pragma once

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "algebra/dense_elimination.h"

/// What tests make of it, and what they ask it.
namespace cudss_emulation {

inline int analyses = 0;
inline int factorisations = 0;
inline int objects = 0; ///< that have been made and not been destroyed
inline bool offers_determinism = true;
inline int failing_phase = 0;

} // namespace cudss_emulation

enum cudssStatus_t {
  CUDSS_STATUS_SUCCESS,
  CUDSS_STATUS_NOT_INITIALIZED,
  CUDSS_STATUS_ALLOC_FAILED,
  CUDSS_STATUS_INVALID_VALUE,
  CUDSS_STATUS_NOT_SUPPORTED,
  CUDSS_STATUS_EXECUTION_FAILED
};
enum cudssPhase_t {
  CUDSS_PHASE_ANALYSIS = 1,
  CUDSS_PHASE_FACTORIZATION = 2,
  CUDSS_PHASE_SOLVE = 4
};
enum cudssConfigParam_t { CUDSS_CONFIG_DETERMINISTIC_MODE };
enum cudssDataType_t { CUDSS_R_32I, CUDSS_R_64F };
enum cudssMatrixType_t { CUDSS_MTYPE_SYMMETRIC };
enum cudssMatrixViewType_t { CUDSS_MVIEW_LOWER };
enum cudssIndexBase_t { CUDSS_BASE_ZERO };
enum cudssLayout_t { CUDSS_LAYOUT_COL_MAJOR };

struct cudssContext {};
struct cudssConfig {
  bool deterministic = false;
};
struct cudssMatrix {
  std::size_t rows = 0;
  std::span<const std::int32_t> first, column; ///< none of a vector
  const double* values = nullptr;
};
struct cudssData {
  std::vector<std::int32_t> first, column; ///< of the matrix analysed
  std::vector<double> factor, pivots;
};
using cudssHandle_t = cudssContext*;
using cudssConfig_t = cudssConfig*;
using cudssMatrix_t = cudssMatrix*;
using cudssData_t = cudssData*;

namespace cudss_emulation {

template <class T> cudssStatus_t make(T** made, const T& value = {}) {
  *made = new T(value);
  ++objects;
  return CUDSS_STATUS_SUCCESS;
}
template <class T> cudssStatus_t destroy(T* made) {
  delete made;
  --objects;
  return CUDSS_STATUS_SUCCESS;
}

/// Whether each row ends on the diagonal, its columns ascending.
inline bool is_lower_triangle(const cudssMatrix& m) {
  for (std::size_t row = 0; row < m.rows; ++row) {
    const auto begin = m.column.begin() + m.first[row];
    const auto end = m.column.begin() + m.first[row + 1];
    if (begin >= end || *(end - 1) != static_cast<std::int32_t>(row) ||
        std::adjacent_find(begin, end, std::greater_equal<>()) != end) {
      return false;
    }
  }
  return true;
}

inline cudssStatus_t analyse(const cudssConfig& config, cudssData& data, const cudssMatrix& m) {
  ++analyses;
  if (config.deterministic && !offers_determinism) {
    return CUDSS_STATUS_NOT_SUPPORTED;
  }
  data.first.assign(m.first.begin(), m.first.end());
  data.column.assign(m.column.begin(), m.column.end());
  return is_lower_triangle(m) ? CUDSS_STATUS_SUCCESS : CUDSS_STATUS_INVALID_VALUE;
}

inline cudssStatus_t factorise(cudssData& data, const cudssMatrix& m) {
  ++factorisations;
  if (!std::ranges::equal(data.first, m.first) || !std::ranges::equal(data.column, m.column)) {
    return CUDSS_STATUS_INVALID_VALUE;
  }
  data.factor.assign(m.rows * m.rows, 0);
  data.pivots.resize(m.rows);
  for (std::size_t row = 0; row < m.rows; ++row) {
    for (std::int32_t k = m.first[row]; k < m.first[row + 1]; ++k) {
      data.factor[static_cast<std::size_t>(m.column[static_cast<std::size_t>(k)]) * m.rows + row] =
          m.values[k];
    }
  }
  foam::eliminate_densely(data.factor, {}, data.pivots, 0);
  return CUDSS_STATUS_SUCCESS;
}

inline cudssStatus_t solve(const cudssData& data, const cudssMatrix& x, const cudssMatrix& b) {
  const std::span<double> solution(const_cast<double*>(x.values), x.rows);
  std::copy_n(b.values, b.rows, solution.begin());
  foam::solve_lower(data.factor, solution);
  for (std::size_t i = 0; i < solution.size(); ++i) {
    solution[i] /= data.pivots[i];
  }
  foam::solve_upper(data.factor, solution);
  return CUDSS_STATUS_SUCCESS;
}

} // namespace cudss_emulation

inline cudssStatus_t cudssCreate(cudssHandle_t* handle) {
  return cudss_emulation::make(handle);
}
inline cudssStatus_t cudssDestroy(cudssHandle_t handle) {
  return cudss_emulation::destroy(handle);
}
inline cudssStatus_t cudssConfigCreate(cudssConfig_t* config) {
  return cudss_emulation::make(config);
}
inline cudssStatus_t cudssConfigSet(cudssConfig_t config, cudssConfigParam_t /*parameter*/,
                                    const void* value, std::size_t size) {
  if (size != sizeof(int)) {
    return CUDSS_STATUS_INVALID_VALUE;
  }
  config->deterministic = *static_cast<const int*>(value) != 0;
  return CUDSS_STATUS_SUCCESS;
}
inline cudssStatus_t cudssConfigDestroy(cudssConfig_t config) {
  return cudss_emulation::destroy(config);
}
inline cudssStatus_t cudssDataCreate(cudssHandle_t /*handle*/, cudssData_t* data) {
  return cudss_emulation::make(data);
}
inline cudssStatus_t cudssDataDestroy(cudssHandle_t handle, cudssData_t data) {
  return handle == nullptr ? CUDSS_STATUS_NOT_INITIALIZED : cudss_emulation::destroy(data);
}
inline cudssStatus_t
cudssMatrixCreateCsr(cudssMatrix_t* matrix, std::int64_t rows, std::int64_t columns,
                     std::int64_t entries, const void* first, const void* end, const void* column,
                     const void* values, cudssDataType_t offset_type, cudssDataType_t index_type,
                     cudssDataType_t value_type, cudssMatrixType_t /*type*/,
                     cudssMatrixViewType_t /*view*/, cudssIndexBase_t /*base*/) {
  if (rows != columns || end != nullptr || offset_type != CUDSS_R_32I ||
      index_type != CUDSS_R_32I || value_type != CUDSS_R_64F) {
    return CUDSS_STATUS_INVALID_VALUE;
  }
  const auto count = static_cast<std::size_t>(rows);
  return cudss_emulation::make(
      matrix,
      cudssMatrix{count,
                  {static_cast<const std::int32_t*>(first), count + 1},
                  {static_cast<const std::int32_t*>(column), static_cast<std::size_t>(entries)},
                  static_cast<const double*>(values)});
}
inline cudssStatus_t cudssMatrixCreateDn(cudssMatrix_t* matrix, std::int64_t rows,
                                         std::int64_t columns, std::int64_t stride,
                                         const void* values, cudssDataType_t type,
                                         cudssLayout_t /*layout*/) {
  if (columns != 1 || stride < rows || type != CUDSS_R_64F) {
    return CUDSS_STATUS_INVALID_VALUE;
  }
  return cudss_emulation::make(
      matrix,
      cudssMatrix{static_cast<std::size_t>(rows), {}, {}, static_cast<const double*>(values)});
}
inline cudssStatus_t cudssMatrixSetValues(cudssMatrix_t matrix, const void* values) {
  matrix->values = static_cast<const double*>(values);
  return CUDSS_STATUS_SUCCESS;
}
inline cudssStatus_t cudssMatrixDestroy(cudssMatrix_t matrix) {
  return cudss_emulation::destroy(matrix);
}
inline cudssStatus_t cudssExecute(cudssHandle_t /*handle*/, int phase, cudssConfig_t config,
                                  cudssData_t data, cudssMatrix_t matrix, cudssMatrix_t solution,
                                  cudssMatrix_t right) {
  if (phase == cudss_emulation::failing_phase) {
    return CUDSS_STATUS_EXECUTION_FAILED;
  }
  switch (phase) {
  case CUDSS_PHASE_ANALYSIS:
    return cudss_emulation::analyse(*config, *data, *matrix);
  case CUDSS_PHASE_FACTORIZATION:
    return cudss_emulation::factorise(*data, *matrix);
  default:
    return cudss_emulation::solve(*data, *solution, *right);
  }
}
