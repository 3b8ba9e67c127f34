// SPDX-License-Identifier: GPL-3.0-or-later
//
// Products are made of tiles that are summed in registers, from copies of rows that lie in memory
// as they are needed (K. Goto, R. A. van de Geijn, ACM Trans. Math. Softw. 34 (2008) 12). Every
// entry is the sum of its products in their order.
#include "algebra/dense_elimination.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <utility>
#include <vector>

#define FOAM_INLINE inline __attribute__((always_inline))

namespace foam {
namespace {

// Consecutive rows, as many as a processor's registers hold; the methods are templates of it.
using Pack2 = double __attribute__((vector_size(16)));
using Pack4 = double __attribute__((vector_size(32)));
using Pack8 = double __attribute__((vector_size(64)));
// As many in single precision.
template <class Pack> struct Single;
template <> struct Single<Pack2> { using Pack = float __attribute__((vector_size(8))); };
template <> struct Single<Pack4> { using Pack = float __attribute__((vector_size(16))); };
template <> struct Single<Pack8> { using Pack = float __attribute__((vector_size(32))); };

constexpr std::size_t kTileRows = 8;
constexpr std::size_t kTileColumns = 6;
constexpr std::size_t kDepth = 256; // pivots at a time, so that the copies stay in the cache
constexpr std::size_t kRows = 96;   // rows at a time, likewise
constexpr std::size_t kBlock = 16;  // pivots that are eliminated one by one

template <class Pack> constexpr std::size_t kWidth = sizeof(Pack) / sizeof(double);

template <class Pack> FOAM_INLINE void load(const double* from, Pack& pack) {
  std::memcpy(&pack, from, sizeof pack);
}

template <class Pack> FOAM_INLINE void load(const float* from, Pack& pack) {
  typename Single<Pack>::Pack rounded;
  std::memcpy(&rounded, from, sizeof rounded);
  pack = __builtin_convertvector(rounded, Pack);
}

/// A matrix in memory, column by column.
struct Block {
  double* entries;
  std::size_t rows, columns;
  std::size_t stride; ///< from one column to the next

