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

// The same where eight values do not begin at a multiple of 64 bytes.
typedef double Loose __attribute__((vector_size(64), may_alias, aligned(8)));
inline __attribute__((always_inline)) Loose &loose(double *p) {
  return *reinterpret_cast<Loose *>(p);
}
inline __attribute__((always_inline)) const Loose &loose(const double *p) {
  return *reinterpret_cast<const Loose *>(p);
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

// out[j] = - sum over i < rows of panel[i k + j] x[place[i]] for the `width` columns from `column` on, of which V times
// eight are read: what is read beyond them is left where it is. `chains` sums a column, so that additions overlap.
template <size_t V, size_t chains>
inline __attribute__((always_inline)) void minus_product(const double *panel, size_t rows, size_t k,
                                                         const unsigned *place, const double *x, size_t width,
                                                         double *out) {
  Eight s[chains][V] = {};
  size_t i = 0;
  for (; i + chains <= rows; i += chains)
    for (size_t c = 0; c < chains; ++c) {
      const double y = x[place[i + c]];
      for (size_t v = 0; v < V; ++v) s[c][v] -= loose(panel + (i + c) * k + 8 * v) * y;
    }
  for (size_t c = 0; i < rows; ++i, ++c) {
    const double y = x[place[i]];
    for (size_t v = 0; v < V; ++v) s[c][v] -= loose(panel + i * k + 8 * v) * y;
  }
  for (size_t c = 1; c < chains; ++c)
    for (size_t v = 0; v < V; ++v) s[0][v] += s[c][v];
  for (size_t v = 0; v < V; ++v)
    if (8 * v + 8 <= width)
      loose(out + 8 * v) = s[0][v];
    else
      for (size_t j = 8 * v; j < width; ++j) out[j] = s[0][v][j - 8 * v];
}

void minus_product(const double *panel, size_t rows, size_t k, const unsigned *place, const double *x, double *out) {
  size_t j = 0;
  for (; j + 32 <= k; j += 32) minus_product<4, 1>(panel + j, rows, k, place, x, 32, out + j);
  const size_t width = k - j;
  if (width > 24)
    minus_product<4, 1>(panel + j, rows, k, place, x, width, out + j);
  else if (width > 16)
    minus_product<3, 2>(panel + j, rows, k, place, x, width, out + j);
  else if (width > 8)
    minus_product<2, 2>(panel + j, rows, k, place, x, width, out + j);
  else if (width > 0)
    minus_product<1, 4>(panel + j, rows, k, place, x, width, out + j);
}

// Eight rows at a time, which is a line of each column.
void transpose(const double *columns, size_t stride, size_t rows, size_t k, double *out) {
  for (size_t i = 0; i < rows; i += 8) {
    const size_t end = i + 8 < rows ? i + 8 : rows;
    for (size_t j = 0; j < k; ++j)
      for (size_t r = i; r < end; ++r) out[r * k + j] = columns[r + j * stride];
  }
}

}  // namespace

extern const DenseKernels kernels;
const DenseKernels kernels = {eliminate, divide, transpose, minus_product};

}  // namespace ts::field::TS_KERNELS
