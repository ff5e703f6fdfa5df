// Compiled once for each kind of processor, under the name TS_KERNELS. Includes nothing that defines functions: the
// linker may keep any translation unit's copy of an inline function, and one with instructions of a newer processor
// would be the end on an older one.
#include "field/dense.h"

namespace ts::field::TS_KERNELS {
namespace {

using std::size_t;
typedef double Eight __attribute__((vector_size(64), may_alias));

inline __attribute__((always_inline)) Eight &at(double *p) {
  return *reinterpret_cast<Eight *>(p);
}
inline __attribute__((always_inline)) const Eight &at(const double *p) {
  return *reinterpret_cast<const Eight *>(p);
}

constexpr size_t kBlock = 64;  // pivots taken at a time: 64 columns of a front stay in the second cache

// C -= A B for rows [row, ld) of W columns of the front from `column` on: A the columns [from, to), B their rows
// column... W.
template <size_t W>
inline __attribute__((always_inline)) void subtract(double *f, size_t ld, size_t row, size_t column, size_t from,
                                                    size_t to) {
  size_t i = row;
  for (; i + 16 <= ld; i += 16) {
    Eight c[W][2];
    for (size_t q = 0; q < W; ++q) c[q][0] = at(f + i + (column + q) * ld), c[q][1] = at(f + i + 8 + (column + q) * ld);
    for (size_t p = from; p < to; ++p) {
      const double *a = f + p * ld;
      const Eight x = at(a + i), y = at(a + i + 8);
      for (size_t q = 0; q < W; ++q) {
        const double b = a[column + q];
        c[q][0] -= x * b;
        c[q][1] -= y * b;
      }
    }
    for (size_t q = 0; q < W; ++q) at(f + i + (column + q) * ld) = c[q][0], at(f + i + 8 + (column + q) * ld) = c[q][1];
  }
  for (; i < ld; i += 8) {
    Eight c[W];
    for (size_t q = 0; q < W; ++q) c[q] = at(f + i + (column + q) * ld);
    for (size_t p = from; p < to; ++p) {
      const double *a = f + p * ld;
      const Eight x = at(a + i);
      for (size_t q = 0; q < W; ++q) c[q] -= x * a[column + q];
    }
    for (size_t q = 0; q < W; ++q) at(f + i + (column + q) * ld) = c[q];
  }
}

void subtract(double *f, size_t ld, size_t column, size_t width, size_t from, size_t to) {
  const size_t row = column & ~size_t{7};
  switch (width) {
    case 1: return subtract<1>(f, ld, row, column, from, to);
    case 2: return subtract<2>(f, ld, row, column, from, to);
    case 3: return subtract<3>(f, ld, row, column, from, to);
    default: return subtract<4>(f, ld, row, column, from, to);
  }
}

// The columns [column, column + width), updated by all before them, become columns of the factor.
bool finish(double *f, size_t ld, size_t column, size_t width) {
  for (size_t j = column; j < column + width; ++j) {
    double *c = f + j * ld;
    if (!(c[j] > 0)) return false;
    const double root = __builtin_sqrt(c[j]), inverse = 1 / root;
    for (size_t i = j & ~size_t{7}; i < ld; i += 8) at(c + i) *= inverse;
    c[j] = root;
    for (size_t q = j + 1; q < column + width; ++q) {
      double *d = f + q * ld;
      const double b = c[q];
      for (size_t i = j & ~size_t{7}; i < ld; i += 8) at(d + i) -= at(c + i) * b;
    }
  }
  return true;
}

bool eliminate(double *f, size_t ld, size_t m, size_t k) {
  for (size_t block = 0; block < k; block += kBlock) {
    const size_t end = block + kBlock < k ? block + kBlock : k;
    for (size_t j = block; j < end; j += 4) {
      const size_t width = j + 4 < end ? 4 : end - j;
      subtract(f, ld, j, width, block, j);
      if (!finish(f, ld, j, width)) return false;
    }
    for (size_t j = end; j < m; j += 4) subtract(f, ld, j, j + 4 < m ? 4 : m - j, block, end);
  }
  return true;
}

// Columns [column, column + W) less what the later ones take of them, then through their own triangle.
template <size_t W>
inline __attribute__((always_inline)) void divide(double *panel, size_t rows, size_t column, size_t k, const double *l,
                                                  size_t ld, const double *inverse) {
  for (size_t i = 0; i < rows; i += 8) {
    Eight c[W];
    for (size_t q = 0; q < W; ++q) c[q] = at(panel + i + (column + q) * rows);
    for (size_t p = column + W; p < k; ++p) {
      const Eight x = at(panel + i + p * rows);
      for (size_t q = 0; q < W; ++q) c[q] -= x * l[p + (column + q) * ld];
    }
    for (size_t q = W; q-- > 0;) {
      for (size_t p = q + 1; p < W; ++p) c[q] -= c[p] * l[column + p + (column + q) * ld];
      c[q] *= inverse[column + q];
    }
    for (size_t q = 0; q < W; ++q) at(panel + i + (column + q) * rows) = c[q];
  }
}

void divide(double *panel, size_t rows, size_t k, const double *l, size_t ld, const double *inverse) {
  size_t column = k;
  for (; column >= 4; column -= 4) divide<4>(panel, rows, column - 4, k, l, ld, inverse);
  while (column-- > 0) divide<1>(panel, rows, column, k, l, ld, inverse);
}

inline __attribute__((always_inline)) double sum(const Eight &s) {
  return ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]));
}

// The same sums of four at once, added up in the same order.
inline __attribute__((always_inline)) void sums(const Eight *s, double *t) {
  typedef double Four __attribute__((vector_size(32)));
  Four h[4];
  for (size_t q = 0; q < 4; ++q)
    h[q] = __builtin_shufflevector(s[q], s[q], 0, 1, 2, 3) + __builtin_shufflevector(s[q], s[q], 4, 5, 6, 7);
  const Four a = __builtin_shufflevector(h[0], h[1], 0, 1, 4, 5) + __builtin_shufflevector(h[0], h[1], 2, 3, 6, 7);
  const Four b = __builtin_shufflevector(h[2], h[3], 0, 1, 4, 5) + __builtin_shufflevector(h[2], h[3], 2, 3, 6, 7);
  const Four all = __builtin_shufflevector(a, b, 0, 2, 4, 6) + __builtin_shufflevector(a, b, 1, 3, 5, 7);
  for (size_t q = 0; q < 4; ++q) t[q] = all[q];
}

void minus_dots(const double *panel, size_t rows, size_t k, const double *x, double *t) {
  size_t j = 0;
  for (; j + 4 <= k; j += 4) {
    const double *p = panel + j * rows;
    Eight s[4] = {};
    for (size_t i = 0; i < rows; i += 8) {
      const Eight y = at(x + i);
      for (size_t q = 0; q < 4; ++q) s[q] -= at(p + i + q * rows) * y;
    }
    sums(s, t + j);
  }
  for (; j < k; ++j) {
    const double *p = panel + j * rows;
    Eight s = {};
    for (size_t i = 0; i < rows; i += 8) s -= at(p + i) * at(x + i);
    t[j] = sum(s);
  }
}

}  // namespace

extern const DenseKernels kernels;
const DenseKernels kernels = {eliminate, divide, minus_dots};

}  // namespace ts::field::TS_KERNELS