  FOAM_INLINE double* column(std::size_t j) const { return entries + j * stride; }
};

/// Copies rows [begin, begin + width) of a block's columns, those past its end as 0, times a factor
/// for each column.
template <std::size_t width, class Factor>
FOAM_INLINE void copy_rows(const Block& block, std::size_t begin, const Factor& factor,
                           std::size_t depth, double* to) {
  const std::size_t there = std::min(width, block.rows - begin);
  for (std::size_t k = 0; k < depth; ++k, to += width) {
    const double* const from = block.column(k) + begin;
    const double times = factor(k);
    for (std::size_t i = 0; i < there; ++i) {
      to[i] = times * from[i];
    }
    for (std::size_t i = there; i < width; ++i) {
      to[i] = 0;
    }
  }
}

/// tile = A·Bᵀ of copied rows.
template <class Pack>
FOAM_INLINE void multiply_tile(const double* a, const double* b, std::size_t depth, double* tile) {
  constexpr std::size_t packs = kTileRows / kWidth<Pack>;
  Pack sums[kTileColumns][packs] = {};
  for (std::size_t k = 0; k < depth; ++k) {
    Pack rows[packs];
    for (std::size_t i = 0; i < packs; ++i) {
      load(a + k * kTileRows + i * kWidth<Pack>, rows[i]);
    }
    for (std::size_t j = 0; j < kTileColumns; ++j) {
      for (std::size_t i = 0; i < packs; ++i) {
        sums[j][i] += rows[i] * b[k * kTileColumns + j];
      }
    }
  }
  std::memcpy(tile, sums, sizeof sums);
}

/// C −= L·D·Mᵀ on and below the diagonal of C, and a little above it, M being the first rows of L.
template <class Pack>
FOAM_INLINE void subtract_product(const Block& l, const double* d, const Block& c) {
  thread_local std::vector<double> a_copy(kRows * kDepth);
  thread_local std::vector<double> b_copy;
  const std::size_t tiles = (c.columns + kTileColumns - 1) / kTileColumns;
  for (std::size_t first = 0; first < l.columns; first += kDepth) {
    const std::size_t depth = std::min(kDepth, l.columns - first);
    const Block part{l.column(first), l.rows, depth, l.stride};
    b_copy.resize(std::max(b_copy.size(), tiles * kTileColumns * depth));
    for (std::size_t tile = 0; tile < tiles; ++tile) {
      copy_rows<kTileColumns>(
          part, tile * kTileColumns, [&](std::size_t k) { return d[first + k]; }, depth,
          &b_copy[tile * kTileColumns * depth]);
    }
    for (std::size_t top = 0; top < c.rows; top += kRows) {
      const std::size_t bottom = std::min(top + kRows, c.rows);
      for (std::size_t row = top; row < bottom; row += kTileRows) {
        copy_rows<kTileRows>(
            part, row, [](std::size_t) { return 1.0; }, depth, &a_copy[(row - top) * depth]);
      }
      for (std::size_t tile = 0; tile < tiles && tile * kTileColumns < bottom; ++tile) {
        const std::size_t left = tile * kTileColumns;
        const std::size_t right = std::min(left + kTileColumns, c.columns);
        for (std::size_t row = std::max(top, left / kTileRows * kTileRows); row < bottom;
             row += kTileRows) {
          alignas(Pack8) double sums[kTileRows * kTileColumns];
          multiply_tile<Pack>(&a_copy[(row - top) * depth], &b_copy[left * depth], depth, sums);
          const std::size_t height = std::min(kTileRows, c.rows - row);
          for (std::size_t j = left; j < right; ++j) {
            double* const entries = c.column(j) + row;
            const double* const sum = sums + (j - left) * kTileRows;
            for (std::size_t i = 0; i < height; ++i) {
              entries[i] -= sum[i];
            }
          }
        }
      }
    }
  }
}

/// Eliminates the unknowns of a few columns one after the other. \returns false if a pivot is too
/// small.
FOAM_INLINE bool eliminate_columns(const Block& block, double* pivots, double least) {
  for (std::size_t k = 0; k < block.columns; ++k) {
    double* const column = block.column(k);
    const double pivot = column[k];
    if (!(std::abs(pivot) > least)) {
      return false;
    }
    pivots[k] = pivot;
    for (std::size_t j = k + 1; j < block.columns; ++j) {
      double* const other = block.column(j);
      const double factor = column[j] / pivot;
      for (std::size_t i = j; i < block.rows; ++i) {
        other[i] -= factor * column[i];
      }
    }
    for (std::size_t i = k + 1; i < block.rows; ++i) {
      column[i] /= pivot;
    }
  }
  return true;
}

template <class Pack>
FOAM_INLINE bool eliminate(std::span<double> columns, std::span<double> rest,
                           std::span<double> pivots, double least) {
  const std::size_t count = pivots.size();
  if (count == 0) {
    return true;
  }
  const std::size_t size = columns.size() / count;
  const auto from = [&](std::size_t k, std::size_t width) {
    return Block{&columns[k * size + k], size - k, width, size};
  };
  for (std::size_t k = 0; k < count; k += kBlock) {
    const std::size_t width = std::min(kBlock, count - k);
    if (!eliminate_columns(from(k, width), &pivots[k], least)) {
      return false;
    }
    const std::size_t next = k + width;
    if (next < count) {
      subtract_product<Pack>({&columns[k * size + next], size - next, width, size}, &pivots[k],
                             from(next, count - next));
    }
  }
  if (count < size) {
    const std::size_t left = size - count;
    subtract_product<Pack>({&columns[count], left, count, size}, pivots.data(),
                           {rest.data(), left, left, left});
  }
  return true;
}

/// Products of `columns` columns, one after the other in memory, with one vector, in `result`.
template <class Pack, std::size_t columns, class Entry>
FOAM_INLINE void products(const Entry* first, std::size_t stride, const double* with,
                          std::size_t size, double* result) {
  constexpr std::size_t packs = kTileRows / kWidth<Pack>;
  Pack sums[columns][packs] = {};
  std::size_t i = 0;
  for (; i + kTileRows <= size; i += kTileRows) {
    for (std::size_t p = 0; p < packs; ++p) {
      Pack x;
      load(with + i + p * kWidth<Pack>, x);
      for (std::size_t k = 0; k < columns; ++k) {
        Pack y;
        load(first + k * stride + i + p * kWidth<Pack>, y);
        sums[k][p] += x * y;
      }
    }
  }
  for (std::size_t k = 0; k < columns; ++k) {
    double sum = 0;
    for (std::size_t j = i; j < size; ++j) {
      sum += first[k * stride + j] * with[j];
    }
    double partial[kTileRows];
    std::memcpy(partial, sums[k], sizeof partial);
    for (const double part : partial) {
      sum += part;
    }
    result[k] = sum;
  }
}

/// to −= Σ factor·column, of `columns` columns.
template <std::size_t columns, class Entry>
FOAM_INLINE void subtract_columns(const Entry* first, std::size_t stride, const double* factor,
                                  std::size_t size, double* to) {
  for (std::size_t i = 0; i < size; ++i) {
    double sum = 0;
    for (std::size_t k = 0; k < columns; ++k) {
      sum += factor[k] * first[k * stride + i];
    }
    to[i] -= sum;
  }
}

constexpr std::size_t kTogether = 4; // columns that share the loading of a vector

template <class Entry> FOAM_INLINE void lower(std::span<const Entry> columns, std::span<double> x) {
  const std::size_t size = x.size();
  const std::size_t count = columns.empty() ? 0 : columns.size() / size;
  const auto column = [&](std::size_t k) { return columns.data() + k * size; };
  std::size_t k = 0;
  for (; k + kTogether <= count; k += kTogether) {
    const std::size_t next = k + kTogether;
    for (std::size_t i = k; i < next; ++i) {
      subtract_columns<1>(column(i) + i + 1, size, &x[i], next - i - 1, x.data() + i + 1);
    }
    subtract_columns<kTogether>(column(k) + next, size, &x[k], size - next, x.data() + next);
  }
  for (; k < count; ++k) {
    subtract_columns<1>(column(k) + k + 1, size, &x[k], size - k - 1, x.data() + k + 1);
  }
}

template <class Pack, class Entry>
FOAM_INLINE void upper(std::span<const Entry> columns, std::span<double> x) {
  const std::size_t size = x.size();
  const std::size_t count = columns.empty() ? 0 : columns.size() / size;
  const auto column = [&](std::size_t k) { return columns.data() + k * size; };
  double sums[kTogether];
  std::size_t k = count;
  for (; k % kTogether != 0; --k) {
    products<Pack, 1>(column(k - 1) + k, size, x.data() + k, size - k, sums);
    x[k - 1] -= sums[0];
  }
  for (; k > 0; k -= kTogether) {
    const std::size_t first = k - kTogether;
    products<Pack, kTogether>(column(first) + k, size, x.data() + k, size - k, sums);
    for (std::size_t j = 0; j < kTogether; ++j) {
      x[first + j] -= sums[j];
    }
    for (std::size_t i = k - 1; i > first; --i) {
      for (std::size_t j = first; j < i; ++j) {
        x[j] -= column(j)[i] * x[i];
      }
    }
  }
}

/// All of it for one kind of processor.
#define FOAM_DEFINE(kind, Pack)                                                                    \
  bool eliminate_##kind(std::span<double> columns, std::span<double> rest,                         \
                        std::span<double> pivots, double least) {                                  \
    return eliminate<Pack>(columns, rest, pivots, least);                                          \
  }                                                                                                \
  template <class Entry> void lower_##kind(std::span<const Entry> columns, std::span<double> x) {  \
    lower(columns, x);                                                                             \
  }                                                                                                \
  template <class Entry> void upper_##kind(std::span<const Entry> columns, std::span<double> x) {  \
    upper<Pack>(columns, x);                                                                       \
  }

FOAM_DEFINE(any, Pack2)
#if defined(__x86_64__) && !defined(__clang__)
#pragma GCC push_options
#pragma GCC target("avx2")
FOAM_DEFINE(avx2, Pack4)
#pragma GCC pop_options
#pragma GCC push_options
#pragma GCC target("avx512f")
FOAM_DEFINE(avx512, Pack8)
#pragma GCC pop_options
#define FOAM_CHOOSE(function, ...)                                                                 \
  (__builtin_cpu_supports("avx512f") ? function##_avx512(__VA_ARGS__)                              \
   : __builtin_cpu_supports("avx2")  ? function##_avx2(__VA_ARGS__)                                \
                                     : function##_any(__VA_ARGS__))
#else
#define FOAM_CHOOSE(function, ...) function##_any(__VA_ARGS__)
#endif

} // namespace

bool eliminate_densely(std::span<double> columns, std::span<double> rest, std::span<double> pivots,
                       double least) {
  return FOAM_CHOOSE(eliminate, columns, rest, pivots, least);
}

void solve_lower(std::span<const double> columns, std::span<double> x) {
  FOAM_CHOOSE(lower, columns, x);
}

void solve_lower(std::span<const float> columns, std::span<double> x) {
  FOAM_CHOOSE(lower, columns, x);
}

void solve_upper(std::span<const double> columns, std::span<double> x) {
  FOAM_CHOOSE(upper, columns, x);
}

void solve_upper(std::span<const float> columns, std::span<double> x) {
  FOAM_CHOOSE(upper, columns, x);
}

} // namespace foam
